"""What of a top has been looked at: where nothing is known to stand, something unseen may stand."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from kinematics.arrays import Array
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Box
from kinematics.model.camera_description import CameraDescription
from kinematics.scene.planning_scene import SceneObject
from trees.beliefs.sight.sight import Glimpse

# Beside an object's foot: an opening finger sweeps 4 cm beyond it, and what stands farther out than this
# reaches in by 4 cm at most.
AROUND_M = 0.10
_DIRECTIONS = 8
# The hand comes from the robot's side, its wrist so far behind and straight or slanting.
_TOWARDS_ROBOT_M = 0.20
_SLANTING_RAD = (0.0, 0.7, -0.7)
# What stands on a top is seen a little above it.
ABOVE_M = 0.05


@dataclass(frozen=True, slots=True)
class SightOfTops:
    """Tells which parts of tops the looks so far have shown; elsewhere something may stand unseen.

    Attributes:
        glimpses: The looks that were taken.
        camera: What the camera can see from where it is.
        hidden_m: A line of sight that passes a part of the robot nearer than this may be blocked.
    """

    glimpses: tuple[Glimpse, ...]
    camera: CameraDescription
    hidden_m: float

    def shows(self, point: Array) -> bool:
        """Whether any look would have shown something at a point, shape (3,)."""
        return any(glimpse.shows(self.camera, point, self.hidden_m) for glimpse in self.glimpses)

    def about(self, top: SceneObject, radius_m: float, odom_T_base: Transform) -> Callable[[Array], bool]:
        """Tells of places on a top, shape (3,), whether all that stands about them would have been seen.

        Args:
            top: Something flat.
            radius_m: Of the foot of what is to stand there.
            odom_T_base: Pose of the robot's base, shape (4, 4): the hand comes from there.
        """

        def known(place: Array) -> bool:
            return all(self.shows(point) for point in _about(place, radius_m, top, odom_T_base))

        return known


def _about(place: Array, radius_m: float, top: SceneObject, odom_T_base: Transform) -> Iterator[Array]:
    middle = place + np.array([0.0, 0.0, ABOVE_M])
    yield middle
    way = odom_T_base[:2, 3] - middle[:2]
    heading = math.atan2(way[1], way[0])
    around = [(radius_m + AROUND_M, 2.0 * math.pi * k / _DIRECTIONS) for k in range(_DIRECTIONS)]
    for far_m, turn in (*around, *((_TOWARDS_ROBOT_M, turn) for turn in _SLANTING_RAD)):
        offset = far_m * np.array([math.cos(heading + turn), math.sin(heading + turn), 0.0])
        if is_over(top, middle + offset):
            yield middle + offset


def is_over(top: SceneObject, point: Array) -> bool:
    """Whether a point, shape (3,), is over a top; beside it nothing stands on it."""
    if not isinstance(top.shape, Box):
        return True
    local: list[float] = (point - top.world_T_object[:3, 3]).dot(top.world_T_object[:3, :3]).tolist()
    length_m, width_m, _ = top.shape.size_m
    return abs(local[0]) <= 0.5 * length_m and abs(local[1]) <= 0.5 * width_m
