"""Where a person takes hold of what a robot's hand offers."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from kinematics.arrays import Array, Sealed
from kinematics.geometry.shapes import Ball, Box, Shape
from robots.simulated.people.person_hand import PersonHand

BEFORE_M = 0.13
"""The hand comes straight towards the object from here."""
SPARE_M = 0.035
"""Of an open hand on each side of the object."""
_WAY_M = (BEFORE_M, 0.08, 0.04, 0.0)
_ENOUGH_M = 0.008
# Of a pad's middle from the end of the object.
_FROM_END_M = 0.012
_HEIGHTS = 7


@dataclass(frozen=True, slots=True)
class Pinch(Sealed):
    """How a simulated person's fingers take hold of a thing.

    Attributes:
        offset_m: Of the middle of the hand from the object's, world, shape (3,).
        roll_rad: Turn of the pinch: 0 is from above and below, a quarter turn from both sides.
        half_m: Half of what is between the pads.
    """

    offset_m: Array
    roll_rad: float
    half_m: float


def choose_pinch(hand: PersonHand, place: Array, shape: Shape, towards: Array) -> Pinch:
    """The first way in which the fingers keep clear of the robot's, or that with most room.

    Args:
        hand: The person's.
        place: The object's middle, world, shape (3,); it stands upright.
        shape: The object's.
        towards: Horizontal direction from the object to the person, shape (3,).
    """
    best: tuple[float, Pinch] | None = None
    for pinch in _ways(shape, towards):
        goal = place + pinch.offset_m
        room_m = min(
            hand.room_m(goal + far * towards, pinch.roll_rad, pinch.half_m + SPARE_M) for far in _WAY_M
        )
        room_m = min(room_m, hand.room_m(goal, pinch.roll_rad, pinch.half_m))
        if room_m >= _ENOUGH_M:
            return pinch
        if best is None or room_m > best[0]:
            best = room_m, pinch
    assert best is not None
    return best[1]


def _ways(shape: Shape, towards: Array) -> Iterator[Pinch]:
    half_m, radius_m = 0.5 * shape.height_m, _radius_m(shape)
    for share in (0.5, 0.75, 0.25):  # from above and below, on the person's side of the object
        yield Pinch(share * radius_m * towards, 0.0, half_m)
    for height_m in np.linspace(_FROM_END_M - half_m, half_m - _FROM_END_M, _HEIGHTS).tolist():
        yield Pinch(np.array([0.0, 0.0, height_m]), 0.5 * math.pi, radius_m)


def _radius_m(shape: Shape) -> float:
    if isinstance(shape, Box):
        return 0.5 * min(shape.size_m[:2])
    return 0.5 * shape.height_m if isinstance(shape, Ball) else shape.radius_m
