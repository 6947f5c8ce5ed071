"""The suite ``soak``: random commands, stops, pauses, faults and resets for long; what grows meanwhile."""

from __future__ import annotations

import argparse
import json
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from rich.console import Console

from executive.session.assembly import Assembly, assemble
from executive.session.events import Event, InputTaken, TaskAccepted, TaskEnded
from executive.understanding.command_parser import parse
from robots.control.events import EmergencyReset, EmergencyStopped, MotionPaused, MotionResumed
from robots.scenes.scene_description import SceneDescription
from robots.simulated.faults.body_faults import BodyFaults
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
_UNTIL_WELL_S = 3.0
"""A bias is averaged over a second, and is over a second after it was last seen; resting takes the rest."""
_BIASED_RAD_S = 0.03
_SLIPPED_RAD = 0.05
_LOW = 0.1
_SLIPS = "arm_left_3_joint"
_COUNTERPARTS = (
    (TaskAccepted.__name__, TaskEnded.__name__),
    (EmergencyStopped.__name__, EmergencyReset.__name__),
    (MotionPaused.__name__, f"{InputTaken.__name__} pause"),
    (f"{InputTaken.__name__} pause", f"{InputTaken.__name__} resume"),
)
"""Events of which there have to be as many of the one as of the other."""


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
        self.assembly.session.hold(_UNTIL_WELL_S)
        self.assembly.session.reset("the soak")

    @property
    def _slipping(self) -> int:
        return self.assembly.model.description.actuated.index(_SLIPS)

    def _break(self, act: Callable[[], None]) -> None:
        self.ill = True
        act()


@dataclass(slots=True)
class _Tally:
    """What has happened so far.

    Attributes:
        told: Events by their kind; inputs by what was put in.
        outcomes: Commands by how they ended.
        memory: Simulated time, s, and memory of the process, MB, after each command.
        fell: Worlds in which the robot lies.
        stuck_resets: Resets that a resting robot refused.
        hangs: Commands that took too long.
        unusable: Undisturbed ways home that failed.
        passed_s: Simulated time.
    """

    told: Counter[str] = field(default_factory=Counter)
    outcomes: Counter[str] = field(default_factory=Counter)
    memory: list[tuple[float, float]] = field(default_factory=list)
    fell: int = 0
    stuck_resets: int = 0
    hangs: int = 0
    unusable: int = 0
    passed_s: float = 0.0

    def take(self, event: Event) -> None:
        """Count an event."""
        kind = type(event).__name__
        self.told[f"{kind} {event.what}" if isinstance(event, InputTaken) else kind] += 1

    @property
    def lost(self) -> int:
        """Events without their counterpart."""
        return sum(abs(self.told[a] - self.told[b]) for a, b in _COUNTERPARTS)

    def bars(self, until_s: float) -> list[Bar]:
        """What is demanded of a soak of so much simulated time."""
        growth = _growth(self.memory, until_s)
        counts = (
            ("falls", self.fell),
            ("commands that hung", self.hangs),
            ("undisturbed ways home that failed", self.unusable),
            ("resets that a resting robot refused", self.stuck_resets),
            ("events without their counterpart", self.lost),
        )
        return [
            Bar("memory growth", f"{growth:.1%}", f"≤ {GROWTH:.0%}", growth <= GROWTH),
            *(Bar(name, str(count), "0", count == 0) for name, count in counts),
        ]


def run_soak(options: argparse.Namespace, messages: Console) -> int:
    """Run it in this process; 0 when every demand is met, 1 when not."""
    until_s = options.episodes * SECONDS_AN_EPISODE
    rng = episode_rng(options.seed, 5)
    tally = _Tally()
    worlds = [
        _world(options.robot, scene, options.seed, sentences, tally.take)
        for scene, sentences in (
            (read_episode_scene(pick_scene(options.seed), options.seed), _AT_A_TABLE),
            (floor("soak", episode_rng(options.seed, 6)), _ON_A_FLOOR),
        )
    ]
    while tally.passed_s < until_s and not tally.fell:
        messages.print(_one_command(worlds, rng, tally), markup=False, soft_wrap=True)
    bars = tally.bars(until_s)
    if options.json is not None:
        document = _document(options, tally, bars)
        options.json.write_text(json.dumps(document, indent=1) + "\n", "utf-8")
    console = Console()
    for bar in bars:
        console.print(f"{bar.name}: {bar.value} ({bar.limit}) {'ok' if bar.met else 'MISSED'}")
    resumed = tally.told[MotionResumed.__name__]
    console.print(f"{tally.passed_s:.0f} s simulated, outcomes {dict(tally.outcomes)}, {resumed} resumed")
    return 0 if all(bar.met for bar in bars) else 1


def _one_command(worlds: Sequence[_World], rng: np.random.Generator, tally: _Tally) -> str:
    """Give a random command in a random world, with a random disturbance; a line about it."""
    world = worlds[int(rng.integers(len(worlds)))]
    session, clock = world.assembly.session, world.assembly.clock
    began_s = clock.now_s()
    sentence = world.sentences[int(rng.integers(len(world.sentences)))]
    what = _DISTURBANCES[int(rng.integers(len(_DISTURBANCES)))]
    world.plan(what, began_s + float(rng.uniform(0.0, _LATEST_S)))
    (command,) = parse(sentence).commands
    result = session.run_task(command)
    tally.outcomes[result.outcome] += 1
    undisturbed = what in ("none", "pause")
    tally.unusable += int(sentence == _HOME and undisturbed and result.outcome != "done")
    tally.hangs += int(clock.now_s() - began_s > LONGEST_S)
    session.hold(float(rng.uniform(0.2, 1.5)))
    world.mend()
    if world.assembly.loop.emergency is not None and session.reset("the soak") is not None:
        tally.stuck_resets += 1
    tally.fell += int(world.assembly.world.truth.fallen())
    tally.passed_s += clock.now_s() - began_s
    tally.memory.append((tally.passed_s, _resident_mb()))
    return (
        f"{tally.passed_s:.0f} s: {sentence}, {what}: {result.outcome}, {tally.outcomes.total()} commands, "
        f"{tally.memory[-1][1]:.0f} MB. {result.failure.message if result.failure is not None else ''}"
    )


def _document(options: argparse.Namespace, tally: _Tally, bars: Sequence[Bar]) -> dict[str, Any]:
    """The soak as JSON values."""
    return {
        "suite": "soak",
        "seed": options.seed,
        "episodes": options.episodes,
        "simulated_s": round(tally.passed_s, 1),
        "falls": tally.fell,
        "failures": dict(tally.outcomes),
        "events": dict(sorted(tally.told.items())),
        "memory_mb": [(round(t, 1), round(mb, 1)) for t, mb in tally.memory],
        "bars": [asdict(bar) for bar in bars],
    }


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
