"""Judges each setpoint of a guarded motion against the bounds that the motion declared."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array
from robots.control.gate.refusal import Limit, Refusal
from robots.control.guarded.guarded_motion import MotionBounds
from robots.interface.robot import RobotState

_ROUNDING = 1e-9


class OnlineChecker:
    """Watches one guarded motion while it runs."""

    def __init__(self, bounds: MotionBounds, indices: NDArray[np.intp]) -> None:
        """Watch a motion.

        Args:
            bounds: What it promised.
            indices: Where ``bounds.joints`` are among the actuated joints.
        """
        self._bounds = bounds
        self._indices = indices

    def judge(self, elapsed_s: float, q: Array, v: Array, state: RobotState) -> Refusal | None:
        """Judge one setpoint for ``bounds.joints`` and the efforts measured on them.

        Args:
            elapsed_s: Since the motion began.
            q, v: Setpoint, one entry for each of ``bounds.joints``.
            state: The newest readings.
        """
        bounds = self._bounds
        count = len(bounds.joints)
        for values in (q, v):
            if values.shape != (count,):
                return Refusal(Limit.SHAPE, bounds.joints[0], float(values.size), float(count))
        if elapsed_s > bounds.duration_s + _ROUNDING:
            return Refusal(Limit.DURATION, bounds.joints[0], elapsed_s, bounds.duration_s)
        efforts = state.effort[self._indices]
        for limit, values, lower, upper in (
            (Limit.POSITION, q, bounds.lower_rad, bounds.upper_rad),
            (Limit.VELOCITY, v, -bounds.velocity, bounds.velocity),
            (Limit.MEASURED_EFFORT, efforts, -bounds.effort, bounds.effort),
        ):
            # written so that a value that is not a number counts as outside
            outside = ~((values >= lower - _ROUNDING) & (values <= upper + _ROUNDING))
            if outside.any():
                joint = int(np.argmax(outside))
                value = float(values[joint])
                if not np.isfinite(value):
                    return Refusal(Limit.NOT_FINITE, bounds.joints[joint], value, 0.0)
                bound = float(lower[joint] if value < lower[joint] else upper[joint])
                return Refusal(limit, bounds.joints[joint], value, bound)
        return None
