"""Suite of picks that the robot gives up, and that a scripted person finishes by keys."""

from __future__ import annotations

import math
import time
from dataclasses import dataclass, replace

import numpy as np
import pinocchio as pin

from executive.manual.words import Ending
from executive.session.assembly import Assembly, assemble
from kinematics.arrays import Array
from kinematics.model.robot_description import Hand
from robots.scenes.scene_description import SceneDescription
from tools.evaluate.jogging.random_keys import Watch
from tools.evaluate.jogging.typist import Script, Typist, held, silent
from tools.evaluate.orders import EpisodeOrder
from tools.evaluate.records import Bar, EpisodeRecord, Summary, broken_episode
from tools.evaluate.scenes import TARGET, episode_rng, pick_scene, read_episode_scene
from trees.tasks import ObjectDescription, PickTask

HELD = 0.9
"""Of all picks."""
STANDS_OFF_M = (0.8, 1.1)
"""The robot starts so much farther away where the planner shall find the cup out of reach."""
_NEAR_M, _NEAR_RAD = 0.006, 0.06
_ABOVE_M, _BEFORE_M, _LIFT_M = 0.16, 0.15, 0.12
_ABOVE_MIDDLE_M = 0.025
_WAYPOINT_S = 25.0
_REACH_M = 0.6
"""From the base to what a hand takes comfortably."""
_WALK_S = 0.3
_CAME_M = 0.01
"""Held back, it came no nearer than this: there is no room."""
_LIFTED_M = 0.03
_HELD_BACK_S = 0.4
_LINEAR_KEYS = (("up", "down"), ("left", "right"), (";", "."))
_TURN_KEYS = (("u", "o"), ("i", "k"), ("j", "l"))


class Fetcher:
    """A person who sees where the cup is, and brings a hand round it."""

    def __init__(self, assembly: Assembly, typist: Typist, hand: Hand) -> None:
        self._assembly, self._typist, self._hand = assembly, typist, hand
        self._truth = assembly.world.truth
        self._begun_s = 0.0

    def script(self) -> Script:
        """All keys of a pick."""
        yield from silent(1.2)
        if self._typist.keys.jogged.hand != self._hand:
            yield "x"
        yield "p"
        yield from held("f", 2.5)
        yield from self._come_near()
        yield "h"
        facing = self._facing()
        cup = self._cup()
        approach = facing[:, 0]
        before = cup - _BEFORE_M * approach
        yield from self._to(np.array([before[0], before[1], self._tcp()[2, 3]]), facing)
        yield from self._to(np.array([before[0], before[1], cup[2] + _ABOVE_M]), facing)
        yield from self._to(before, facing)
        yield "e"  # along the fingers: from the side they would push the cup away
        yield from self._to(self._cup(), facing)
        yield from held("g", 3.0)
        yield "w"
        yield from self._to(self._tcp()[:3, 3] + np.array([0.0, 0.0, _LIFT_M]), facing)
        yield from silent(0.5)

    def _come_near(self) -> Script:
        """Walk until the cup is in reach, or there is no room."""
        yield "b"
        for _ in range(12):
            base = self._truth.world_T_base()
            ahead_m = float((self._cup() - base[:3, 3]) @ base[:3, 0])
            if ahead_m < _REACH_M:
                return
            yield from held("i", min(_WALK_S + max(ahead_m - _REACH_M, 0.0) / 0.2, 2.0))
            told = self._assembly.session.hands.feed.told
            yield from silent(2.6)
            came_m = float(np.linalg.norm(self._truth.world_T_base()[:2, 3] - base[:2, 3]))
            if told and came_m < _CAME_M:
                return

    def _cup(self) -> Array:
        """Where it is taken: above its middle, away from the table."""
        middle: Array = self._truth.world_T_object(TARGET)[:3, 3]
        above: Array = middle + np.array([0.0, 0.0, _ABOVE_MIDDLE_M])
        return above

    def _tcp(self) -> Array:
        return self._truth.world_T_tcp(self._hand)

    def _facing(self) -> Array:
        """The hand level, pointing from its shoulder's side to the cup; fingers open to the sides."""
        base = self._truth.world_T_base()
        side = 1.0 if self._hand == "left" else -1.0
        shoulder = base[:3, 3] + base[:3, :3] @ np.array([0.0, 0.35 * side, 0.0])
        way = self._cup() - shoulder
        yaw = math.atan2(way[1], way[0])
        x = np.array([math.cos(yaw), math.sin(yaw), 0.0])
        y = np.array([-x[1], x[0], 0.0])
        now = self._tcp()[:3, 1]
        y = y if now @ y >= 0.0 else -y
        return np.column_stack([x, y, np.cross(x, y)])

    def _to(self, place: Array, facing: Array) -> Script:
        """Bring the hand to a place, one axis after the other, turning first."""
        begun_s, held_s = self._now_s, 0.0
        axis: int | None = None
        avoided: dict[int, float] = {}
        while self._now_s - begun_s < _WAYPOINT_S:
            errors = self._errors(place, facing)
            small = np.abs(errors) < np.array([_NEAR_M] * 3 + [_NEAR_RAD] * 3)
            if small.all():
                return
            told = self._assembly.session.hands.feed.told
            if axis is not None and told:
                held_s += 0.04
                if held_s > _HELD_BACK_S:
                    avoided[axis], axis, held_s = self._now_s + 2.0, None, 0.0
            if axis is None or abs(errors[axis]) < 0.5 * (_NEAR_M if axis < 3 else _NEAR_RAD):
                scaled = np.abs(errors) * np.array([1.0] * 3 + [0.3] * 3)
                scaled[small] = 0.0
                for one, until_s in avoided.items():
                    if self._now_s < until_s:
                        scaled[one] *= 0.01
                axis, held_s = int(np.argmax(scaled)), 0.0
            yield from self._paced(abs(errors[axis]) / (1.0 if axis < 3 else 3.0))
            keys = (*_LINEAR_KEYS, *_TURN_KEYS)[axis]
            yield keys[0] if errors[axis] > 0.0 else keys[1]

    def _errors(self, place: Array, facing: Array) -> Array:
        """What is left along and about the axes of the frame that the keys move in."""
        tcp = self._tcp()
        axes = tcp[:3, :3].T if self._typist.keys.jogged.frame == "tool" else np.eye(3)
        return np.concatenate([axes @ (place - tcp[:3, 3]), axes @ pin.log3(facing @ tcp[:3, :3].T)])

    def _paced(self, left_m: float) -> Script:
        wanted = "fast" if left_m > 0.06 else "usual" if left_m > 0.02 else "slow"
        while self._typist.keys.jogged.pace != wanted:
            self._typist.press("z")
        yield from ()

    @property
    def _now_s(self) -> float:
        return self._assembly.session.now_s


def run_jog_pick_episode(order: EpisodeOrder) -> EpisodeRecord:
    """Run one pick; whatever breaks becomes its record."""
    try:
        return _run(order)
    except Exception as broken:
        return broken_episode(order, broken)


def _run(order: EpisodeOrder) -> EpisodeRecord:
    began = time.process_time()
    unseen = order.seed % 2 == 0
    scene = read_episode_scene(pick_scene(order.seed), order.seed)
    if not unseen:
        scene = _farther(scene, float(episode_rng(order.seed, 62).uniform(*STANDS_OFF_M)))
    assembly = assemble(order.robot, scene, order.seed, drawn=False)
    watch, typist, truth = Watch(assembly), Typist(assembly), assembly.world.truth
    assembly.session.watch_periods(watch.on_period)
    cup = truth.world_T_object(TARGET)[:3, 3] - truth.world_T_base()[:3, 3]
    lateral = float(cup @ truth.world_T_base()[:3, 1])
    hand: Hand = "left" if lateral > 0.0 else "right"
    if unseen:
        truth.forget(TARGET)
    failures: list[str] = []

    def offered(failure: object) -> bool:
        failures.append(str(failure))
        return len(failures) == 1

    assembly.session.hands.offer = offered
    ending: Ending = "held_left" if hand == "left" else "held_right"
    task = PickTask("pick up the red cup", ObjectDescription("cup", "red"))
    result = typist.carry_on(task, Fetcher(assembly, typist, hand).script(), ending, by_hand=False)
    truth.remember(TARGET)
    held_now = bool(truth.contacts.of_pads(TARGET)) and truth.lift_m(TARGET) > _LIFTED_M
    truthful = (result.outcome == "done") == bool(truth.contacts.of_pads(TARGET))
    truthful = truthful and (result.evidence.get("by") == "person") == bool(failures)
    others = tuple(sorted(pair for pair in watch.contacts if TARGET not in pair))
    return EpisodeRecord(
        order.seed,
        result.outcome,
        truth=held_now,
        failure_kind=None if result.failure is None else str(result.failure.root.kind.name),
        failure=None if result.failure is None else result.failure.message,
        fell=watch.fell,
        furniture_contacts=others,
        lift_m=truth.lift_m(TARGET),
        simulated_s=assembly.session.now_s,
        numbers={
            "given_up": "not seen" if unseen else "out of reach",
            "truthful": truthful,
            "told_back": assembly.session.hands.feed.told,
            "refused": assembly.loop.statistics.refused,
            "cpu_s": time.process_time() - began,
        },
    )


def _farther(scene: SceneDescription, by_m: float) -> SceneDescription:
    start = scene.robot_start
    x_m, y_m = start.x_m - by_m * math.cos(start.yaw_rad), start.y_m - by_m * math.sin(start.yaw_rad)
    return replace(scene, robot_start=replace(start, x_m=x_m, y_m=y_m))


@dataclass(frozen=True, slots=True)
class JogPickSummary(Summary):
    """The demands on picks that a person finishes."""

    def bars(self) -> list[Bar]:
        """Truthful ends, held, no falls."""
        records = self.records
        truthful = sum(bool(one.numbers.get("truthful")) for one in records)
        held_count, falls = sum(one.truth for one in records), sum(one.fell for one in records)
        return [
            Bar("truthful ends", str(truthful), str(len(records)), truthful == len(records)),
            Bar("held", str(held_count), f"≥ {HELD:.0%}", held_count >= HELD * len(records)),
            Bar("falls", str(falls), "0", falls == 0),
        ]
