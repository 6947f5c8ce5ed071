"""Normal estimates that take measurements in, and tell how far off a measurement is.

The update is Kalman's (R. E. Kalman, 1960) in the form of Joseph, which keeps the covariance symmetric and
positive whatever is rounded. A measurement is compared with the estimate by the distance of Mahalanobis of
its innovation, which for normal errors has the chi-squared distribution with as many degrees of freedom as
the measurement has numbers (Bar-Shalom, Li and Kirubarajan, *Estimation with Applications to Tracking and
Navigation*, 2001, section 5.4).
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from kinematics.arrays import Array, Sealed

FALSE_ALARM = 0.004
"""Chance that senses which agree are taken to disagree, for each comparison. A pick makes about three."""
_QUANTILES = {1: 8.284, 2: 11.043, 3: 13.316, 4: 15.366}
"""Of the chi-squared distribution at 1 - FALSE_ALARM, by the degrees of freedom."""


@dataclass(frozen=True, slots=True)
class Measurement(Sealed):
    """What one sense tells of a quantity: ``value = model @ quantity + noise``.

    Attributes:
        source: Which sense, for people: "head camera", "left fingers".
        stamp_s: When it was so, not when it was told.
        value: What was measured, shape (m,).
        covariance: Of the noise, shape (m, m).
        model: Which mixture of the quantity's numbers is measured, shape (m, n).
    """

    source: str
    stamp_s: float
    value: Array
    covariance: Array
    model: Array


@dataclass(frozen=True, slots=True)
class Innovation(Sealed):
    """By how much a measurement differs from what was expected, and how much it may.

    Attributes:
        source: Which sense.
        difference: Measured less expected, shape (m,).
        covariance: Of the difference, if the senses agree, shape (m, m).
    """

    source: str
    difference: Array
    covariance: Array

    @property
    def distance(self) -> float:
        """Of Mahalanobis, squared."""
        return float(self.difference @ np.linalg.solve(self.covariance, self.difference))

    @property
    def size(self) -> float:
        """Length of the difference, in the measurement's unit."""
        return float(np.linalg.norm(self.difference))

    @property
    def sigma(self) -> float:
        """Standard deviation of the difference along its own direction, if the senses agree."""
        if self.size == 0.0:
            return math.sqrt(float(np.max(np.diag(self.covariance))))
        along = self.difference / self.size
        return math.sqrt(float(along @ self.covariance @ along))

    @property
    def disagrees(self) -> bool:
        """Whether so much differs by chance in fewer than ``FALSE_ALARM`` of the cases."""
        return self.distance > _QUANTILES[len(self.difference)]


@dataclass(frozen=True, slots=True)
class Gaussian(Sealed):
    """A normal estimate of some numbers.

    Attributes:
        mean: Shape (n,).
        covariance: Shape (n, n).
    """

    mean: Array
    covariance: Array

    def innovation(self, measured: Measurement) -> Innovation:
        """How far a measurement is from the estimate."""
        model = measured.model
        return Innovation(
            measured.source,
            measured.value - model @ self.mean,
            model @ self.covariance @ model.T + measured.covariance,
        )

    def updated(self, measured: Measurement) -> Gaussian:
        """The estimate with a measurement taken in."""
        model, innovation = measured.model, self.innovation(measured)
        gain = np.linalg.solve(innovation.covariance, model @ self.covariance).T
        kept = np.eye(len(self.mean)) - gain @ model
        covariance = kept @ self.covariance @ kept.T + gain @ measured.covariance @ gain.T
        return Gaussian(self.mean + gain @ innovation.difference, covariance)
