"""Solids of furniture: which are one piece, and how far something is from them along the floor."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Box, Shape
from kinematics.scene.planning_scene import SceneObject
from trees.beliefs.scene.scene_update import kind_of

_WITHIN_M = 1.0


def are_one_piece(first: SceneObject, second: SceneObject) -> bool:
    """Solids of one kind near each other: they have the same word, and numbers apart."""
    return belong_together(first.name, first.world_T_object[:3, 3], second.name, second.world_T_object[:3, 3])


def belong_together(name: str, place_m: Array, other: str, there_m: Array) -> bool:
    """The same of names and places, shape (3,), in any one frame."""
    (x, y, _), (there_x, there_y, _) = place_m.tolist(), there_m.tolist()
    return kind_of(name) == kind_of(other) and math.hypot(x - there_x, y - there_y) <= _WITHIN_M


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
