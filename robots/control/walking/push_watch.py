"""Tells pushes from the knocks of single instants, for landings that move with a push."""

from __future__ import annotations

import math
from collections.abc import Mapping

from kinematics.model.robot_description import Hand
from kinematics.walking.pattern.dcm import Point
from kinematics.walking.pattern.pattern_sample import PatternSample

_MEAN_S = 0.03
"""A sole that rocks on its edge shows errors of 10 cm to and fro within this time; a push stays."""

_PUSH_M = 0.03
"""Any sole corrects less: a walk of 0.3 m/s shows 1.3 cm. Looking into it takes 0.18 ms a period."""


class PushWatch:
    """The mean of the DCM's error over the last instants, while one foot stands alone."""

    def __init__(self) -> None:
        """Nothing was felt."""
        self._x = self._y = 0.0

    @property
    def mean(self) -> Point:
        """Of the DCM's error, m."""
        return self._x, self._y

    def felt(
        self, error: Point, loads_n: Mapping[Hand, float], plan: PatternSample | None, period_s: float
    ) -> Point | None:
        """Take an error in; None if it is small, and while no foot is in the air or that one feels the floor.

        Args:
            error: The DCM as measured, less the plan's, m.
            loads_n: On each sole, 0 for less than what carries.
            plan: The plan's last instant.
            period_s: Since the one before.
        """
        share = -math.expm1(-period_s / _MEAN_S)
        self._x += share * (error[0] - self._x)
        self._y += share * (error[1] - self._y)
        if math.hypot(self._x, self._y) < _PUSH_M or plan is None or len(plan.carrying) != 1:
            return None
        if any(load > 0.0 for side, load in loads_n.items() if side not in plan.carrying):
            return None
        return self._x, self._y
