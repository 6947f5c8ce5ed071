"""A solid of a piece of furniture, as it is told."""

from __future__ import annotations

from dataclasses import dataclass

from kinematics.arrays import InFloat64
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Shape


@dataclass(frozen=True, slots=True)
class Piece(InFloat64):
    """One solid of a piece of furniture that is seen.

    Attributes:
        kind: "table".
        name: Of its own, or None.
        shape, odom_T_solid: Its solid, and where it is.
        confidence: In [0, 1].
        assumed: What of it was not seen and is taken from the map, or from nothing: "edges".
    """

    kind: str
    name: str | None
    shape: Shape
    odom_T_solid: Transform
    confidence: float
    assumed: frozenset[str] = frozenset()
