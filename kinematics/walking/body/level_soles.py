"""The level soles with which a walk begins where a robot stands on ones that are tilted."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from kinematics.arrays import Array
from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import Stance
from kinematics.model.standing_robot import StandingRobot
from kinematics.standing.leg_ik import LegIk

_LEVEL = 1.0 - 1e-9
"""Cosine of what counts as level: 0.04 mrad."""


def levelled(
    model: RobotModel, q: Array, soles: Mapping[str, Transform]
) -> tuple[dict[str, Transform], Array]:
    """Soles turned level about their ankles, and the legs over them with the base where it is.

    Args:
        model: The robot.
        q: Configuration, shape (nq,).
        soles: By frame, where they stand, shape (4, 4) each.

    Returns:
        The soles, and the configuration, shape (nq,); both as they are where all soles are level.
    """
    if all(pose[2, 2] >= _LEVEL for pose in soles.values()):
        return dict(soles), q
    found = {}
    for frame, pose in soles.items():
        turn = poses.rotation_z(poses.yaw_of(pose[:3, :3]))
        ankle_m = model.pin.frames[model.frame_id(frame)].placement.inverse().translation
        found[frame] = poses.transform(turn, pose[:3, :3] @ ankle_m + pose[:3, 3] - turn @ ankle_m)
    legs = q[np.newaxis].copy()
    LegIk(StandingRobot(model, Stance(tuple(found.items())))).fill(legs)
    return found, legs[0]
