"""The quintic from rest to rest: the share of a way that has passed, and its rates."""

from __future__ import annotations

from dataclasses import dataclass

from kinematics.arrays import Array


@dataclass(frozen=True, slots=True)
class Quintic:
    """The polynomial of fifth degree that brings one coordinate to rest at a goal, where it then stays.

    Attributes:
        goal: Where it comes to rest, in the unit of the coordinate.
        duration_s: Time until it does.
        coefficients: Of the powers of time, from the 0th.
    """

    goal: float
    duration_s: float
    coefficients: tuple[float, float, float, float, float, float]

    @classmethod
    def to_rest(cls, x: float, v: float, a: float, goal: float, duration_s: float) -> Quintic:
        """From a position, velocity and acceleration to rest at a goal."""
        T = duration_s
        d = goal - x - v * T - 0.5 * a * T * T
        dv, da = -v - a * T, -a
        return cls(
            goal,
            duration_s,
            (
                x,
                v,
                0.5 * a,
                (10.0 * d - 4.0 * dv * T + 0.5 * da * T * T) / T**3,
                (-15.0 * d + 7.0 * dv * T - da * T * T) / T**4,
                (6.0 * d - 3.0 * dv * T + 0.5 * da * T * T) / T**5,
            ),
        )

    def acceleration_from(self, t_s: float) -> tuple[float, float, float, float]:
        """Coefficients of the acceleration's powers of time, counted from an instant before its end."""
        _, _, c2, c3, c4, c5 = self.coefficients
        t = t_s
        return (
            2.0 * c2 + t * (6.0 * c3 + t * (12.0 * c4 + t * 20.0 * c5)),
            6.0 * c3 + t * (24.0 * c4 + t * 60.0 * c5),
            12.0 * c4 + t * 60.0 * c5,
            20.0 * c5,
        )

    def at(self, t_s: float) -> tuple[float, float, float]:
        """Value and the first two derivatives."""
        if t_s >= self.duration_s:
            return self.goal, 0.0, 0.0
        t, c = t_s, self.coefficients
        value = c[0] + t * (c[1] + t * (c[2] + t * (c[3] + t * (c[4] + t * c[5]))))
        first = c[1] + t * (2.0 * c[2] + t * (3.0 * c[3] + t * (4.0 * c[4] + t * 5.0 * c[5])))
        second = 2.0 * c[2] + t * (6.0 * c[3] + t * (12.0 * c[4] + t * 20.0 * c[5]))
        return value, first, second


PEAK = 1.875
"""Its greatest speed over the mean."""


def rest_to_rest(u: Array, duration_s: float) -> tuple[Array, Array, Array]:
    """Share, its rate in 1/s and that one's rate in 1/s^2, at shares ``u`` of a duration; shapes as ``u``."""
    share = u**3 * (10.0 - 15.0 * u + 6.0 * u**2)
    rate = 30.0 * u**2 * (1.0 - u) ** 2 / duration_s
    slope = 60.0 * u * (1.0 - 3.0 * u + 2.0 * u**2) / duration_s**2
    return share, rate, slope
