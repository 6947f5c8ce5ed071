"""Where in a hand the weight hangs, felt in the efforts of its arm and the trunk at rest.

A weight beside the middle of the hand turns the wrist: efforts that hold a mass ``m`` at a place ``c`` of
the hand are ``m (b + B c)``, with ``b`` for the mass in the middle, and ``B`` for what each metre beside it
adds. Along gravity nothing is felt. Mass and place are found together by the iterated extended Kalman update
(Bell and Cathey, 1993), which for one measurement is Gauss-Newton's least squares with a prior.
"""

from __future__ import annotations

import numpy as np

from kinematics.arrays import Array
from kinematics.estimation.held_mass import HeldMass

ARM_ERROR_NM, TORSO_ERROR_NM = 0.03, 0.08
"""What the mean effort of a held posture is wrong by: the model of the masses, and a body that sways. Noise
is averaged away by then."""
_MASS_KG = 10.0
"""What may be held, before anything was felt."""
_ROUNDS = 6


class HeldCentre:
    """Finds the place of a weight in one hand, from the mean of what is felt while the hand rests."""

    def __init__(self, scales: HeldMass) -> None:
        """Have felt nothing.

        Args:
            scales: Know the robot, and which joints carry the hand.
        """
        self._scales = scales
        self._count = 0
        self._felt: Array = np.zeros(0)
        self._middle: Array = np.zeros(0)
        self._beside: Array = np.zeros((0, 3))

    def add(self, q: Array, v: Array, effort: Array, count: int = 1) -> None:
        """Take readings at rest in, as of ``HeldMass.add``."""
        scales = self._scales
        middle = scales.lever(q, np.zeros(3))
        beside = np.column_stack([scales.lever(q, axis) - middle for axis in np.eye(3)])
        share = count / (self._count + count)
        if not self._count:
            self._felt, self._middle, self._beside = np.zeros_like(middle), middle, beside
        self._felt = self._felt + share * (scales.residual(q, v, effort) - self._felt)
        self._middle = self._middle + share * (middle - self._middle)
        self._beside = self._beside + share * (beside - self._beside)
        self._count += count

    def centre(self, expected_m: Array, covariance_m2: Array) -> tuple[Array, Array] | None:
        """The place of the weight in the TCP's frame, and its covariance; None before anything was felt.

        Args:
            expected_m: Where it is expected, shape (3,), by senses other than the efforts.
            covariance_m2: Of that, shape (3, 3).
        """
        if not self._count:
            return None
        arm = len(self._felt) - self._scales.trunk_joints
        error = np.full(len(self._felt), TORSO_ERROR_NM)
        error[:arm] = ARM_ERROR_NM
        weight = error**-2
        prior = np.zeros((4, 4))
        prior[0, 0], prior[1:, 1:] = _MASS_KG**-2, np.linalg.inv(covariance_m2)
        x = np.array([0.0, *expected_m])
        start = x.copy()
        information = prior
        for _ in range(_ROUNDS):
            mass, place = x[0], x[1:]
            jacobian = np.column_stack([self._middle + self._beside @ place, mass * self._beside])
            off = self._felt - mass * (self._middle + self._beside @ place)
            information = (jacobian.T * weight) @ jacobian + prior
            x = x + np.linalg.solve(information, (jacobian.T * weight) @ off + prior @ (start - x))
        covariance = np.linalg.inv(information)[1:, 1:]
        return np.asarray(x[1:], np.float64), np.asarray(covariance, np.float64)
