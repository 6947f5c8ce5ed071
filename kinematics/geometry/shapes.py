"""The simple solids that scenes are made of, centred on their own origin, in metres.

What is no such solid has the simple one that holds it, its outline, and says in ``parts`` what is in that.
Who judges contacts or takes hold of a thing looks at its parts; for all else the outline will do.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from kinematics.geometry.convex_parts import ConvexParts


@dataclass(frozen=True, slots=True)
class Box:
    """A box; ``size_m`` are its full edge lengths along x, y, z, ``parts`` what it is the outline of."""

    size_m: tuple[float, float, float]
    parts: ConvexParts | None = field(default=None, repr=False)

    @property
    def height_m(self) -> float:
        """Extent along z."""
        return self.size_m[2]


@dataclass(frozen=True, slots=True)
class Cylinder:
    """An upright cylinder about z; ``parts`` is what it is the outline of."""

    radius_m: float
    height_m: float
    parts: ConvexParts | None = field(default=None, repr=False)


@dataclass(frozen=True, slots=True)
class Ball:
    """A ball; ``parts`` is what it is the outline of."""

    radius_m: float
    parts: ConvexParts | None = field(default=None, repr=False)

    @property
    def height_m(self) -> float:
        """Extent along z."""
        return 2.0 * self.radius_m


Shape = Box | Cylinder | Ball
