"""What hands hold, as a walk has to mind it: how far it stands out, and how low it hangs."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from kinematics.arrays import Array
from kinematics.geometry import poses
from kinematics.geometry.planar import PlanarPose
from kinematics.geometry.shapes import Ball, Box, Shape
from kinematics.model.robot_model import RobotModel
from kinematics.scene.planning_scene import AttachedBody

_ROUND = 16
"""Corners that a circle is drawn with; they lie on a circle around it, 2 % wider."""


@dataclass(frozen=True, slots=True)
class Load:
    """Everything that is held, with the hands that hold it; lengths in m, in a level frame at the base.

    Attributes:
        from_m: Height of its lowest point over the floor.
        front_m, back_m: How far it stands out ahead of the base and behind it.
        half_width_m: How far it stands out to the side where it does so most.
        radius_m: Of the circle around the base in which it turns with the body.
    """

    from_m: float
    front_m: float
    back_m: float
    half_width_m: float
    radius_m: float


def load_of(model: RobotModel, q: Array, held: Iterable[AttachedBody], hand_m: float) -> Load | None:
    """The load of a robot in a configuration, or None with empty hands.

    Args:
        model: The robot.
        q: Configuration, shape (nq,), base in a frame whose floor is at height 0.
        held: What hangs on its hands.
        hand_m: Radius of a ball about the frame that holds something, in which the hand is, m.
    """
    yaw = poses.yaw_of(poses.rotation_from_quaternion(q[3:7]))
    level_T_world = poses.inverse(PlanarPose(float(q[0]), float(q[1]), yaw).transform())
    solids: list[tuple[poses.Transform, Shape]] = []
    for body in held:
        level_T_hand = level_T_world @ model.frame_pose(q, body.frame)
        solids += [(level_T_hand, Ball(hand_m)), (level_T_hand @ body.frame_T_object, body.body.shape)]
    if not solids:
        return None
    points = np.concatenate([_outline(pose, shape) for pose, shape in solids])
    x, y, z = points.T
    return Load(
        float(z.min()),
        float(x.max()),
        float(-x.min()),
        float(np.abs(y).max()),
        float(np.hypot(x, y).max()),
    )


def _outline(pose: poses.Transform, shape: Shape) -> Array:
    """Points, shape (n, 3), whose hull holds a solid at a pose."""
    if isinstance(shape, Box):
        signs = np.array(np.meshgrid(*((-1.0, 1.0),) * 3)).reshape(3, -1).T
        local = 0.5 * signs * shape.size_m
    else:
        turns = 2.0 * math.pi * np.arange(_ROUND) / _ROUND
        ring = np.column_stack([np.cos(turns), np.sin(turns)]) * shape.radius_m / math.cos(math.pi / _ROUND)
        half_m = 0.5 * shape.height_m
        local = np.concatenate(
            [np.column_stack([ring, np.full(_ROUND, side * half_m)]) for side in (-1.0, 1.0)]
        )
    turned = local if isinstance(shape, Ball) else local @ pose[:3, :3].T
    return np.asarray(turned + pose[:3, 3])
