"""The way back from where the robot was told to stay to a reference that has gone on."""

from __future__ import annotations

from kinematics.arrays import Array

_DURATION_S = 0.2


class Rejoin:
    """A difference of positions and velocities that fades away smoothly."""

    def __init__(self, gap: Array, gap_speed: Array) -> None:
        """Begin with a difference, shape (n,) each; its acceleration begins and ends with nothing."""
        T = _DURATION_S
        d, dv = -gap - gap_speed * T, -gap_speed
        self._coefficients = (
            gap,
            gap_speed,
            (10.0 * d - 4.0 * dv * T) / T**3,
            (-15.0 * d + 7.0 * dv * T) / T**4,
            (6.0 * d - 3.0 * dv * T) / T**5,
        )
        self._t_s = 0.0

    @property
    def over(self) -> bool:
        """Whether nothing is left of it."""
        return self._t_s >= _DURATION_S

    def advance(self, period_s: float) -> tuple[Array, Array]:
        """What is left of it after another period: positions and velocities."""
        self._t_s += period_s
        t = min(self._t_s, _DURATION_S)
        x, v, c3, c4, c5 = self._coefficients
        left = x + t * (v + t * t * (c3 + t * (c4 + t * c5)))
        speed = v + t * t * (3.0 * c3 + t * (4.0 * c4 + t * 5.0 * c5))
        return left, speed
