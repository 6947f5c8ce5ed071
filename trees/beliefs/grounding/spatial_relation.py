"""Whether one thing lies left of, behind, on, ... another, seen from the robot.

Left and right, in front and behind are the robot's: in front of a thing is what lies between it and the
robot. A direction holds within 60° to either side, so that what lies diagonally counts as both.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from types import MappingProxyType

import numpy as np

from kinematics.arrays import Array
from kinematics.geometry.shapes import Box
from trees.beliefs.scene.believed_thing import BelievedThing
from trees.tasks import RelationKind

NEXT_TO_M = 0.20
"""Two things with less than a hand's width and a half between their surfaces are beside each other."""

STANDING_BY_M = 1.0
"""People who are this near to something stand next to it."""

APART_M = 0.02
"""Centres that differ by less in some direction cannot be told apart in it: twice what two perception
biases of 5 mm and the noise make likely."""

TOUCHING_M = 0.03
"""Something rests on another when its lowest point is this near to the other's top; both carry a bias."""

_CONE_COS = math.cos(math.radians(60.0))

# ahead is away from the robot: "in front of the box" is on the robot's side of it
_DIRECTIONS: Mapping[str, tuple[float, float]] = MappingProxyType(
    {"left_of": (0.0, 1.0), "right_of": (0.0, -1.0), "in_front_of": (-1.0, 0.0), "behind": (1.0, 0.0)}
)


def lies(kind: RelationKind, item: BelievedThing, reference: BelievedThing) -> bool:
    """Tell whether ``item`` lies so relative to ``reference``; for "nearest" whether it may compete."""
    if item.name == reference.name:
        return False
    if kind in _DIRECTIONS:
        return _in_direction(item.place_m - reference.place_m, _DIRECTIONS[kind])
    test = _TESTS.get(kind)
    return True if test is None else test(item, reference)


def lies_from_robot(kind: RelationKind, item: BelievedThing) -> bool:
    """The same with the robot itself as the reference: "in front of you" is ahead."""
    if kind in ("in_front_of", "behind"):
        ahead = 1.0 if kind == "in_front_of" else -1.0
        return _in_direction(item.place_m, (ahead, 0.0))
    if kind in _DIRECTIONS:
        return _in_direction(item.place_m, _DIRECTIONS[kind])
    if kind == "next_to":
        return item.distance_m - item.radius_m <= 2.0 * NEXT_TO_M
    return kind == "nearest"


def between_m(item: BelievedThing, reference: BelievedThing) -> float:
    """Horizontal distance of the centres."""
    return float(np.linalg.norm((item.place_m - reference.place_m)[:2]))


def _in_direction(offset: Array, direction: tuple[float, float]) -> bool:
    along = float(offset[0] * direction[0] + offset[1] * direction[1])
    return along > APART_M and along >= _CONE_COS * float(math.hypot(offset[0], offset[1]))


def _next_to(item: BelievedThing, reference: BelievedThing) -> bool:
    gap = between_m(item, reference) - item.radius_m - reference.radius_m
    if not item.movable:
        return gap <= STANDING_BY_M
    return gap <= NEXT_TO_M and abs(item.bottom_m - reference.bottom_m) <= NEXT_TO_M


def _over(item: BelievedThing, reference: BelievedThing) -> bool:
    """Whether the centre of one is within the outline of the other (of a box: its circumscribed circle)."""
    if isinstance(reference.shape, Box) and item.support == reference.name:
        return True
    return between_m(item, reference) <= reference.radius_m


def _on(item: BelievedThing, reference: BelievedThing) -> bool:
    if item.support == reference.name:
        return True
    return _over(item, reference) and abs(item.bottom_m - reference.top_m) <= TOUCHING_M


def _in(item: BelievedThing, reference: BelievedThing) -> bool:
    inside = reference.bottom_m - TOUCHING_M <= item.bottom_m < reference.top_m - TOUCHING_M
    return _over(item, reference) and inside


def _under(item: BelievedThing, reference: BelievedThing) -> bool:
    return _over(item, reference) and item.top_m <= reference.bottom_m + TOUCHING_M


_TESTS: Mapping[str, Callable[[BelievedThing, BelievedThing], bool]] = MappingProxyType(
    {"next_to": _next_to, "on": _on, "in": _in, "under": _under}
)
