"""Ankles that give way while the robot walks, so that a sole lies on what it has landed on."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from kinematics.arrays import Array
from kinematics.model.robot_model import RobotModel
from robots.interface.hardware import ServoGains, WalkingGains

_BLEND_S = 0.3
"""From stiff to soft, and back."""


class SoftAnkles:
    """Efforts that take the difference between the servos' stiffness and a softer one away.

    The servos' gains stay as they are: ``-(k - k_soft) (q_told - q) - (d - d_soft) (v_told - v)``, with the
    newest readings. One period late, that adds a little damping and inertia, and nothing else.
    """

    def __init__(self, model: RobotModel, gains: Mapping[str, ServoGains], soft: WalkingGains) -> None:
        """Be stiff.

        Args:
            model: The robot; the last two joints of each leg are its ankle's.
            gains: Of the servos, by joint.
            soft: How stiff its ankles are while it walks.
        """
        groups = model.description.groups
        names = [name for leg in ("left_leg", "right_leg") for name in groups[leg][-2:]]
        self._joints = model.indices(names)
        self._stiffness = np.array([gains[name].stiffness - soft.ankle_stiffness_nm for name in names])
        self._damping = np.array([gains[name].damping - soft.ankle_damping_nms for name in names])
        self._share = 0.0

    def efforts(
        self, told: tuple[Array, Array], felt: tuple[Array, Array], soft: bool, period_s: float
    ) -> Array:
        """What to add to the efforts of the body joints, Nm, shape (n,).

        Args:
            told: Positions and velocities that are commanded, shape (n,) each.
            felt: The same as they were read.
            soft: Whether the ankles are to give way; they become so, and stiff again, by and by.
            period_s: Since the last instant.
        """
        step = period_s / _BLEND_S
        self._share = min(max(self._share + (step if soft else -step), 0.0), 1.0)
        efforts = np.zeros(len(told[0]))
        if self._share > 0.0:
            k = self._joints
            away = self._stiffness * (told[0][k] - felt[0][k]) + self._damping * (told[1][k] - felt[1][k])
            efforts[k] = -self._share * away
        return efforts
