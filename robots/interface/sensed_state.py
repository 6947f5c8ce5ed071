"""The sensors' readings with the configuration that is estimated from them."""

from __future__ import annotations

from collections.abc import Callable

from kinematics.arrays import Array
from robots.interface.robot import RobotState


class SensedState:
    """What the robot knows about itself at one instant.

    The configuration is computed when it is first asked for: one is made each control period, and
    few are looked at.
    """

    __slots__ = ("_estimate", "_q", "_readings")

    def __init__(
        self, readings: RobotState | Callable[[], RobotState], estimate: Callable[[], Array]
    ) -> None:
        """Keep readings.

        Args:
            readings: The sensors' readings, or what gives them when they are first asked for.
            estimate: Gives ``q``; the answers of both must depend on nothing that changes later.
        """
        self._readings = readings
        self._estimate = estimate
        self._q: Array | None = None

    @property
    def readings(self) -> RobotState:
        """The sensors' readings."""
        if not isinstance(self._readings, RobotState):
            self._readings = self._readings()
        return self._readings

    @property
    def q(self) -> Array:
        """Estimated configuration of the planning model, shape (nq,).

        Base pose in the odometry frame from encoders, IMU and stance feet, then the encoders' joint
        positions.
        """
        if self._q is None:
            self._q = self._estimate()
        return self._q
