"""The next stretch of a walk towards somebody who walks: straight there, or around what stands between."""

from __future__ import annotations

import math

import numpy as np

from kinematics.arrays import Array
from kinematics.geometry.planar import PlanarPose
from kinematics.model.walking_settings import WalkingSettings
from kinematics.walking.pattern.steering import PACE, PathSteering
from kinematics.walking.route.path_planning import blocked
from kinematics.walking.route.room import WalkingRoom
from kinematics.walking.route.ways import WayFinder
from trees.readings.around import what_is_around
from trees.skills.walking.scan_without_load import without_held
from trees.skills.walking.seen_points import SeenPoints
from trees.toolbox import Toolbox

_STRAIGHT_M = 0.60
"""A straight stretch stays so far from everything; where there is less room a way is planned."""
_PERSON_M = 0.50
"""What is seen so near to the person is the person."""
_SAMPLE_M = 0.05


def goal_behind(body: PlanarPose, person: tuple[float, float], distance_m: float) -> PlanarPose:
    """Where to stand, facing the person: on this side, or here where that is nearer already.

    Args:
        body: Where the robot is, in the odometry frame.
        person: Place of the person there, m.
        distance_m: To keep.
    """
    x, y = person
    heading = math.atan2(y - body.y_m, x - body.x_m)
    if math.dist((x, y), (body.x_m, body.y_m)) <= distance_m:
        return PlanarPose(body.x_m, body.y_m, heading)
    return PlanarPose(x - distance_m * math.cos(heading), y - distance_m * math.sin(heading), heading)


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
        self.silent = False

    def find(
        self, body: PlanarPose, goal: PlanarPose, person: tuple[float, float] | None = None
    ) -> PathSteering | None:
        """The way to a goal; None where there is none now.

        Args:
            body: Where the robot is.
            goal: Where it is to go.
            person: Who is followed; what is seen there is no obstacle.
        """
        around = what_is_around(self._toolbox)
        scene = self._toolbox.world.scene
        for thing in around.things:
            if thing.is_person and thing.name in scene.objects:
                scene = scene.without_object(thing.name)
        obstacles = self._room.footprints(scene)
        seen = SeenPoints(self._toolbox.ranging)
        seen.look(body, lambda scan: without_held(self._toolbox, scan))
        self.silent = seen.silent
        points = seen.beside(obstacles)
        if person is not None and len(points):
            points = points[np.hypot(points[:, 0] - person[0], points[:, 1] - person[1]) > _PERSON_M]
        line = _along(body, goal)
        straight = all(float(one.distance_m(line).min()) > _STRAIGHT_M for one in obstacles)
        if straight and not blocked((body, goal), points, _STRAIGHT_M + self._room.widest_m):
            return PathSteering(self._settings, (body, goal), self._pace)
        way = WayFinder(self._settings, self._room, scene, points, 0.0).find(body, goal)
        path = getattr(way, "path", None)
        return None if path is None else PathSteering(self._settings, (*path, goal), self._pace)


def _along(start: PlanarPose, end: PlanarPose) -> Array:
    count = max(2, math.ceil(start.distance_m(end) / _SAMPLE_M))
    share = np.linspace(0.0, 1.0, count)
    return np.column_stack(
        [start.x_m + share * (end.x_m - start.x_m), start.y_m + share * (end.y_m - start.y_m)]
    )
