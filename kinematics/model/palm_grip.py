"""What fingers that close on a palm do to a thing: they turn it along themselves, and push it out at last.

Fingers that meet between two pads do neither; for those nothing changes here.
"""

from __future__ import annotations

import math

import numpy as np

from kinematics.arrays import Array
from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Box, Shape
from kinematics.model.robot_description import GripperDescription

_ALIGNED = 1e-9
LEVEL_SINE = math.sin(math.radians(5.0))
"""Of a hand that comes in: one that leans by less hardly turns what it closes on."""


def is_steep(gripper: GripperDescription, world_T_tcp: Transform) -> bool:
    """Whether a hand that closes there turns what stands between its fingers by nobody knows how much."""
    return gripper.palm_side_m is not None and abs(float(world_T_tcp[2, 0])) > LEVEL_SINE


def way_to_bar(gripper: GripperDescription) -> Array:
    """The direction in which a hand comes to a bar: unit vector in its TCP frame, shape (3,).

    Fingers that meet between two pads come along themselves. A palm is laid on the bar, and the fingers close
    behind it.
    """
    return np.asarray(poses.rotation_z(gripper.bar.approach_rad)[:, 0])


def held(gripper: GripperDescription, tcp_T_object: Transform) -> Transform:
    """Where a hand that has closed has a thing: its axis along the fingers', about the middle of the grip.

    Args:
        gripper: The hand's.
        tcp_T_object: Before it closed, but for the way along the opening.
    """
    axis = tcp_T_object[:3, 2]
    along = np.array([0.0, 0.0, math.copysign(1.0, float(axis[2]))])
    across = np.cross(axis, along)
    sine = float(np.linalg.norm(across))
    if gripper.palm_side_m is None or sine < _ALIGNED:
        return tcp_T_object
    turn = poses.rotation_from_vector(across / sine * math.atan2(sine, float(axis @ along)))
    return poses.transform(turn @ tcp_T_object[:3, :3], turn @ tcp_T_object[:3, 3])


def released(gripper: GripperDescription, shape: Shape, tcp_T_object: Transform) -> Transform:
    """Where a thing that stands is once the fingers have opened.

    Args:
        gripper: The hand's.
        shape: Of the thing.
        tcp_T_object: Where the hand holds it.
    """
    width_m = min(shape.size_m[:2]) if isinstance(shape, Box) else 2.0 * shape.radius_m
    return poses.translation(*gripper.pushed_m(width_m, float(tcp_T_object[0, 3])), 0.0) @ tcp_T_object
