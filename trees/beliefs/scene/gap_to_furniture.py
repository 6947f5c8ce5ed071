"""How far something is from a piece of furniture, along the floor."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Box, Shape
from kinematics.scene.planning_scene import SceneObject


def gap_to_furniture_m(item: SceneObject, odom_T_base: Transform) -> float:
    """From the robot's middle to the nearest edge of a solid, along the floor; infinite to what is no box.

    Args:
        item: The solid, in the odometry frame.
        odom_T_base: Pose of the robot's base, shape (4, 4).
    """
    return gap_to_solid_m(odom_T_base[:3, 3], item.world_T_object, item.shape)


def gap_to_solid_m(place_m: NDArray[np.float64], world_T_solid: Transform, shape: Shape) -> float:
    """The same from any place, shape (3,), to a solid with its pose, shape (4, 4), in one frame."""
    if not isinstance(shape, Box):
        return math.inf
    x, y, _ = ((place_m - world_T_solid[:3, 3]) @ world_T_solid[:3, :3]).tolist()
    size_x, size_y, _ = shape.size_m
    return math.hypot(max(abs(x) - 0.5 * size_x, 0.0), max(abs(y) - 0.5 * size_y, 0.0))
