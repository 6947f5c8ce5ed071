"""Where the camera looks, what it could see, and how to aim it."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from kinematics import poses
from kinematics.poses import Transform
from kinematics.robot_description import HANDS, CameraDescription
from kinematics.robot_model import RobotModel

Array = NDArray[np.float64]

# The two head joints act almost along the two angles of the error: a few steps converge.
_AIM_STEPS = 8
_DIFFERENCE_RAD = 1e-4


def off_axis_rad(odom_T_camera: Transform, point: Array) -> tuple[float, float]:
    """Angles of a point, shape (3,), to the right of and below the optical axis."""
    x, y, z = (poses.inverse(odom_T_camera) @ np.append(point, 1.0))[:3]
    return math.atan2(x, z), math.atan2(y, z)


def in_view(camera: CameraDescription, odom_T_camera: Transform, point: Array) -> bool:
    """Whether a point lies in the camera's field of view and range."""
    right, down = off_axis_rad(odom_T_camera, point)
    distance = float(np.linalg.norm(point - odom_T_camera[:3, 3]))
    return (
        abs(right) <= 0.5 * camera.horizontal_fov_rad
        and abs(down) <= 0.5 * camera.vertical_fov_rad
        and camera.range_m[0] <= distance <= camera.range_m[1]
    )


def behind_a_hand(model: RobotModel, q: Array, eye: Array, point: Array, within_m: float) -> bool:
    """Whether the line of sight from ``eye`` to ``point`` passes a TCP nearer than ``within_m``."""
    ray = point - eye
    for hand in HANDS:
        tcp = model.frame_pose(q, model.description.grippers[hand].tcp_frame)[:3, 3]
        along = float(np.clip((tcp - eye) @ ray / (ray @ ray), 0.0, 1.0))
        if float(np.linalg.norm(eye + along * ray - tcp)) < within_m:
            return True
    return False


def aim(model: RobotModel, q: Array, point: Array) -> Mapping[str, float]:
    """Positions of the camera's pan and tilt joint, rad, that bring a point nearest to the image centre.

    Gauss-Newton on the two angles of ``off_axis_rad`` with a numeric Jacobian, inside the planning
    limits of the joints; the rest of ``q``, shape (nq,), stays.
    """
    camera, margin = model.description.camera, model.description.planning_margin_rad
    joints = (camera.tilt_joint, camera.pan_joint)
    index = model.indices(joints)
    lower, upper = model.lower_rad[index] + margin, model.upper_rad[index] - margin

    def error(head: Array) -> Array:
        aimed = q.copy()
        aimed[7 + index] = head
        return np.array(off_axis_rad(model.frame_pose(aimed, camera.frame), point))

    head = np.clip(q[7 + index], lower, upper)
    for _ in range(_AIM_STEPS):
        now = error(head)
        jacobian = np.column_stack(
            [(error(head + d) - now) / _DIFFERENCE_RAD for d in _DIFFERENCE_RAD * np.eye(2)]
        )
        step = np.linalg.lstsq(jacobian, -now, rcond=None)[0]
        head = np.clip(head + step, lower, upper)
    return {joint: float(value) for joint, value in zip(joints, head, strict=True)}
