"""Which way the head turns to look at a point."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from kinematics.robot_model import RobotModel

Array = NDArray[np.float64]

ITERATIONS = 4


def gaze_joints(model: RobotModel, q: Array, point: Array) -> dict[str, float]:
    """Pan and tilt that bring a world point, shape (3,), to the middle of the camera's picture.

    Inside the joints' limits; a point out of reach of the gaze gets the nearest direction.
    """
    camera = model.description.camera
    pan, tilt = model.joint_index(camera.pan_joint), model.joint_index(camera.tilt_joint)
    margin = model.description.planning_margin_rad
    q = q.copy()
    for _ in range(ITERATIONS):
        world_T_camera = model.frame_pose(q, camera.frame)
        x, y, z = world_T_camera[:3, :3].T @ (point - world_T_camera[:3, 3])
        # the optical frame: x to the right, y down, z ahead; a positive pan turns left
        for index, turn in ((pan, -np.arctan2(x, z)), (tilt, np.arctan2(y, z))):
            low, high = model.lower_rad[index] + margin, model.upper_rad[index] - margin
            q[7 + index] = np.clip(q[7 + index] + turn, low, high)
    return {camera.pan_joint: float(q[7 + pan]), camera.tilt_joint: float(q[7 + tilt])}
