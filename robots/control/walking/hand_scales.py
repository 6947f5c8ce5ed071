"""What hangs on the hands, weighed by the efforts of arms and trunk while the robot stands."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from kinematics.arrays import Array
from kinematics.estimation.hand_force import HandForce
from kinematics.model.robot_description import Hand
from kinematics.model.robot_model import RobotModel

_GRAVITY_M_S2 = 9.81
_TIME_S = 0.5
"""Efforts are averaged over this."""
_LEAST_KG = 0.2
"""Less than this is within the errors of the efforts: 1 N at rest, and noise."""
_MOST_KG = 12.0
"""More than this is no load but a hand that presses on something."""


class HandScales:
    """Weighs what hangs on the hands: averages the arms' efforts at rest, and turns them into masses."""

    def __init__(self, model: RobotModel, period_s: float) -> None:
        """Have weighed nothing.

        Args:
            model: The robot, with empty hands.
            period_s: The control period.
        """
        self._model = model
        viscous = model.description.joint_viscosity_nms_rad
        self._hands = {hand: HandForce(model, hand, viscous) for hand in sorted(model.description.grippers)}
        self._share = period_s / _TIME_S
        self._efforts = np.zeros(len(model.joints))
        self._rested = 0

    def sense(self, effort: Array) -> None:
        """Take the efforts of a period of rest in, Nm, shape (n,)."""
        self._rested += 1
        self._efforts += max(1.0 / self._rested, self._share) * (effort - self._efforts)

    def moved(self) -> None:
        """The body has moved since: what was averaged is over."""
        self._rested = 0

    def masses_kg(self, q: Array) -> Mapping[Hand, float]:
        """What hangs on each hand that carries something.

        Args:
            q: Configuration at rest, shape (nq,).
        """
        found: dict[Hand, float] = {}
        if not self._rested:
            return found
        still = np.zeros(self._model.nv)
        for hand, force in self._hands.items():
            mass_kg = -float(force.estimate(q, still, still, self._efforts)[2]) / _GRAVITY_M_S2
            if _LEAST_KG <= mass_kg <= _MOST_KG:
                found[hand] = mass_kg
        return found
