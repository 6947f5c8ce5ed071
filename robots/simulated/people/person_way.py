"""How a simulated person's hand comes to what is offered: around the robot's arm, not through it."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from kinematics.arrays import Array
from robots.simulated.people.person_hand import PersonHand
from robots.simulated.people.person_pinch import SPARE_M, Pinch

_ENOUGH_M = 0.03
_STEP_M = 0.04
_ASIDE_M = 0.30


def choose_way(hand: PersonHand, before: Array, pinch: Pinch, towards: Array) -> tuple[Array, ...]:
    """Points that the hand goes by, the last one before the object; straight there if the robot leaves room.

    Args:
        hand: The person's, where it rests.
        before: Where it begins to close in, world, shape (3,).
        pinch: How it is going to take hold.
        towards: Horizontal direction from the object to the person, shape (3,).
    """
    best: tuple[float, tuple[Array, ...]] | None = None
    for way in _ways(before, towards):
        room_m = min(
            hand.room_m(point, pinch.roll_rad, pinch.half_m + SPARE_M)
            for point in _along((hand.place(), *way))
        )
        if room_m >= _ENOUGH_M:
            return way
        if best is None or room_m > best[0]:
            best = room_m, way
    assert best is not None
    return best[1]


def _ways(before: Array, towards: Array) -> Iterator[tuple[Array, ...]]:
    yield (before,)
    up, out = np.array([0.0, 0.0, _ASIDE_M]), _ASIDE_M * towards
    across = np.cross(up, towards)
    yield before + out, before
    for aside in (up, -up, across, -across, up + across, up - across, across - up, -across - up):
        yield before + aside, before
        yield before + out + aside, before + 0.5 * aside, before


def _along(points: tuple[Array, ...]) -> Iterator[Array]:
    """From the first point to the last, in small steps; not the first itself."""
    for start, end in pairwise(points):
        steps = max(1, int(np.linalg.norm(end - start) / _STEP_M))
        for k in range(1, steps + 1):
            yield start + k / steps * (end - start)
