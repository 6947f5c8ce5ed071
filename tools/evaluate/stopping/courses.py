"""Whole tasks that are stopped at some instant: what is said, and what goes wrong on the way.

A skill joins by one row in ``COURSES``, and by its places in ``PHASES``.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from executive.assembly import Assembly, assemble
from executive.command_parser import parse
from executive.events import Event
from robots.scene_description import SceneDescription
from tools.evaluate.faults import FAULTS, FaultBench, FaultState
from tools.evaluate.phases import PhaseWatch
from tools.evaluate.scenes import SENTENCE, TARGET, episode_rng, pick_scene, read_episode_scene

HOLD_S = 2.0
"""The robot holds for this long after each task."""

MOVING_PHASES = ("reach", "approach", "lift", "recover")
STILL_PHASES = ("search", "close", "hold")


@dataclass(frozen=True, slots=True)
class Course:
    """One way through some tasks.

    Attributes:
        name: For tables.
        sentences: What is said, one after the other.
        scene: Makes the scene of a seed.
        fault: What goes wrong on the way, or None.
        wanted: Phases in which it is stopped; as often as they are named.
    """

    name: str
    sentences: tuple[str, ...]
    scene: Callable[[int], SceneDescription]
    fault: str | None
    wanted: tuple[str, ...]


def _table_scene(seed: int) -> SceneDescription:
    return read_episode_scene(pick_scene(seed), seed)


# Five and six of seven while the arms move; still phases once each in fourteen.
COURSES = (
    Course(
        "pick, hold, go home",
        (SENTENCE, "go home"),
        _table_scene,
        None,
        ("reach", "approach", "close", "lift", "hold", "recover", "reach"),
    ),
    Course(
        "pick, the cup moves, recover",
        (SENTENCE, "go home"),
        _table_scene,
        "moved",
        ("reach", "recover", "search", "approach", "lift", "recover", "lift"),
    ),
)

PHASES = (
    ("recover", "recover"),
    ("give up", "recover"),
    ("go home", "recover"),
    ("search", "search"),
    ("reach", "reach"),
    ("confirm", "reach"),
    ("approach", "approach"),
    ("grasp", "close"),
    ("lift", "lift"),
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
        self._course = course
        phases = PhaseWatch()

        def take(event: Event) -> None:
            phases.take(event)
            sink(event)

        scene = course.scene(seed)
        self.assembly: Assembly = assemble(robot, scene, seed, sink=take)
        self.stopped = False
        if course.fault is not None:
            world = self.assembly.world
            bench = FaultBench(
                TARGET,
                scene,
                world.truth,
                world.faults,
                self.assembly.perception,
                phases,
                episode_rng(seed, 2),
            )
            FAULTS[course.fault](bench, FaultState())

    def run(self) -> None:
        """Say one sentence after the other."""
        session = self.assembly.session
        for sentence in self._course.sentences:
            for command in parse(sentence).commands:
                session.run_task(command)
                if not self.stopped:
                    session.hold(HOLD_S)
                if self.stopped:
                    return
