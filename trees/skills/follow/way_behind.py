"""The next stretch of a walk towards somebody who walks: straight there, or around what stands between."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from kinematics.arrays import Array
from kinematics.geometry.planar import PlanarPose
from kinematics.model.walking_settings import WalkingSettings
from kinematics.scene.planning_scene import PlanningScene
from kinematics.walking.pattern.steering import PACE, PathSteering
from kinematics.walking.route.path_planning import Footprint, blocked, clearance_m
from kinematics.walking.route.room import WalkingRoom
from kinematics.walking.route.ways import NoWay, WayFinder
from trees.readings.odometry import what_is_around
from trees.skills.walking.seen_points import SeenPoints
from trees.skills.walking.walking_leaf import without_held
from trees.toolbox import Toolbox

_STRAIGHT_M = 0.60
"""A straight stretch stays so far from everything; where there is less room a way is planned."""
_PERSON_M = 0.50
"""What is seen so near to the person is the person."""
_SAMPLE_M = 0.05
_LESS_M = 0.08
"""What is seen by so much nearer than it was is where it was: scans are not exact, and walks sway."""
_GOAL_M = 0.55
"""A stretch ends so far from everything: nearer a robot with its arms drawn in has no room to turn."""
_ASIDE_RAD = (0.0, 0.35, -0.35, 0.7, -0.7, 1.05, -1.05)
_STANDS = tuple((farther_m, aside) for farther_m in (0.0, 0.4, 0.8) for aside in _ASIDE_RAD)
"""Where to stand for a person: how much farther away than usual, and how far to a side of straight."""


@dataclass(frozen=True, slots=True)
class _Around:
    """What is around at one moment: what is believed without people, what that takes, and what is seen."""

    scene: PlanningScene
    obstacles: tuple[Footprint, ...]
    points: Array

    def apart_m(self, place: PlanarPose, points_m: float) -> float:
        """Distance of a place to the nearest thing; each point that is seen takes so much all around."""
        away = self.points - (place.x_m, place.y_m)
        seen_m = float(np.hypot(away[:, 0], away[:, 1]).min(initial=math.inf)) - points_m
        return min(clearance_m(self.obstacles, place), seen_m)


@dataclass(frozen=True, slots=True)
class Stretch:
    """A way that was planned.

    Attributes:
        steering: Walks it.
        clearance_m: How far it stays from all that was seen when it was planned, or farther.
    """

    steering: PathSteering
    clearance_m: float

    def left_from(self, body: PlanarPose) -> tuple[PlanarPose, ...]:
        """What is left of it for a body that is here now."""
        path = self.steering.path
        nearest = min(
            range(1, len(path)), key=lambda k: _apart_m(path[k - 1], path[k], body), default=len(path)
        )
        return (body, *path[nearest:])


class WayBehind:
    """Plans stretches among what is believed and what is seen at the moment, people aside.

    People walk: where they are is told by the range sensor alone, and the one who is followed is left out.
    """

    def __init__(
        self, toolbox: Toolbox, settings: WalkingSettings, room: WalkingRoom, pace: float = PACE
    ) -> None:
        """Plan for a robot as it is now.

        Args:
            toolbox: What is believed and seen.
            settings: The robot's.
            room: What it takes with what it holds.
            pace: Share of the longest step.
        """
        self._toolbox, self._settings, self._room, self._pace = toolbox, settings, room, pace

    def to(self, body: PlanarPose, goal: PlanarPose) -> Stretch | None:
        """The way to a goal; None where there is none now.

        Args:
            body: Where the robot is, in the odometry frame.
            goal: Where it is to stand.
        """
        return self._find(body, goal, self._around(body, None))

    def behind(self, body: PlanarPose, person: tuple[float, float], distance_m: float) -> Stretch | None:
        """The way to somebody, and to face them; None where there is none now.

        It ends on this side of the person, or where the robot is if that is near enough. Where something
        stands there it ends beside that, or farther away.

        Args:
            body: Where the robot is, in the odometry frame.
            person: Place of the person there, m.
            distance_m: To keep.
        """
        x, y = person
        around = self._around(body, person)
        direct = math.atan2(y - body.y_m, x - body.x_m)
        if math.dist((x, y), (body.x_m, body.y_m)) <= distance_m:
            return self._find(body, PlanarPose(body.x_m, body.y_m, direct), around)
        for farther_m, aside in _STANDS:
            away_m, heading = distance_m + farther_m, direct + aside
            goal = PlanarPose(x - away_m * math.cos(heading), y - away_m * math.sin(heading), heading)
            if around.apart_m(goal, self._room.widest_m) >= _GOAL_M:
                return self._find(body, goal, around)
        return None

    def is_free(self, body: PlanarPose, stretch: Stretch, person: tuple[float, float] | None = None) -> bool:
        """Whether what is left of a stretch is as free as when it was planned.

        Who plans anew each time goes now to one side of something, now to the other.

        Args:
            body: Where the robot is, in the odometry frame.
            stretch: The way that it is on.
            person: Place of who is followed, if anybody is.
        """
        points = self._around(body, person).points
        return not blocked(stretch.left_from(body), points, stretch.clearance_m - _LESS_M)

    def _around(self, body: PlanarPose, person: tuple[float, float] | None) -> _Around:
        scene = self._toolbox.world.scene
        for thing in what_is_around(self._toolbox).things:
            if thing.is_person and thing.name in scene.objects:
                scene = scene.without_object(thing.name)
        obstacles = self._room.footprints(scene)
        seen = SeenPoints(self._toolbox.ranging)
        seen.look(body, lambda scan: without_held(self._toolbox, scan))
        points = seen.beside(obstacles)
        if person is not None:
            points = points[np.hypot(points[:, 0] - person[0], points[:, 1] - person[1]) > _PERSON_M]
        return _Around(scene, obstacles, points)

    def _find(self, body: PlanarPose, goal: PlanarPose, around: _Around) -> Stretch | None:
        line = _along(body, goal)
        straight = all(float(one.distance_m(line).min()) > _STRAIGHT_M for one in around.obstacles)
        if straight and not blocked((body, goal), around.points, _STRAIGHT_M + self._room.widest_m):
            return self._stretch((body, goal), around)
        way = WayFinder(self._settings, self._room, around.scene, around.points, 0.0).find(body, goal)
        if isinstance(way, NoWay):
            return None
        return self._stretch((*way.path, goal), around)

    def _stretch(self, path: tuple[PlanarPose, ...], around: _Around) -> Stretch:
        """The way with how near it comes to what is seen: so much has to be left of it later."""
        line = np.concatenate([_along(a, b) for a, b in pairwise(path)])
        away = line[:, None, :] - around.points[None, :, :]
        nearest_m = float(np.hypot(away[..., 0], away[..., 1]).min(initial=_STRAIGHT_M))
        return Stretch(PathSteering(self._settings, path, self._pace), nearest_m)


def _apart_m(a: PlanarPose, b: PlanarPose, place: PlanarPose) -> float:
    dx, dy = b.x_m - a.x_m, b.y_m - a.y_m
    length = max(dx * dx + dy * dy, 1e-12)
    share = min(max(((place.x_m - a.x_m) * dx + (place.y_m - a.y_m) * dy) / length, 0.0), 1.0)
    return math.hypot(a.x_m + share * dx - place.x_m, a.y_m + share * dy - place.y_m)


def _along(start: PlanarPose, end: PlanarPose) -> Array:
    count = max(2, math.ceil(start.distance_m(end) / _SAMPLE_M))
    share = np.linspace(0.0, 1.0, count)
    return np.column_stack(
        [start.x_m + share * (end.x_m - start.x_m), start.y_m + share * (end.y_m - start.y_m)]
    )
