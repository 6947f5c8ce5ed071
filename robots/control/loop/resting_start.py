"""What a robot that is found at rest is taken to be commanded."""

from __future__ import annotations

import numpy as np

from kinematics.arrays import Array
from kinematics.model.robot_description import Hand
from kinematics.model.robot_model import RobotModel

_AT_HOME_RAD = 0.02
"""Joints found nearer to the home posture than this are taken to rest there: sag and noise."""


def resting_start(model: RobotModel, measured: Array) -> tuple[Array, dict[Hand, float]]:
    """Configuration, shape (nq,), and finger positions, from measured joints, shape (actuated,)."""
    description = model.description
    home = np.array([description.home[name] for name in description.actuated])
    limits = np.array([description.limits[name].position for name in description.actuated])
    inside = np.clip(measured, limits[:, 0], limits[:, 1])
    joints = np.where(np.abs(measured - home) <= _AT_HOME_RAD, home, inside)
    by_name = dict(zip(description.actuated, joints.tolist(), strict=True))
    q = model.on_the_floor({name: by_name[name] for name in model.joints})
    fingers = {hand: description.grippers[hand].position_of(by_name) for hand in description.gripping_hands}
    return q, fingers
