"""How far fingers may open beside a bar, so that they fit between what is around it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from kinematics.arrays import Array
from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from kinematics.model.robot_description import GripperDescription
from kinematics.scene.planning_scene import SceneObject

BESIDE_M = 0.005
"""Fingers stay so far from what is around a bar."""
BEHIND_FRONT_M = 0.10
"""So much of the fingers is looked at, from the TCP back."""
_STEP_M = 0.004
FLUSH_M = 0.015
"""What stands out by less than this before a front is flush with it: errors of both."""


def thick_m(gripper: GripperDescription) -> float:
    """Of a finger, along the opening."""
    return 2.0 * max(half[1] for half in gripper.pad_half_size_m)


def fitting_opening_m(
    gripper: GripperDescription, world_T_tcp: Array, around: Sequence[SceneObject], least_m: float
) -> float | None:
    """The widest opening at which fingers and what is between them are clear of what is around; else None.

    Fingers are boxes beside the pads, as thick as they are; what is around is the box about it.

    Args:
        gripper: The hand.
        world_T_tcp: Where it takes hold, shape (4, 4).
        around: What is there, in the same frame.
        least_m: No narrower than this.
    """
    near = [_box_of(item) for item in around]
    tip_m = gripper.pad_half_size_m[0][2] + gripper.closing_advance_m
    middle_m, half_m = 0.5 * (tip_m - BEHIND_FRONT_M), 0.5 * (tip_m + BEHIND_FRONT_M)
    middle = world_T_tcp @ poses.translation(middle_m, 0.0, 0.0)
    for opening_m in np.arange(gripper.max_opening_m, least_m, -_STEP_M):
        across_m = 0.5 * float(opening_m) + thick_m(gripper) + BESIDE_M
        half = np.array([half_m, across_m, gripper.fingers_half_width_m + BESIDE_M])
        if not any(boxes_meet(middle, half, *box) for box in near):
            return float(opening_m)
    return None


def stands_out(item: SceneObject, front: SceneObject, outward: Array) -> bool:
    """Whether something is farther out than the front that it is beside, and not flush with it.

    Args:
        item: What is beside.
        front: A door or drawer.
        outward: The way in which it opens, unit vector, shape (3,).
    """
    return _farthest_m(item, outward) > _farthest_m(front, outward) + FLUSH_M


def _farthest_m(item: SceneObject, way: Array) -> float:
    """How far a solid reaches along a way."""
    pose, half = _box_of(item)
    return float(pose[:3, 3] @ way + np.abs(pose[:3, :3].T @ way) @ half)


def _box_of(item: SceneObject) -> tuple[Array, Array]:
    shape = item.shape
    size = shape.size_m if isinstance(shape, Box) else (*2 * (2.0 * shape.radius_m,), shape.height_m)
    return item.world_T_object, 0.5 * np.array(size)


def boxes_meet(world_T_a: Array, half_a: Array, world_T_b: Array, half_b: Array) -> bool:
    """Whether two boxes have a point in common: no axis separates them (Gottschalk et al. 1996).

    Args:
        world_T_a: Pose of the middle of one, shape (4, 4).
        half_a: Its half-sizes, m, shape (3,).
        world_T_b: Pose of the middle of the other, shape (4, 4).
        half_b: Its half-sizes, m, shape (3,).
    """
    first, second = world_T_a[:3, :3], world_T_b[:3, :3]
    across = np.cross(first.T[:, None, :], second.T[None, :, :]).reshape(9, 3)
    axes = np.concatenate([first.T, second.T, across])
    axes = axes[np.linalg.norm(axes, axis=1) > 1e-9]  # parallel edges make no axis of their own
    apart = np.abs(axes @ (world_T_b[:3, 3] - world_T_a[:3, 3]))
    reach = np.abs(axes @ first) @ half_a + np.abs(axes @ second) @ half_b
    return bool(np.all(apart <= reach))
