"""Suite of random keys: no contact, no fall, ranges kept, silence rests, and back is always possible."""

from __future__ import annotations

import time
from dataclasses import dataclass

import numpy as np

from executive.manual.words import ByHandTask
from executive.session.assembly import Assembly, assemble
from kinematics.arrays import Array
from robots.control.period import PERIOD_S
from tools.evaluate.jogging.typist import Script, Typist, held, silent
from tools.evaluate.orders import EpisodeOrder
from tools.evaluate.records import Bar, EpisodeRecord, Summary, broken_episode
from tools.evaluate.scenes import episode_rng, pick_scene, read_episode_scene
from trees.tasks import DescribeTask

STOPS_WITHIN_S = 0.3
"""Of hand, head and fingers, after the last key."""
STANDS_WITHIN_S = 2.0
"""Of a walk, after the last key."""
REST_RAD_S = 0.02
STILL_M_S = 0.02
INTO_EVERY = 3
"""One sequence of so many goes on until something holds the robot back."""
SEQUENCES = 3
"""In each scene, one after the other: to look about takes longer than a sequence."""
_HOLDS = 4
_LIMIT_NOISE_RAD = 0.005
"""A measured joint may be so far beyond its range: the servo's give."""
_AWAY_RAD, _AWAY_M = 0.002, 0.002
_EVERY = 5
_OPPOSITE = {
    **dict(zip(("up", "left", ";", "u", "i", "j"), ("down", "right", ".", "o", "k", "l"), strict=True)),
    **dict(zip(("down", "right", ".", "o", "k", "l"), ("up", "left", ";", "u", "i", "j"), strict=True)),
    "[": "]",
    "]": "[",
    "-": "=",
    "=": "-",
    "g": "f",
    "f": "g",
}
_OPPOSITE_BASE = {"i": ",", ",": "i", "j": "l", "l": "j", "u": "m", "m": "u", "o": ".", ".": "o"}
_HAND_KEYS = ("up", "down", "left", "right", ";", ".", "u", "i", "o", "j", "k", "l")
_HEAD_AND_FINGERS = ("[", "]", "-", "=", "g", "f")
_JOINT_KEYS = tuple("1234567")
_BASE_KEYS = tuple(_OPPOSITE_BASE)


class Watch:
    """Watches the simulated world: contacts, falls, ranges, and when what moves comes to rest.

    Attributes:
        contacts: Pairs that touched.
        fell: Whether the robot fell.
        beyond: Joints that were measured beyond their range.
        rested_s: Simulated time since which nothing of trunk, arms, head and fingers has moved.
        stood_s: Simulated time since which the base has not moved.
        ended_s: Simulated time since which both feet stand and no walk is under way, its settling included.
    """

    def __init__(self, assembly: Assembly) -> None:
        self._assembly, self._truth = assembly, assembly.world.truth
        description = assembly.model.description
        joints = description.actuated
        groups = description.groups
        legs = {*groups.get("left_leg", ()), *groups.get("right_leg", ())}
        upper = [k for k, joint in enumerate(joints) if joint not in legs]
        self._upper = np.array(upper)
        self._low = assembly.model.lower_rad - _LIMIT_NOISE_RAD
        self._high = assembly.model.upper_rad + _LIMIT_NOISE_RAD
        self._joints = joints
        self._periods = 0
        self._base_m = self._truth.world_T_base()[:3, 3].copy()
        self.contacts: set[str] = set()
        self.beyond: set[str] = set()
        self.fell = False
        self.rested_s = self.stood_s = self.ended_s = assembly.session.now_s

    def on_period(self) -> None:
        """Look at the world."""
        self._periods += 1
        if self._truth.contacts.robot_touches_something():
            contacts = self._truth.contacts
            for contact in (*contacts.robot_with_furniture(), *contacts.robot_with_objects()):
                self.contacts.add(f"{contact.first} and {contact.second}")
        if self._periods % _EVERY:
            return
        now_s = self._assembly.session.now_s
        self.fell = self.fell or self._truth.fallen()
        q, v = self._truth.joint_positions(), self._truth.joint_velocities()
        body = q[: len(self._low)]
        outside = (body < self._low) | (body > self._high)
        self.beyond.update(self._joints[k] for k in np.flatnonzero(outside))
        if np.abs(v[self._upper]).max() > REST_RAD_S:
            self.rested_s = now_s
        base_m = self._truth.world_T_base()[:3, 3].copy()
        if float(np.linalg.norm(base_m - self._base_m)) > STILL_M_S * _EVERY * PERIOD_S:
            self.stood_s = now_s
        if self._assembly.loop.walking.active:
            self.ended_s = self.rested_s = now_s
        self._base_m = base_m


@dataclass(slots=True)
class Held:
    """One key held down, and what came of it."""

    key: str
    mode: str
    stopped_s: float = 0.0
    stood_s: float = 0.0
    held_back: str = ""
    way_out: bool = True


class RandomKeys:
    """The script of the sequences in one scene.

    Attributes:
        told: Every key that was held down.
    """

    def __init__(self, assembly: Assembly, typist: Typist, watch: Watch, rng: np.random.Generator) -> None:
        self._assembly, self._typist, self._watch, self._rng = assembly, typist, watch, rng
        self._into = False
        self.told: list[Held] = []

    def script(self) -> Script:
        """Keys, one hold after the other."""
        yield from silent(1.0)
        for number in range(SEQUENCES):
            self._into = number % INTO_EVERY == 0
            for _ in range(_HOLDS):
                yield from self._choices()
                key = self._key()
                yield from self._hold(key)
            yield from silent(0.5)

    def _choices(self) -> Script:
        mode = self._rng.choice(["h", "n", "b"], p=[0.55, 0.25, 0.2])
        yield str(mode)
        for key, chance in (("x", 0.3), ("z", 0.4), ("s", 0.0)):
            if self._rng.random() < chance:
                yield key
        own = {"h": ("w", "e", "q"), "n": ("r",)}.get(str(mode), ())
        if own and self._rng.random() < 0.4:
            yield str(self._rng.choice(own))

    def _key(self) -> str:
        mode = self._typist.keys.jogged.mode
        if self._rng.random() < 0.15:
            return str(self._rng.choice(_HEAD_AND_FINGERS))
        if mode == "hand":
            if self._into and self._rng.random() < 0.6:
                return str(self._rng.choice([".", "up", "right", "left"]))
            return str(self._rng.choice(_HAND_KEYS))
        return str(self._rng.choice(_JOINT_KEYS if mode == "joints" else _BASE_KEYS))

    def _hold(self, key: str) -> Script:
        seconds = float(self._rng.uniform(1.5, 5.0) if self._into else self._rng.uniform(0.04, 1.5))
        mode = self._typist.keys.jogged.mode
        walks = mode == "base" and key in _OPPOSITE_BASE
        told = Held(key, mode)
        yield from held(key, seconds)
        last_s = self._typist.pressed_s
        told.held_back = self._assembly.session.hands.feed.told
        yield from silent(2.8 if walks else 0.6)
        if last_s is not None:
            told.stopped_s = max(0.0, self._watch.rested_s - last_s)
            told.stood_s = max(0.0, max(self._watch.stood_s, self._watch.ended_s) - last_s)
        if told.held_back and key not in "gf":
            yield from self._way_out(key, mode, told)
        self.told.append(told)

    def _way_out(self, key: str, mode: str, told: Held) -> Script:
        before = self._state()
        walks = mode == "base" and key in _OPPOSITE_BASE
        if mode == "joints" and key in _JOINT_KEYS:
            yield "r"
            yield from held(key, 0.8)
            yield "r"
        else:
            yield from held((_OPPOSITE_BASE if walks else _OPPOSITE)[key], 1.2 if walks else 0.8)
        yield from silent(2.8 if walks else 0.5)
        after = self._state()
        if walks:
            told.way_out = bool(np.linalg.norm(after[1] - before[1]) > _AWAY_M)
        else:
            told.way_out = bool(np.abs(after[0] - before[0]).max() > _AWAY_RAD)

    def _state(self) -> tuple[Array, Array]:
        truth = self._assembly.world.truth
        base = truth.world_T_base()
        return self._assembly.loop.setpoint.q.copy(), np.concatenate([base[:3, 3], base[:2, 0]])


def run_jog_episode(order: EpisodeOrder) -> EpisodeRecord:
    """Run the sequences in one scene; whatever breaks becomes its record."""
    try:
        return _run(order)
    except Exception as broken:
        return broken_episode(order, broken)


def _run(order: EpisodeOrder) -> EpisodeRecord:
    began = time.process_time()
    rng = episode_rng(order.seed, 61)
    scene = read_episode_scene(pick_scene(order.seed), order.seed)
    assembly = assemble(order.robot, scene, order.seed, drawn=False)
    watch, typist = Watch(assembly), Typist(assembly)
    assembly.session.watch_periods(watch.on_period)
    assembly.session.run_task(DescribeTask("what do you see"))
    keys = RandomKeys(assembly, typist, watch, rng)
    result = typist.carry_on(ByHandTask("jog the robot"), keys.script(), "go_on", by_hand=True)
    refused = assembly.loop.statistics.refused
    stops = [str(stop) for stop in assembly.loop.statistics.stops]
    walks = [one for one in keys.told if one.mode == "base" and one.key in _OPPOSITE_BASE]
    others = [one for one in keys.told if one not in walks]
    stopped_s = max((one.stopped_s for one in others), default=0.0)
    stood_s = max((one.stood_s for one in walks), default=0.0)
    trapped = [f"{one.mode} {one.key} ({one.held_back})" for one in keys.told if not one.way_out]
    wrong = [
        *(f"touched: {pair}" for pair in sorted(watch.contacts)),
        *(["fell"] if watch.fell else []),
        *(f"beyond its range: {joint}" for joint in sorted(watch.beyond)),
        *([f"{refused} setpoints refused"] if refused else []),
        *([f"moved {stopped_s:.2f} s after the last key"] if stopped_s > STOPS_WITHIN_S else []),
        *([f"walked {stood_s:.2f} s after the last key"] if stood_s > STANDS_WITHIN_S else []),
        *(f"no way out: {one}" for one in trapped),
        *(stops if stops else []),
    ]
    return EpisodeRecord(
        order.seed,
        result.outcome,
        truth=not wrong,
        failure_kind=None if not wrong else "EXECUTION",
        failure="; ".join(wrong) or None,
        fell=watch.fell,
        furniture_contacts=tuple(sorted(watch.contacts)),
        simulated_s=assembly.session.now_s,
        numbers={
            "sequences": SEQUENCES,
            "beyond": len(watch.beyond),
            "refused": refused,
            "stopped_s": stopped_s,
            "stood_s": stood_s,
            "trapped": len(trapped),
            "held_back": sum(bool(one.held_back) for one in keys.told),
            "walks": len(walks),
            "cpu_s": time.process_time() - began,
        },
    )


@dataclass(frozen=True, slots=True)
class JogSummary(Summary):
    """The demands on jogging."""

    def bars(self) -> list[Bar]:
        """Contacts, falls, limits, stops, and ways out."""
        records = self.records

        def most(name: str) -> float:
            return max((float(one.numbers.get(name, 0.0)) for one in records), default=0.0)

        def count(name: str) -> int:
            return sum(int(one.numbers.get(name, 0)) for one in records)

        sequences = count("sequences")
        touched = sum(bool(one.furniture_contacts) for one in records)
        falls, errors = sum(one.fell for one in records), sum(one.outcome == "error" for one in records)
        stopped_s, stood_s = most("stopped_s"), most("stood_s")
        return [
            Bar(f"scenes with a contact, {sequences} sequences", str(touched), "0", touched == 0),
            Bar("falls", str(falls), "0", falls == 0),
            Bar("joints beyond their range", str(count("beyond")), "0", count("beyond") == 0),
            Bar("setpoints refused", str(count("refused")), "0", count("refused") == 0),
            _within("hand, head, fingers stop", stopped_s, STOPS_WITHIN_S),
            _within("a walk stands", stood_s, STANDS_WITHIN_S),
            Bar("standstills without a way out", str(count("trapped")), "0", count("trapped") == 0),
            Bar("broken episodes", str(errors), "0", errors == 0),
        ]


def _within(name: str, seconds: float, most_s: float) -> Bar:
    return Bar(name, f"{seconds:.2f} s", f"≤ {most_s} s", seconds <= most_s)
