"""How far the robot stands from a piece of furniture."""

from __future__ import annotations

import math

from kinematics.poses import Transform
from kinematics.scene import SceneObject
from kinematics.shapes import Box


def gap_to_furniture_m(item: SceneObject, odom_T_base: Transform) -> float:
    """From the robot's middle to the nearest edge of a solid, along the floor; infinite to what is no box.

    Args:
        item: The solid, in the odometry frame.
        odom_T_base: Pose of the robot's base, shape (4, 4).
    """
    if not isinstance(item.shape, Box):
        return math.inf
    away = odom_T_base[:3, 3] - item.world_T_object[:3, 3]
    x, y, _ = (away @ item.world_T_object[:3, :3]).tolist()
    size_x, size_y, _ = item.shape.size_m
    return math.hypot(max(abs(x) - 0.5 * size_x, 0.0), max(abs(y) - 0.5 * size_y, 0.0))
