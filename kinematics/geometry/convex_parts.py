"""Convex solids that together are one thing, and points on its surface."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from kinematics.arrays import Array, Sealed
from kinematics.errors import InvalidArrayError

_NOWHERE = np.zeros((0, 3))
_LEAST_CORNERS = 4
"""A solid has as many corners at least."""


@dataclass(frozen=True, slots=True, eq=False)
class ConvexParts(Sealed):
    """What a thing is made of that is no box, cylinder or ball: the convex hulls of some sets of corners.

    Two of one key and the same corners are the same.

    Attributes:
        key: Digest of what they were made of.
        corners: Corners of all parts, one part behind the other, in the thing's own frame, shape (n, 3), m.
        ends: For each part, the row behind its last corner.
        surface: Points on the surface of the whole, shape (m, 3), m; none where nobody has sampled it.
        normals: Outward unit normals there, shape (m, 3).
        rests: Directions of the thing that may be up when it rests on something level, the safest first,
            shape (k, 3); none where nobody has looked.
        outline_error_m: How far the surface of their hull is from that of the outline which has them, at
            nearly all places; 0 where they are that outline.
        file: Where they are kept, for other processes of this machine; empty where they were made here.

    Raises:
        InvalidArrayError: A part has less than four corners, or points and normals are not as many.
    """

    key: str
    corners: Array
    ends: tuple[int, ...]
    surface: Array = field(default_factory=_NOWHERE.copy)
    normals: Array = field(default_factory=_NOWHERE.copy)
    rests: Array = field(default_factory=_NOWHERE.copy)
    outline_error_m: float = 0.0
    file: str = ""

    def __post_init__(self) -> None:
        Sealed.__post_init__(self)
        sizes = np.diff([0, *self.ends])
        if not self.ends or self.ends[-1] != len(self.corners) or sizes.min() < _LEAST_CORNERS:
            raise InvalidArrayError("corners", f"make no solids: {len(self.corners)} rows, ends {self.ends}")
        if self.surface.shape != self.normals.shape:
            raise InvalidArrayError("normals", f"has shape {self.normals.shape}, not {self.surface.shape}")

    def __eq__(self, other: object) -> bool:
        if self is other:
            return True
        if not isinstance(other, ConvexParts) or self.key != other.key or self.ends != other.ends:
            return False
        # whoever sends a motion may say any key
        return np.array_equal(self.corners, other.corners)

    def __hash__(self) -> int:
        return hash(self.key)

    @property
    def hulls(self) -> tuple[Array, ...]:
        """Corners of each part, shape (k, 3), m."""
        starts = (0, *self.ends[:-1])
        return tuple(self.corners[first:last] for first, last in zip(starts, self.ends, strict=True))
