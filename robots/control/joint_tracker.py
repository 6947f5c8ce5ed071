"""One joint's setpoint on its way to a target, within speed and acceleration limits.

Coming to rest because of a stop keeps the jerk limit as well. On the way to a target the acceleration
may change at once: what the fingers meet must not be pressed by a setpoint that takes its time.
"""

from __future__ import annotations

import math

_SHARE = 0.98
"""Of the limits that is used, so that rounding never touches them."""
_ARRIVED_RAD = 1e-9
"""Nearer than this is there."""
_HALVINGS = 50
"""Of the range in which the next acceleration is searched: to rounding."""


class JointTracker:
    """Second-order profile of one joint, made as it goes; the target may change at any time.

    Attributes:
        q_rad, v_rad_s: The setpoint now.
        a_rad_s2: Acceleration of the last step.
    """

    __slots__ = ("_acceleration", "_jerk", "_period_s", "_velocity", "a_rad_s2", "q_rad", "v_rad_s")

    def __init__(
        self, q_rad: float, velocity: float, acceleration: float, period_s: float, jerk: float = math.inf
    ) -> None:
        """Rest at a position; limits in rad/s and its rates, ``period_s`` between two steps."""
        self.q_rad, self.v_rad_s, self.a_rad_s2 = q_rad, 0.0, 0.0
        self._jerk = _SHARE * jerk
        self._velocity = _SHARE * velocity
        self._acceleration = _SHARE * acceleration
        self._period_s = period_s

    def step_towards(self, target_rad: float) -> None:
        """Advance one period; at the target it stays exactly at rest."""
        dt, most = self._period_s, self._acceleration
        gap = target_rad - self.q_rad
        if abs(gap) < _ARRIVED_RAD and abs(self.v_rad_s) < _ARRIVED_RAD / dt:
            self.v_rad_s = self.a_rad_s2 = 0.0
            return
        # The fastest speed from which, after this period, the joint can still brake within what is
        # left of the gap, one more period counted for the braking to begin.
        ahead = math.copysign(1.0, gap)
        left = abs(gap) - 0.5 * ahead * self.v_rad_s * dt
        wanted = math.sqrt((most * dt) ** 2 + 2.0 * most * left) - most * dt if left > 0.0 else 0.0
        self._move_towards(ahead * min(wanted, self._velocity))

    def step_to_rest(self) -> None:
        """Advance one period, braking as hard as acceleration and jerk limits let it."""
        if math.isinf(self._jerk):
            self._move_towards(0.0)
            return
        change, most = self._jerk * self._period_s, self._acceleration
        if self.v_rad_s == 0.0 and abs(self.a_rad_s2) <= change:
            self.a_rad_s2 = 0.0
            return
        least, largest = max(self.a_rad_s2 - change, -most), min(self.a_rad_s2 + change, most)
        # The speed that is left after fading the acceleration out rises with the acceleration.
        for _ in range(_HALVINGS):
            middle = 0.5 * (least + largest)
            if self._left_after(middle, change) > 0.0:
                largest = middle
            else:
                least = middle
        a = 0.5 * (least + largest)
        v = self.v_rad_s + a * self._period_s
        self._move(0.0 if abs(v) < _ARRIVED_RAD and abs(a) <= 0.5 * change else v)

    def _left_after(self, a_rad_s2: float, change: float) -> float:
        """Speed when the next step has this acceleration, and it then fades by ``change`` a step."""
        steps = math.floor(abs(a_rad_s2) / change)
        fading = steps * abs(a_rad_s2) - 0.5 * change * steps * (steps + 1)
        return self.v_rad_s + self._period_s * (a_rad_s2 + math.copysign(fading, a_rad_s2))

    def _move_towards(self, v_rad_s: float) -> None:
        most = self._acceleration * self._period_s
        self._move(self.v_rad_s + min(max(v_rad_s - self.v_rad_s, -most), most))

    def _move(self, v_rad_s: float) -> None:
        self.q_rad += 0.5 * (self.v_rad_s + v_rad_s) * self._period_s
        self.a_rad_s2 = (v_rad_s - self.v_rad_s) / self._period_s
        self.v_rad_s = v_rad_s
