"""The divergent component of motion: which one a walk needs now, for what its ZMP will do.

With the CoM at a constant height, ``c'' = w^2 (c - z)`` and the DCM ``xi = c + c'/w`` obeys
``xi' = w (xi - z)``: unstable forwards, stable backwards. So it is computed backwards from where the
walk ends. Along a stretch in which the ZMP moves in a straight line both have a closed form.
Source: Englsberger, Ott, Albu-Schaeffer, "Three-dimensional bipedal walking control based on
divergent component of motion", IEEE Transactions on Robotics 31(2), 2015, section IV.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

Point = tuple[float, float]


@dataclass(frozen=True, slots=True)
class ZmpStretch:
    """A time in which the ZMP moves in a straight line.

    Attributes:
        duration_s: How long it takes.
        start, end: Where it begins and ends, m.
    """

    duration_s: float
    start: Point
    end: Point


def dcm_before(stretches: Sequence[ZmpStretch], dcm_end: Point, omega: float) -> Point:
    """DCM at the beginning of some stretches that leads to one at their end."""
    x, y = dcm_end
    for stretch in reversed(stretches):
        decay = math.exp(-omega * stretch.duration_s)
        x = _before(x, stretch.start[0], stretch.end[0], stretch.duration_s, omega, decay)
        y = _before(y, stretch.start[1], stretch.end[1], stretch.duration_s, omega, decay)
    return x, y


def constant_zmp(dcm_now: Point, dcm_end: Point, duration_s: float, omega: float) -> Point:
    """Where the ZMP must stay for the DCM to come from here to there in a time."""
    growth = math.exp(omega * duration_s)
    return (
        (dcm_end[0] - growth * dcm_now[0]) / (1.0 - growth),
        (dcm_end[1] - growth * dcm_now[1]) / (1.0 - growth),
    )


def bent_zmp(
    dcm_now: Point, dcm_end: Point, start: Point, end: Point, duration_s: float, omega: float
) -> tuple[ZmpStretch, ZmpStretch]:
    """The ZMP's way from one point to another, bent half-way so that the DCM arrives at a third."""
    half_s = 0.5 * duration_s
    growth = math.exp(omega * half_s)

    def bend(now: float, goal: float, a: float, b: float) -> float:
        def arrival(knot: float) -> float:
            return _after(_after(now, a, knot, half_s, omega, growth), knot, b, half_s, omega, growth)

        base = arrival(0.0)
        return (goal - base) / (arrival(1.0) - base)

    knot = (
        bend(dcm_now[0], dcm_end[0], start[0], end[0]),
        bend(dcm_now[1], dcm_end[1], start[1], end[1]),
    )
    return ZmpStretch(half_s, start, knot), ZmpStretch(half_s, knot, end)


def _before(after: float, start: float, end: float, duration_s: float, omega: float, decay: float) -> float:
    if duration_s <= 0.0:
        return after
    slope = (end - start) / duration_s
    return start + slope / omega + (after - end - slope / omega) * decay


def _after(before: float, start: float, end: float, duration_s: float, omega: float, growth: float) -> float:
    slope = (end - start) / duration_s
    return end + slope / omega + (before - start - slope / omega) * growth
