"""Ankles that stay as the floor has turned them when a walk comes to its end."""

from __future__ import annotations

import numpy as np

from kinematics.arrays import Array
from kinematics.model.robot_model import RobotModel
from kinematics.walking.pattern.pattern_sample import Phase

_LEAST_RAD = 0.008
"""On a level floor soft ankles yield by less."""
_TIME_S = 0.08
_MOST_RAD_S, _MOST_RAD_S2 = 0.6, 8.0


class FittedAnkles:
    """What the legs are commanded beside the plan, which takes every sole for level.

    A robot that stands stiffly with its ankles as for a level floor leans as its soles do, and tips over the
    edge of the plate that it stands on.
    """

    def __init__(self, model: RobotModel, offset_rad: Array, period_s: float) -> None:
        """Stand.

        Args:
            model: The robot; the last two joints of each leg are its ankle's.
            offset_rad: Of the body joints, from a plan that begins with level soles, shape (n,).
            period_s: The control period.
        """
        groups = model.description.groups
        self._joints = model.indices([name for leg in ("left_leg", "right_leg") for name in groups[leg]])
        self._ankle = np.tile((0.0, 0.0, 0.0, 0.0, 1.0, 1.0), 2)
        self._period_s = period_s
        self.offset_rad = offset_rad[self._joints]
        self._rate = np.zeros(len(self._joints))

    @property
    def at_rest(self) -> bool:
        """Whether nothing moves beside the plan."""
        return not self._rate.any()

    def follow(self, phase: Phase, told_rad: Array, felt_rad: Array) -> None:
        """Go to where the ankles are at the end of a walk, stay at rest, and leave it on the way.

        Args:
            phase: What the feet do.
            told_rad: Positions by the plan, shape (n,).
            felt_rad: The same as they were read.
        """
        dt, fitting = self._period_s, phase in (Phase.CLOSE, Phase.SETTLE)
        if not fitting and not self._rate.any() and not self.offset_rad.any():
            return
        if phase is Phase.REST:
            missing = np.zeros(len(self._joints))
        elif fitting:
            off = felt_rad[self._joints] - told_rad[self._joints] - self.offset_rad
            missing = self._ankle * (off - np.clip(off, -_LEAST_RAD, _LEAST_RAD))
        else:
            missing = -self.offset_rad
        speed = np.clip(missing / _TIME_S, -_MOST_RAD_S, _MOST_RAD_S)
        change = np.clip(speed - self._rate, -_MOST_RAD_S2 * dt, _MOST_RAD_S2 * dt)
        self.offset_rad = self.offset_rad + dt * (self._rate + 0.5 * change)
        self._rate = self._rate + change

    def add_to(self, q: Array, v: Array) -> None:
        """Add it to positions and velocities of the body joints, shape (n,) each."""
        q[self._joints] += self.offset_rad
        v[self._joints] += self._rate
