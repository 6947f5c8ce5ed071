"""Whole tasks that are stopped at some instant: what is said, and what goes wrong on the way.

A skill joins by one course in ``CYCLE``, and by its places in ``PHASES``.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import partial
from types import MappingProxyType

import numpy as np

from executive.meaning import Command
from executive.session.assembly import Assembly, assemble
from executive.session.events import Event
from executive.understanding.command_parser import parse
from kinematics.geometry import poses
from robots.scenes.scene_description import SceneDescription
from tools.evaluate.faults import FAULTS, FaultBench, FaultState
from tools.evaluate.opening.scenes import BENCH_DRAWERS, opening_scene
from tools.evaluate.phases import PhaseWatch
from tools.evaluate.scenes import (
    BENCH,
    LOW_TABLE,
    SENTENCE,
    TARGET,
    bench_pick,
    episode_rng,
    pick_scene,
    read_episode_scene,
)
from tools.evaluate.skills import rooms
from tools.evaluate.skills.gestures import point_trial, wave_trial
from tools.evaluate.skills.placing import place_trial
from tools.evaluate.skills.putting_in_fridge import put_in_fridge_trial
from tools.evaluate.skills.suite import Trial
from tools.evaluate.skills.walking import LOW_PACES, stop_trial
from trees.tasks import MoveTask, ObjectDescription, OpenTask

HOLD_S = 2.0
"""The robot holds for this long after each task."""

MOVING_PHASES = ("reach", "approach", "lift", "recover", "gesture", "place", "open")
"""An arm moves at the instants that are drawn in these."""
WALK = "walk"
STILL_PHASES = ("search", "close", "hold", WALK)

PICKED_M = 0.10
HOME_RAD = 0.05
TURNED_RAD = 0.5

Truly = Callable[[Assembly], bool]


@dataclass(frozen=True, slots=True)
class Script:
    """What happens in one run.

    Attributes:
        scene: The world.
        commands: Carried out one after the other.
        prepare: Called once before the first of them.
    """

    scene: SceneDescription
    commands: tuple[Command, ...]
    prepare: Callable[[Assembly], None] = lambda _assembly: None


@dataclass(frozen=True, slots=True)
class Again:
    """What is asked for after a cancel, and how the truth judges it.

    Attributes:
        command: The command.
        truly: Whether it was really done.
    """

    command: Command
    truly: Truly


@dataclass(frozen=True, slots=True)
class Course:
    """One way through some tasks.

    Attributes:
        name: For tables.
        script: Makes the run of a seed.
        fault: What goes wrong on the way, or None.
        wanted: Phases in which it is stopped; as often as they are named.
        again: Asked for after a cancel, besides going home, when the hands are free.
    """

    name: str
    script: Callable[[int], Script]
    fault: str | None
    wanted: tuple[str, ...]
    again: Again


def _said(*sentences: str) -> tuple[Command, ...]:
    return tuple(command for sentence in sentences for command in parse(sentence).commands)


def _table(seed: int) -> Script:
    scene = read_episode_scene(pick_scene(seed), seed)
    return Script(scene, _said(SENTENCE, "go home"))


def _bench(seed: int) -> Script:
    return Script(read_episode_scene(bench_pick(seed), seed), _said(SENTENCE, "go home"))


def _bench_drawer(seed: int) -> Script:
    scene = opening_scene(seed, "open", where=BENCH_DRAWERS)
    return Script(scene.read(), (OpenTask("open it", ObjectDescription(kind="drawer")),))


def _of_trial(trial: Callable[[np.random.Generator], Trial]) -> Callable[[int], Script]:
    def script(seed: int) -> Script:
        made = trial(episode_rng(seed, 10))
        return Script(made.scene, made.tasks)

    return script


def _low_table(seed: int) -> Script:
    return Script(read_episode_scene(bench_pick(seed, where=rooms.LOW), seed), _said(SENTENCE, "go home"))


def _low_gesture(seed: int) -> Script:
    return _of_trial(partial(point_trial if seed % 2 else wave_trial, where=rooms.LOW))(seed)


def _gesture(seed: int) -> Script:
    return _of_trial(point_trial if seed % 2 else wave_trial)(seed)


def _open(seed: int) -> Script:
    scene = opening_scene(seed, "open")

    def misplace(assembly: Assembly) -> None:
        faults = assembly.perception.faults
        faults.misplace("handle", scene.handle_error_m, first_look_only=False)
        faults.misplace(scene.kind, scene.panel_error_m, first_look_only=False)

    noun = ObjectDescription(kind="fridge" if scene.kind == "door" else "drawer")
    return Script(scene.read(), (OpenTask("open it", noun),), misplace)


def _open_fridge(seed: int) -> Script:
    made = put_in_fridge_trial(episode_rng(seed, 10), always_open=True)
    return Script(made.scene, (*made.first, *made.tasks))


def _picked(assembly: Assembly) -> bool:
    return assembly.world.truth.lift_m(TARGET) >= PICKED_M


def _home(assembly: Assembly) -> bool:
    truth, model = assembly.world.truth, assembly.model
    home = np.array([model.description.home[name] for name in model.joints])
    return bool(np.abs(truth.joint_positions()[: len(home)] - home).max() <= HOME_RAD)


def _turn(assembly: Assembly) -> Truly:
    """Judges a turn that begins now."""
    began = poses.yaw_of(assembly.world.truth.world_T_base()[:3, :3])

    def truly(later: Assembly) -> bool:
        turned = poses.yaw_of(later.world.truth.world_T_base()[:3, :3]) - began
        return math.remainder(turned, 2.0 * math.pi) >= TURNED_RAD

    return truly


GO_HOME = Again(_said("go home")[0], _home)
_PICK = Again(_said(SENTENCE)[0], _picked)
_TURN = Again(MoveTask("turn left", 0.0, 0.5, 3.0), lambda _assembly: False)


def next_after(course: Course, assembly: Assembly, again: bool) -> Again:
    """What is asked for after a cancel; ``again`` only where the hands are free."""
    chosen = course.again if again else GO_HOME
    if chosen is _TURN:
        return Again(chosen.command, _turn(assembly))
    return chosen


PICK = Course("pick, hold, go home", _table, None, ("reach", "approach", "close", "hold", "lift"), _PICK)
MOVED = Course(
    "pick, the cup moves, recover", _table, "moved", ("reach", "recover", "search", "approach", "lift"), _PICK
)
WALKING = Course("walk", _of_trial(stop_trial), None, (WALK,) * 4, _TURN)
GESTURE = Course("wave, point", _gesture, None, ("gesture",) * 5, GO_HOME)
PLACING = Course("pick, place", _of_trial(place_trial), None, ("place",) * 5, GO_HOME)
OPENING = Course("open", _open, None, ("open",) * 5, GO_HOME)

FRIDGE = Course(
    "put into a fridge", _open_fridge, None, (WALK, "place", "reach", "place", WALK, "place", "lift"), GO_HOME
)

BENCH_PICK = replace(PICK, name="pick on a bench", script=_bench)
BENCH_PLACING = replace(
    PLACING, name="place on a bench", script=_of_trial(partial(place_trial, where=rooms.BENCH))
)
BENCH_POINTING = replace(
    GESTURE,
    name="point on a bench",
    script=_of_trial(partial(point_trial, where=rooms.BENCH)),
    wanted=("gesture",) * 3,
)
BENCH_OPENING = replace(OPENING, name="open a drawer", script=_bench_drawer)
BENCH_CYCLE = (BENCH_PICK, BENCH_PLACING, BENCH_OPENING, BENCH_POINTING)
"""Of an arm that is bolted down."""

LOW_PICK = replace(PICK, name="pick from a low table", script=_low_table)
LOW_MOVED = replace(MOVED, name="the cup moves on a low table, recover", script=_low_table)
LOW_PLACING = replace(
    PLACING, name="place on a low table", script=_of_trial(partial(place_trial, where=rooms.LOW))
)
LOW_WALKING = replace(
    WALKING, name="walk of a small body", script=_of_trial(lambda rng: stop_trial(rng, LOW_PACES))
)
LOW_GESTURE = replace(GESTURE, name="wave, point at a low table", script=_low_gesture)
LOW_CYCLE = (LOW_WALKING, *(LOW_PICK, LOW_PLACING, LOW_MOVED, LOW_GESTURE) * 2)
"""Of a humanoid of a child's size."""

CYCLE = (PICK, PLACING, WALKING, OPENING, MOVED, GESTURE, *(PICK, MOVED) * 3)
"""Runs of one evaluation, over and over: each phase in a fifteenth of the instants, and an arm moves in more
than seven of ten."""

PICKS: Mapping[str | None, Course] = MappingProxyType({None: PICK, BENCH: BENCH_PICK, LOW_TABLE: LOW_PICK})
"""Of picking, by the scene of the robot's own size; None is the usual table."""

CYCLES = {BENCH: BENCH_CYCLE, LOW_TABLE: LOW_CYCLE}
"""By the scene that is named; any other has ``CYCLE``."""

COURSES = (*CYCLE, FRIDGE, *BENCH_CYCLE, *LOW_CYCLE)
"""All there are. Those outside the cycle run when they are asked for by ``COURSES_BY_NAME``."""

COURSES_BY_NAME = {"put_in_fridge": COURSES.index(FRIDGE)}

PHASES = (
    ("open or close", "open"),
    ("transfer", "place"),
    ("lower", "place"),
    ("let go", "place"),
    ("draw back", "place"),
    ("raise hand", "gesture"),
    ("swing hand", "gesture"),
    ("lower hand", "gesture"),
    ("stretch arm", "gesture"),
    ("lower arm", "gesture"),
    ("recover", "recover"),
    ("give up", "recover"),
    ("go home", "recover"),
    ("search", "search"),
    ("reach", "reach"),
    ("confirm", "reach"),
    ("approach", "approach"),
    ("grasp", "close"),
    ("lift", "lift"),
    ("move", WALK),
    ("walk", WALK),
)
"""Part of a place in the tree, and the phase that it belongs to; the first that fits counts."""


def phase_of(where: str) -> str:
    """The phase of a place in the tree."""
    parts = where.split("/")
    return next((phase for part, phase in PHASES if part in parts), "plan")


class CourseRun:
    """One run of a course, from its beginning; the same seed gives the same run.

    Attributes:
        assembly: Robot and world.
        stopped: Set by whoever stops the run: it ends after the task that is under way.
    """

    def __init__(self, course: Course, seed: int, robot: str, sink: Callable[[Event], None]) -> None:
        phases = PhaseWatch()

        def take(event: Event) -> None:
            phases.take(event)
            sink(event)

        script = course.script(seed)
        self._commands = script.commands
        self.assembly: Assembly = assemble(robot, script.scene, seed, sink=take)
        self.stopped = False
        script.prepare(self.assembly)
        if course.fault is not None:
            world = self.assembly.world
            bench = FaultBench(
                TARGET,
                script.scene,
                world.truth,
                world.faults,
                self.assembly.perception,
                phases,
                episode_rng(seed, 2),
            )
            FAULTS[course.fault](bench, FaultState())

    def run(self) -> None:
        """Carry out one command after the other."""
        session = self.assembly.session
        for command in self._commands:
            session.run_task(command)
            if not self.stopped:
                session.hold(HOLD_S)
            if self.stopped:
                return
