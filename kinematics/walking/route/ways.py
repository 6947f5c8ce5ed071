"""The way of a walk to its goal: as far from what stands about as there is room, the hands considered."""

from __future__ import annotations

import functools
import math
from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from kinematics.arrays import Array
from kinematics.geometry.planar import PlanarPose
from kinematics.model.walking_settings import WalkingSettings
from kinematics.scene.planning_scene import PlanningScene
from kinematics.walking.pattern.steering import PathSteering, foreseen
from kinematics.walking.route.path_planning import clearance_m, footprints, plan_path
from kinematics.walking.route.room import BESIDE_HANDS_M, WalkingRoom

Clearance = tuple[float, float]
"""Of the path from what is as tall as the hands, which takes more room by itself, and from lower ones, m."""

_CLEARANCES_M: tuple[Clearance, ...] = ((0.72, 0.72), (0.62, 0.62), (0.72, 0.47), (0.62, 0.47))
"""The first one that leaves a way is kept. Below the hands TALOS is nowhere wider than 0.32 m each way."""
_TUCKED_CLEARANCES_M: tuple[Clearance, ...] = ((0.72, 0.72), (0.62, 0.62), (0.55, 0.47), (0.52, 0.42))
"""The same with the arms drawn in."""
BESIDE_TUCKED_M = (BESIDE_HANDS_M, 0.03, 0.0)
"""Left beside the hands, the more the better."""
_STRAIGHT_SHARES = (1.0, 0.67, 0.33)
_THERE_M, _THERE_RAD = 0.05, 0.1


@dataclass(frozen=True, slots=True)
class Way:
    """A way to a goal.

    Attributes:
        path: Its corners before the goal.
        steering: What walks it, to the goal.
        clearance_m: How far it stays from what is as tall as the hands, besides what that takes by itself.
        passes: Where the body comes by before the goal; that was chosen with what the hands need there.
    """

    path: tuple[PlanarPose, ...]
    steering: PathSteering
    clearance_m: float
    passes: tuple[PlanarPose, ...]


@dataclass(frozen=True, slots=True)
class NoWay:
    """The answer that no way leads to a goal.

    Attributes:
        for_hands: Whether there is one for the body, and it is the hands that have no room on it.
        clearance_m: The smallest clearance that a way was looked for with.
    """

    for_hands: bool
    clearance_m: float


@dataclass(frozen=True, slots=True)
class WayFinder:
    """Finds ways among what is believed and what was seen.

    Attributes:
        settings: The sizes of a robot that walks.
        room: What it takes with what it holds.
        scene: What is believed.
        points: What was seen, and belongs to nothing in the scene, shape (n, 2).
        straight_m: How long the last stretch is straight ahead, where there is room for that.
        if_hands_fit: Take no way on which a hand meets something, if the arms can be drawn in: that is done
            first then.
        tall: Of the points those where something is as tall as the hands, shape (n, 2).
    """

    settings: WalkingSettings
    room: WalkingRoom
    scene: PlanningScene
    points: Array
    straight_m: float
    if_hands_fit: bool = False
    tall: Array = field(default_factory=lambda: np.zeros((0, 2)))

    def find(self, body: PlanarPose, goal: PlanarPose) -> Way | NoWay:
        """The way that leaves the most beside the hands, and of those the farthest from things.

        Args:
            body: Where the robot is, in the scene's frame.
            goal: Where it is to stand.
        """
        clearances = _TUCKED_CLEARANCES_M if self.room.tucked else _CLEARANCES_M
        way_with = functools.cache(functools.partial(self._way, body, goal))
        for spare_m in self._spares_m(body):
            for clearance in clearances:
                way = way_with(clearance)
                if way is not None and self._hands_pass(way, spare_m):
                    return way
        return NoWay(any(way_with(clearance) for clearance in clearances), clearances[-1][1])

    def _way(self, body: PlanarPose, goal: PlanarPose, clearance: Clearance) -> Way | None:
        high_m, low_m = clearance
        more_m = high_m - low_m
        around, widest_m = self.room.footprints(self.scene, more_m), self.room.widest_m + more_m
        path = plan_path(body, self._before(goal), around, low_m, self.points, widest_m)
        if path is None:
            return None
        steering = PathSteering(self.settings, (*path, goal))
        passes = tuple(pose for pose in foreseen(steering, body) if not _is_at(pose, goal))
        return Way(path, steering, high_m, passes)

    def _before(self, goal: PlanarPose) -> PlanarPose:
        """Where the straight stretch to the goal begins: as far from it as there is room for legs."""
        about = footprints(self.scene)
        ways = (goal @ PlanarPose(-share * self.straight_m) for share in _STRAIGHT_SHARES)
        legs_m = self.settings.legs_radius_m + self.settings.sway_m
        free = (way for way in ways if min(clearance_m(about, way), self._apart_m(way)) >= legs_m)
        return next(free, goal)

    def _apart_m(self, place: PlanarPose) -> float:
        """Distance to the nearest point that was seen; infinite without one."""
        away = self.points - (place.x_m, place.y_m)
        return float(np.hypot(away[:, 0], away[:, 1]).min(initial=math.inf))

    def _spares_m(self, body: PlanarPose) -> tuple[float | None, ...]:
        """What to leave beside the hands, the more the better; None where they have to get by as they can."""
        if self.room.tucked:
            return (None,) if self._hands_meet([body], BESIDE_TUCKED_M[-1]) else BESIDE_TUCKED_M
        return (BESIDE_HANDS_M,) if self.if_hands_fit and self.room.can_tuck else (None,)

    def _hands_pass(self, way: Way, spare_m: float | None) -> bool:
        """Whether the hands come to nothing on a way; where they have to get by as they can, always."""
        if spare_m is None or not way.passes:
            return True
        return not self._hands_meet(way.passes, spare_m)

    def _hands_meet(self, way: Sequence[PlanarPose], spare_m: float) -> bool:
        room = self.room
        return room.hands_meet(self.scene, way, spare_m) or room.hands_meet_seen(self.tall, way, spare_m)


def _is_at(pose: PlanarPose, goal: PlanarPose) -> bool:
    left = pose.to(goal)
    return math.hypot(left.x_m, left.y_m) <= _THERE_M and abs(left.yaw_rad) <= _THERE_RAD
