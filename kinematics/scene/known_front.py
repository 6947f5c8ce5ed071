"""What a detector that recognises a piece of furniture by its model tells of its doors and drawers."""

from __future__ import annotations

from dataclasses import dataclass

from kinematics.arrays import Sealed
from kinematics.geometry.poses import Transform


@dataclass(frozen=True, slots=True)
class KnownFront(Sealed):
    """Where a door or drawer would be if it were shut, and how far it goes.

    Attributes:
        shut: Pose of its solid while shut, in the frame in which the solid itself is told, shape (4, 4).
        travel: How far it opens: rad of a door, m of a drawer.
        of: What it is part of, as people call that: "wooden cabinet".
        side: +1 of a door that hangs on the left, seen by who opens it; -1 on the right; 0 of a drawer.
        hinge_m: Where a hinge's axis goes through the front, in its own x and y; (0, 0) of a drawer.
    """

    shut: Transform
    travel: float
    of: str
    side: float = 0.0
    hinge_m: tuple[float, float] = (0.0, 0.0)
