"""Suite ``perception --cameras 2``: where things are seen to be by one camera, and by two together."""

from __future__ import annotations

import argparse
import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from rich.console import Console

from kinematics.geometry import poses
from robots.models.description import load_robot
from robots.perception.fusion.cameras import HEAD, seen_by_all
from robots.perception.object_estimate import ObjectEstimate, fuse_frames
from robots.perception.rgbd.eyes import Eyes
from robots.perception.rgbd.furniture_map import furniture_map
from robots.scenes.light import LightKind
from robots.scenes.scene_description import SceneItem
from tools.evaluate.perception.scenes import look, watched
from tools.evaluate.perception.stand import Stand, world_T_odom
from tools.evaluate.record_suite import document_of, run_record_suite
from tools.evaluate.records import Bar

_NEAR_M = 0.06
"""What is told this near to a true thing is that thing, the nearest first."""
_MOST_TWICE = 0.01


@dataclass(frozen=True, slots=True)
class SeenTwice:
    """What one thing of one scene was told to be by each camera and by both; NaN where it was not told.

    Attributes:
        seed, name: Of the scene, and of the thing in it; an empty name is a thing told that is not there.
        head_m, room_m, both_m: How far off it was told.
        sigma_m: What both together declared of that, along each axis.
        twice: Whether both together told it as two things, and neither alone did.
        differ: Whether it was told that the cameras differ about it.
    """

    seed: int
    name: str
    head_m: float = math.nan
    room_m: float = math.nan
    both_m: float = math.nan
    sigma_m: float = math.nan
    twice: bool = False
    differ: bool = False


@dataclass(frozen=True, slots=True)
class SceneSeenTwice:
    """One scene.

    Attributes:
        seed: Of the scene.
        things: What it holds, and what was told and is not there.
        broken: What broke, or empty.
    """

    seed: int
    things: tuple[SeenTwice, ...] = ()
    broken: str = ""

    @property
    def faults(self) -> tuple[str, ...]:
        """Which demands it broke."""
        told = {
            "broken": bool(self.broken),
            "seen by one and lost by both": any(map(_lost, self.things)),
            "told as two": any(one.twice for one in self.things),
        }
        return tuple(name for name, is_so in told.items() if is_so)


@dataclass(frozen=True, slots=True)
class PairOrder:
    """One scene to look at with two cameras: its seed, and another light than its."""

    seed: int
    light: LightKind | None = None


def judge_pairs(order: PairOrder) -> list[SceneSeenTwice]:
    """The record of a scene; what breaks becomes it."""
    try:
        return [SceneSeenTwice(order.seed, tuple(judge_pair(order.seed, order.light)))]
    except Exception as broken:
        return [SceneSeenTwice(order.seed, broken=repr(broken))]


def judge_pair(seed: int, light: LightKind | None = None) -> list[SeenTwice]:
    """Look at the scene of a seed with the robot's own camera and one in the room."""
    robot = load_robot("talos")
    what = watched(look(seed, light), seed)
    stand = Stand(robot, what, seed)
    eyes = Eyes(furniture_map(what.scene, np.random.default_rng([seed, 77])))
    told = {}
    for number, name in enumerate((HEAD, *(camera.name for camera in what.scene.cameras))):
        picture, _, _ = stand.taken(number)
        told[name] = fuse_frames([(picture.odom_T_camera, eyes.detect(picture, 0))], min_frames=1)
    stand.close()
    both = seen_by_all(told)
    head, room = (_objects(some) for some in told.values())
    odom_T_world = poses.inverse(world_T_odom(what.scene))
    differ = {id(one) for one, _ in both.differing}
    fused = _objects(both.estimates)
    records: list[SeenTwice] = []
    used: set[int] = set()
    for item in what.scene.objects:
        place = (odom_T_world @ item.world_T_object[:, 3])[:3]
        near = _near(fused, place)
        used.update(map(id, near))
        best = near[0] if near else None
        records.append(
            SeenTwice(
                seed,
                item.name,
                _off(head, place),
                _off(room, place),
                _off(fused, place),
                math.nan if best is None or best.error is None else _sigma(best),
                len(near) > max(1, len(_near(head, place)), len(_near(room, place)))
                and not _another_near(what.scene.objects, item),
                best is not None and id(best) in differ,
            )
        )
    records += [SeenTwice(seed, "") for one in fused if id(one) not in used]
    return records


def _objects(seen: Sequence[ObjectEstimate]) -> list[ObjectEstimate]:
    return [one for one in seen if one.category == "object"]


def _near(seen: Sequence[ObjectEstimate], place: np.ndarray[Any, Any]) -> list[ObjectEstimate]:
    off = sorted(((math.dist(one.odom_T_object[:3, 3], place), k) for k, one in enumerate(seen)))
    return [seen[k] for away, k in off if away < _NEAR_M]


def _off(seen: Sequence[ObjectEstimate], place: np.ndarray[Any, Any]) -> float:
    near = _near(seen, place)
    return math.dist(near[0].odom_T_object[:3, 3], place) if near else math.nan


def _sigma(one: ObjectEstimate) -> float:
    assert one.error is not None
    return math.sqrt(float(np.trace(one.error.covariance_m2)) / 3.0)


def _another_near(items: Sequence[SceneItem], item: SceneItem) -> bool:
    place = item.world_T_object[:3, 3]
    return any(
        other is not item and math.dist(other.world_T_object[:3, 3], place) < 2.0 * _NEAR_M for other in items
    )


def _lost(one: SeenTwice) -> bool:
    return not math.isnan(one.head_m) and math.isnan(one.both_m)


@dataclass(frozen=True, slots=True)
class TwoCameras:
    """What many scenes say together."""

    records: Sequence[SceneSeenTwice]

    @property
    def _things(self) -> list[SeenTwice]:
        return [one for record in self.records for one in record.things if one.name]

    def bars(self) -> list[Bar]:
        """The demands: better than one camera, in the middle and at the end, and no thing becomes two."""
        things = self._things
        # the same things for both: those that the head shows
        shown = [one for one in things if not math.isnan(one.head_m) and not _lost(one)]
        bars = []
        for name, share in (("median", 50.0), ("p95", 95.0)):
            alone, both = (
                1e3 * float(np.percentile(values, share)) if values else math.nan
                for values in ([one.head_m for one in shown], [one.both_m for one in shown])
            )
            bars.append(
                Bar(f"position, {name}", f"{both:.2f} mm", f"< {alone:.2f} mm (one camera)", both < alone)
            )
        lost, count = sum(map(_lost, things)), max(len(things), 1)
        twice = sum(one.twice for one in things) / count
        broken = sum(bool(record.broken) for record in self.records)
        return [
            *bars,
            Bar("seen by one and lost by both", str(lost), "0", lost == 0),
            Bar("told as two", f"{twice:.1%}", f"≤ {_MOST_TWICE:.0%}", twice <= _MOST_TWICE),
            Bar("broken scenes", str(broken), "0", broken == 0),
        ]

    def figures(self) -> dict[str, float]:
        """Numbers worth knowing."""
        things = self._things
        count = max(len(things), 1)
        both = [one for one in things if not math.isnan(one.head_m) and not math.isnan(one.room_m)]
        figures = {
            "things": float(len(things)),
            "seen by the head": sum(not math.isnan(one.head_m) for one in things) / count,
            "seen by the room's camera": sum(not math.isnan(one.room_m) for one in things) / count,
            "seen by either": sum(not math.isnan(one.both_m) for one in things) / count,
            "told to differ": sum(one.differ for one in things) / count,
            "not there": float(sum(not one.name for record in self.records for one in record.things)),
        }
        for name, values in (
            ("head", [one.head_m for one in both]),
            ("room's camera", [one.room_m for one in both]),
            ("both together", [one.both_m for one in both]),
        ):
            if values:
                figures[f"{name}, of what both see, median mm"] = 1e3 * float(np.median(values))
                figures[f"{name}, of what both see, mean mm"] = 1e3 * float(np.mean(values))
        return {name: round(value, 4) for name, value in figures.items()}

    def to_json(self) -> dict[str, Any]:
        """The evaluation's document."""
        return document_of("perception, two cameras", self, self.records)


def run_two_cameras(options: argparse.Namespace, messages: Console) -> int:
    """Judge scenes; 0 when every demand is met, 1 when not."""
    return run_record_suite(
        "scenes seen by two cameras",
        [PairOrder(options.seed + i, options.light) for i in range(options.episodes)],
        judge_pairs,
        _died,
        TwoCameras,
        line=_line,
        place=lambda record: (record.seed,),
        execution=options.execution,
        document=options.json,
        messages=messages,
    )


def _died(order: PairOrder) -> list[SceneSeenTwice]:
    return [SceneSeenTwice(order.seed, broken="the process died")]


def _line(record: SceneSeenTwice) -> str:
    faults = f" {', '.join(record.faults).upper()}" if record.faults else ""
    off = [f"{1e3 * one.head_m:.0f}>{1e3 * one.both_m:.0f}" for one in record.things if one.name]
    return f"seed {record.seed}:{faults} {record.broken} mm by one, and by two: {', '.join(off)}"
