"""The divergent component of motion: which one a walk needs now, for what its ZMP will do.

With the CoM at a constant height, ``c'' = w^2 (c - p)`` and the DCM ``xi = c + c'/w`` obeys
``xi' = w (xi - p)``: unstable forwards, stable backwards. So it is computed backwards from where the walk
ends. Source: Englsberger, Ott, Albu-Schaeffer, "Three-dimensional bipedal walking control based on
divergent component of motion", IEEE Transactions on Robotics 31(2), 2015, section IV.

``p`` is not quite the ZMP: a leg that swings turns the rest of the robot the other way, and that moves the
ZMP by some centimetres. With the foot's acceleration ``f''``, ``p = zmp + k f''``; as ``f''`` is a
polynomial of third order, everything keeps its closed form.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

Point = tuple[float, float]
Cubic = tuple[float, float, float, float]
"""Coefficients of the powers of time, from the 0th."""
NO_SWAY: tuple[Cubic, Cubic] = ((0.0, 0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 0.0))


@dataclass(frozen=True, slots=True)
class ZmpStretch:
    """A time in which the ZMP moves in a straight line.

    Attributes:
        duration_s: How long it takes.
        start, end: Where it begins and ends, m.
        sway: What the swinging leg adds to it, ``k f''`` of each axis, m.
    """

    duration_s: float
    start: Point
    end: Point
    sway: tuple[Cubic, Cubic] = NO_SWAY

    def pivot(self, axis: int) -> Cubic:
        """``p`` of one axis."""
        slope = (self.end[axis] - self.start[axis]) / self.duration_s if self.duration_s > 0.0 else 0.0
        a, b, c, d = self.sway[axis]
        return self.start[axis] + a, slope + b, c, d


def polynomial(p: Cubic, t: float) -> float:
    """Value at a time."""
    return p[0] + t * (p[1] + t * (p[2] + t * p[3]))


def particular(p: Cubic, t: float, omega: float) -> tuple[float, float]:
    """The CoM and the DCM that neither grow nor fade above a pivot that moves like this."""
    value = polynomial(p, t)
    first = p[1] + t * (2.0 * p[2] + t * 3.0 * p[3])
    second = 2.0 * p[2] + t * 6.0 * p[3]
    w = 1.0 / omega
    return value + second * w * w, value + w * (first + w * (second + w * 6.0 * p[3]))


def dcm_before(stretches: Sequence[ZmpStretch], dcm_end: Point, omega: float) -> Point:
    """DCM at the beginning of some stretches that leads to one at their end."""
    x, y = dcm_end
    for stretch in reversed(stretches):
        x, y = (_carried(stretch, axis, value, omega, -1.0) for axis, value in ((0, x), (1, y)))
    return x, y


def dcm_after(stretches: Sequence[ZmpStretch], dcm_start: Point, omega: float) -> Point:
    """DCM at the end of some stretches."""
    x, y = dcm_start
    for stretch in stretches:
        x, y = (_carried(stretch, axis, value, omega, 1.0) for axis, value in ((0, x), (1, y)))
    return x, y


def zmp_that_leads(
    through: Callable[[Point], Sequence[ZmpStretch]], dcm_now: Point, dcm_end: Point, omega: float
) -> Point:
    """The point for which some stretches lead from one DCM to another.

    From one that is so far away that no point counts beside it (the robot lies on the floor) none does: then
    it is where they are to lead.

    Args:
        through: Stretches for a point; each coordinate of their ZMP is linear in that of the point.
        dcm_now, dcm_end: At their beginning and their end.
        omega: Natural frequency, 1/s.
    """
    x0, y0 = dcm_after(through((0.0, 0.0)), dcm_now, omega)
    x1, y1 = dcm_after(through((1.0, 1.0)), dcm_now, omega)
    if x1 == x0 or y1 == y0:
        return dcm_end
    return (dcm_end[0] - x0) / (x1 - x0), (dcm_end[1] - y0) / (y1 - y0)


def _carried(stretch: ZmpStretch, axis: int, dcm: float, omega: float, direction: float) -> float:
    p, T = stretch.pivot(axis), stretch.duration_s
    start, end = particular(p, 0.0, omega)[1], particular(p, T, omega)[1]
    if direction > 0.0:
        return end + (dcm - start) * math.exp(omega * T)
    return start + (dcm - end) * math.exp(-omega * T)
