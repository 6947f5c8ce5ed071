"""What a detector that recognises a piece of furniture by its model tells of what moves on it."""

from __future__ import annotations

import math
from dataclasses import dataclass

from kinematics.arrays import Sealed
from kinematics.geometry.poses import Transform

SAME_WITHIN_M = 0.10
"""Where a thing is that stays, two looks agree better; two pieces of one model are farther apart."""


@dataclass(frozen=True, slots=True)
class KnownPart(Sealed):
    """Which door or drawer a solid belongs to, where it would be if that were shut, and how far it goes.

    Attributes:
        shut: Pose of the solid while shut, in the frame in which the solid itself is told, shape (4, 4).
        travel: How far it opens: rad of a door, m of a drawer.
        of: What it is part of, as people call that: "wooden cabinet".
        part: Which of the parts that open it is: "top drawer".
        side: +1 of a door that hangs on the left, seen by who opens it; -1 on the right; 0 of a drawer.
        hinge_m: Where a hinge's axis goes through the front, in its own x and y; (0, 0) of a drawer.
        names: What people call besides what it is part of: "sideboard".
    """

    shut: Transform
    travel: float
    of: str
    part: str
    side: float = 0.0
    hinge_m: tuple[float, float] = (0.0, 0.0)
    names: tuple[str, ...] = ()

    def is_of(self, other: KnownPart) -> bool:
        """Whether both are solids of one door or drawer; of two pieces of one model it may be either's."""
        return self.of == other.of and self.part == other.part

    def is_same(self, other: KnownPart) -> bool:
        """Whether both are one solid, told at two times, however far it was open."""
        return self.is_of(other) and math.dist(self.shut[:3, 3], other.shut[:3, 3]) <= SAME_WITHIN_M
