"""The suite ``soak``: random commands, stops, pauses, faults and resets for long; what grows meanwhile."""

from __future__ import annotations

import argparse
import json
from collections import Counter
from collections.abc import Callable
from dataclasses import asdict, dataclass, field
from pathlib import Path

import numpy as np
from rich.console import Console

from executive.assembly import Assembly, assemble
from executive.command_parser import parse
from executive.events import Event, InputTaken, TaskAccepted, TaskEnded
from robots.control.events import EmergencyReset, EmergencyStopped, MotionPaused, MotionResumed
from robots.scene_description import SceneDescription
from robots.simulated.body_faults import BodyFaults
from tools.evaluate.records import Bar
from tools.evaluate.scenes import SENTENCE, episode_rng, pick_scene, read_episode_scene
from tools.evaluate.skills.walking import floor

SECONDS_AN_EPISODE = 60.0
"""Simulated time that one of ``--episodes`` stands for: two hours are 120."""
GROWTH = 0.05
WARM_SHARE = 0.2
"""Memory is compared with what it was after this share of the time: caches fill first."""
LONGEST_S = 200.0
"""A command that takes longer, simulated, hangs: the session gives tasks up before."""
_HOME = "go home"
"""What a standing robot can always do, unless something is done to it meanwhile."""
_AT_A_TABLE = (
    SENTENCE,
    SENTENCE,
    "put the red cup on the table",
    _HOME,
    "look at the red cup",
    "pick up the blue cup",
)
_ON_A_FLOOR = ("move forward", "move backward", "turn left", "turn right", _HOME)
_DISTURBANCES = ("none", "none", "none", "cancel", "stop 1", "stop 2", "pause", "gyro", "battery", "encoder")
_LATEST_S = 12.0
_PAUSED_S = 1.5
_BIASED_RAD_S = 0.03
_SLIPPED_RAD = 0.05
_LOW = 0.1
_SLIPS = "arm_left_3_joint"


@dataclass(slots=True)
class _World:
    """A robot in one of the worlds, all of which exist from the beginning to the end."""

    assembly: Assembly
    sentences: tuple[str, ...]
    due: list[tuple[float, Callable[[], None]]] = field(default_factory=list)
    ill: bool = False

    def disturb(self) -> None:
        """Called after each control period."""
        while self.due and self.assembly.clock.now_s() >= self.due[0][0]:
            _, act = self.due.pop(0)
            act()

    def plan(self, what: str, at_s: float) -> None:
        """Have something happen at a time."""
        session, faults = self.assembly.session, self.assembly.world.body_faults
        acts: dict[str, Callable[[], None]] = {
            "cancel": lambda: session.cancel("the soak cancels it"),
            "stop 1": lambda: session.emergency_stop("the soak stops it", 1),
            "stop 2": lambda: session.emergency_stop("the soak stops it", 2),
            "gyro": lambda: self._break(lambda: faults.bias_gyro((0.0, _BIASED_RAD_S, 0.0))),
            "battery": lambda: self._break(lambda: faults.set_battery(_LOW)),
            "encoder": lambda: self._break(lambda: faults.offset_encoder(_SLIPS, _SLIPPED_RAD)),
        }
        self.due.clear()
        if what == "pause":
            self.due += [
                (at_s, lambda: session.pause("the soak pauses it")),
                (at_s + _PAUSED_S, session.resume),
            ]
        elif what != "none":
            self.due.append((at_s, acts[what]))

    def mend(self) -> None:
        """Somebody mends what is broken, and looks at the robot."""
        self.due.clear()
        if not self.ill:
            return
        self.ill = False
        faults: BodyFaults = self.assembly.world.body_faults
        faults.bias_gyro((0.0, 0.0, 0.0))
        faults.set_battery(1.0)
        faults.offset_encoder(_SLIPS, -float(self.assembly.world.robot.encoder_offset[self._slipping]))
        self.assembly.session.hold(2.0)
        self.assembly.session.reset("the soak")

    @property
    def _slipping(self) -> int:
        return self.assembly.model.description.actuated.index(_SLIPS)

    def _break(self, act: Callable[[], None]) -> None:
        self.ill = True
        act()


def run_soak(options: argparse.Namespace, messages: Console) -> int:
    """Run it in this process; 0 when every demand is met, 1 when not."""
    until_s = options.episodes * SECONDS_AN_EPISODE
    rng = episode_rng(options.seed, 5)
    told: Counter[str] = Counter()

    def take(event: Event) -> None:
        kind = type(event).__name__
        told[f"{kind} {event.what}" if isinstance(event, InputTaken) else kind] += 1

    worlds = [
        _world(options.robot, scene, options.seed, sentences, take)
        for scene, sentences in (
            (read_episode_scene(pick_scene(options.seed), options.seed), _AT_A_TABLE),
            (floor("soak", episode_rng(options.seed, 6)), _ON_A_FLOOR),
        )
    ]
    outcomes: Counter[str] = Counter()
    memory: list[tuple[float, float]] = []
    fell, stuck_resets, hangs, unusable, passed_s = 0, 0, 0, 0, 0.0
    while passed_s < until_s and not fell:
        world = worlds[int(rng.integers(len(worlds)))]
        session, clock = world.assembly.session, world.assembly.clock
        began_s = clock.now_s()
        sentence = world.sentences[int(rng.integers(len(world.sentences)))]
        what = _DISTURBANCES[int(rng.integers(len(_DISTURBANCES)))]
        world.plan(what, began_s + float(rng.uniform(0.0, _LATEST_S)))
        (command,) = parse(sentence).commands
        result = session.run_task(command)
        outcome = result.outcome
        outcomes[outcome] += 1
        undisturbed = what in ("none", "pause")
        unusable += int(sentence == _HOME and undisturbed and outcome != "done")
        hangs += int(clock.now_s() - began_s > LONGEST_S)
        session.hold(float(rng.uniform(0.2, 1.5)))
        world.mend()
        if world.assembly.loop.emergency is not None and session.reset("the soak") is not None:
            stuck_resets += 1
        fell += int(world.assembly.world.truth.fallen())
        passed_s += clock.now_s() - began_s
        memory.append((passed_s, _resident_mb()))
        messages.print(
            f"{passed_s:.0f} s: {sentence}, {what}: {outcome}, {sum(outcomes.values())} commands, "
            f"{memory[-1][1]:.0f} MB. {result.failure.message if result.failure is not None else ''}",
            markup=False,
            soft_wrap=True,
        )
    growth = _growth(memory, until_s)
    lost = sum(
        abs(told[a] - told[b])
        for a, b in (
            (TaskAccepted.__name__, TaskEnded.__name__),
            (EmergencyStopped.__name__, EmergencyReset.__name__),
            (MotionPaused.__name__, f"{InputTaken.__name__} pause"),
            (f"{InputTaken.__name__} pause", f"{InputTaken.__name__} resume"),
        )
    )
    bars = [
        Bar("memory growth", f"{growth:.1%}", f"≤ {GROWTH:.0%}", growth <= GROWTH),
        Bar("falls", str(fell), "0", fell == 0),
        Bar("commands that hung", str(hangs), "0", hangs == 0),
        Bar("undisturbed ways home that failed", str(unusable), "0", unusable == 0),
        Bar("resets that a resting robot refused", str(stuck_resets), "0", stuck_resets == 0),
        Bar("events without their counterpart", str(lost), "0", lost == 0),
    ]
    document = {
        "suite": "soak",
        "seed": options.seed,
        "episodes": options.episodes,
        "simulated_s": round(passed_s, 1),
        "falls": fell,
        "failures": dict(outcomes),
        "events": dict(sorted(told.items())),
        "memory_mb": [(round(t, 1), round(mb, 1)) for t, mb in memory],
        "bars": [asdict(bar) for bar in bars],
    }
    if options.json is not None:
        options.json.write_text(json.dumps(document, indent=1) + "\n", "utf-8")
    console = Console()
    for bar in bars:
        console.print(f"{bar.name}: {bar.value} ({bar.limit}) {'ok' if bar.met else 'MISSED'}")
    console.print(
        f"{passed_s:.0f} s simulated, outcomes {dict(outcomes)}, {told[MotionResumed.__name__]} resumed"
    )
    return 0 if all(bar.met for bar in bars) else 1


def _world(
    robot: str, scene: SceneDescription, seed: int, sentences: tuple[str, ...], take: Callable[[Event], None]
) -> _World:
    world = _World(assemble(robot, scene, seed, sink=take), sentences)
    world.assembly.session.watch_periods(world.disturb)
    return world


def _growth(memory: list[tuple[float, float]], until_s: float) -> float:
    """Share by which memory grew since it was warm."""
    warm = [mb for t, mb in memory if t >= WARM_SHARE * until_s]
    return float(np.max(warm)) / warm[0] - 1.0 if warm else 0.0


def _resident_mb() -> float:
    """What this process holds in memory now."""
    pages = int(Path("/proc/self/statm").read_text("utf-8").split()[1])
    return pages * 4096 / 1e6
