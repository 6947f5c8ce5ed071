"""Which way the head turns to look at a point, and which points a camera has in its picture."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array
from kinematics.geometry import poses
from kinematics.model.robot_model import RobotModel

# A point nearer to the edge of the picture than this share may be cut off.
IN_PICTURE = 0.9


def in_picture(
    points: Array, world_T_camera: poses.Transform, horizontal_rad: float, vertical_rad: float
) -> NDArray[np.bool_]:
    """Which points, shape (n, 3), a camera has well inside its picture."""
    x, y, z = world_T_camera[:3, :3].T @ (points - world_T_camera[:3, 3]).T
    wide, high = IN_PICTURE * np.tan([0.5 * horizontal_rad, 0.5 * vertical_rad])
    return np.asarray((z > 0.0) & (np.abs(x) <= wide * z) & (np.abs(y) <= high * z), dtype=np.bool_)


ITERATIONS = 4


def gaze_joints(model: RobotModel, q: Array, point: Array) -> dict[str, float]:
    """Pan and tilt that bring a world point, shape (3,), to the middle of the camera's picture.

    Inside the joints' limits; a point out of reach of the gaze gets the nearest direction. A camera that no
    neck aims needs none.
    """
    camera = model.description.camera
    if camera.neck is None:
        return {}
    return _turned_to(model, q, point, camera.neck, (-math.inf, math.inf))


def aiming_joints(model: RobotModel, q: Array, point: Array) -> dict[str, float]:
    """As ``gaze_joints``, with the trunk where it aims the camera in a neck's place."""
    trunk = model.description.camera.trunk
    if trunk is None:
        return gaze_joints(model, q, point)
    return _turned_to(model, q, point, (trunk.turn_joint, trunk.bow_joint), trunk.bow_rad)


def _turned_to(
    model: RobotModel, q: Array, point: Array, joints: tuple[str, str], tilt_rad: tuple[float, float]
) -> dict[str, float]:
    """Positions of two joints, one that pans and one that tilts within bounds, that look at a point."""
    pan, tilt = model.joint_index(joints[0]), model.joint_index(joints[1])
    margin = model.description.planning_margin_rad
    q = q.copy()
    place = point.tolist()
    bounds = [
        (7 + index, float(model.lower_rad[index]) + margin, float(model.upper_rad[index]) - margin)
        for index in (pan, tilt)
    ]
    column, low, high = bounds[1]
    bounds[1] = column, max(low, tilt_rad[0]), min(high, tilt_rad[1])
    frame = model.description.camera.frame
    for _ in range(ITERATIONS):
        # plain numbers: calls on arrays of three would take as long as the kinematics
        (a, b, c, p), (d, e, f, r), (g, h, i, s), _ = model.frame_pose(q, frame).tolist()
        u, v, w = place[0] - p, place[1] - r, place[2] - s
        x, y, z = a * u + d * v + g * w, b * u + e * v + h * w, c * u + f * v + i * w
        # the optical frame: x to the right, y down, z ahead; a positive pan turns left
        for (column, low, high), turn in zip(bounds, (-math.atan2(x, z), math.atan2(y, z)), strict=True):
            q[column] = min(max(float(q[column]) + turn, low), high)
    return {joints[0]: float(q[7 + pan]), joints[1]: float(q[7 + tilt])}
