"""The sensors' readings with the configuration that is estimated from them."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from robots.interface import RobotState

Array = NDArray[np.float64]


class SensedState:
    """What the robot knows about itself at one instant.

    The configuration is computed when it is first asked for: one is made each control period, and
    few are looked at.

    Attributes:
        readings: The sensors' readings.
    """

    __slots__ = ("_estimate", "_q", "readings")

    def __init__(self, readings: RobotState, estimate: Callable[[], Array]) -> None:
        """Keep readings.

        Args:
            readings: The sensors' readings.
            estimate: Gives ``q``; its answer must depend on nothing that changes later.
        """
        self.readings = readings
        self._estimate = estimate
        self._q: Array | None = None

    @property
    def q(self) -> Array:
        """Estimated configuration of the planning model, shape (nq,).

        Base pose in the odometry frame from encoders, IMU and stance feet, then the encoders' joint
        positions.
        """
        if self._q is None:
            self._q = self._estimate()
        return self._q
