"""One joint's setpoint on its way to a target, or to rest, within speed, acceleration and jerk limits."""

from __future__ import annotations

import math

from robots.control.grip.rest_point import braking, rest_point, steered

_SHARE = 0.98
"""Of the limits that is used, so that rounding never touches them."""
_ARRIVED_RAD = 1e-9
"""Nearer than this is there."""


class JointTracker:
    """Third-order profile of one joint, made as it goes; the target may change at any time.

    Attributes:
        q_rad, v_rad_s: The setpoint now.
        a_rad_s2: Acceleration of the last step.
    """

    __slots__ = ("_acceleration", "_change", "_period_s", "_velocity", "a_rad_s2", "q_rad", "v_rad_s")

    def __init__(
        self, q_rad: float, velocity: float, acceleration: float, period_s: float, jerk: float
    ) -> None:
        """Rest at a position; limits in rad/s and its rates, ``period_s`` between two steps."""
        self.q_rad, self.v_rad_s, self.a_rad_s2 = q_rad, 0.0, 0.0
        self._velocity = _SHARE * velocity
        self._acceleration = _SHARE * acceleration
        self._change = _SHARE * jerk * period_s
        self._period_s = period_s

    @property
    def moving(self) -> bool:
        """Whether it is not at rest."""
        return self.v_rad_s != 0.0 or self.a_rad_s2 != 0.0

    @property
    def rest_rad(self) -> float:
        """Where it comes to rest if it brakes from now on."""
        return rest_point(
            self.q_rad, self.v_rad_s, self.a_rad_s2, self._period_s, self._acceleration, self._change
        )

    def step_towards(self, target_rad: float, slowly_rad_s: float = math.inf) -> None:
        """Advance one period; at the target it stays exactly at rest.

        It goes beyond the target only where it could not be braked before it, and then comes back.

        Args:
            target_rad: Where to rest.
            slowly_rad_s: No faster than this, where that is slower than the limit.
        """
        if abs(target_rad - self.q_rad) < _ARRIVED_RAD and self._may_rest():
            self._rest()
            return
        state = self.q_rad, self.v_rad_s, self.a_rad_s2
        fastest = min(self._velocity, slowly_rad_s)
        self._move(steered(target_rad, *state, self._period_s, fastest, self._acceleration, self._change))

    def step_to_rest(self) -> None:
        """Advance one period, braking as hard as acceleration and jerk limits let it."""
        if self._may_rest():
            self._rest()
        else:
            self._move(braking(self.v_rad_s, self.a_rad_s2, self._period_s, self._acceleration, self._change))

    def _may_rest(self) -> bool:
        """Whether what is left of the motion is rounding: what it takes to end it breaks no limit."""
        slow = abs(self.v_rad_s) < _ARRIVED_RAD / self._period_s
        return slow and abs(self.a_rad_s2) <= self._change

    def _rest(self) -> None:
        self.v_rad_s = self.a_rad_s2 = 0.0

    def _move(self, a_rad_s2: float) -> None:
        v = self.v_rad_s + a_rad_s2 * self._period_s
        self.q_rad += 0.5 * (self.v_rad_s + v) * self._period_s
        self.v_rad_s, self.a_rad_s2 = v, a_rad_s2
