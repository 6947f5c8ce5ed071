"""One joint's setpoint on its way to a target, within speed and acceleration limits."""

from __future__ import annotations

import math

_SHARE = 0.98
"""Of the limits that is used, so that rounding never touches them."""
_ARRIVED_RAD = 1e-9
"""Nearer than this is there."""


class JointTracker:
    """Second-order profile of one joint, made as it goes; the target may change at any time.

    Attributes:
        q_rad, v_rad_s: The setpoint now.
    """

    __slots__ = ("_acceleration", "_period_s", "_velocity", "q_rad", "v_rad_s")

    def __init__(self, q_rad: float, velocity: float, acceleration: float, period_s: float) -> None:
        """Rest at a position; limits in rad/s and rad/s^2, ``period_s`` between two steps."""
        self.q_rad, self.v_rad_s = q_rad, 0.0
        self._velocity = _SHARE * velocity
        self._acceleration = _SHARE * acceleration
        self._period_s = period_s

    def step_towards(self, target_rad: float) -> None:
        """Advance one period; at the target it stays exactly at rest."""
        dt, most = self._period_s, self._acceleration
        gap = target_rad - self.q_rad
        if abs(gap) < _ARRIVED_RAD and abs(self.v_rad_s) < _ARRIVED_RAD / dt:
            self.v_rad_s = 0.0
            return
        # The fastest speed from which, after this period, the joint can still brake within what is
        # left of the gap, one more period counted for the braking to begin.
        ahead = math.copysign(1.0, gap)
        left = abs(gap) - 0.5 * ahead * self.v_rad_s * dt
        wanted = math.sqrt((most * dt) ** 2 + 2.0 * most * left) - most * dt if left > 0.0 else 0.0
        self._move_towards(ahead * min(wanted, self._velocity))

    def step_to_rest(self) -> None:
        """Advance one period, braking."""
        self._move_towards(0.0)

    def _move_towards(self, v_rad_s: float) -> None:
        most = self._acceleration * self._period_s
        self._move(self.v_rad_s + min(max(v_rad_s - self.v_rad_s, -most), most))

    def _move(self, v_rad_s: float) -> None:
        self.q_rad += 0.5 * (self.v_rad_s + v_rad_s) * self._period_s
        self.v_rad_s = v_rad_s
