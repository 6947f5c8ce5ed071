"""The simple solids that scenes are made of, centred on their own origin, in metres."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Box:
    """A box; ``size_m`` are its full edge lengths along x, y, z."""

    size_m: tuple[float, float, float]

    @property
    def height_m(self) -> float:
        """Extent along z."""
        return self.size_m[2]


@dataclass(frozen=True, slots=True)
class Cylinder:
    """An upright cylinder about z."""

    radius_m: float
    height_m: float


@dataclass(frozen=True, slots=True)
class Ball:
    """A ball."""

    radius_m: float

    @property
    def height_m(self) -> float:
        """Extent along z."""
        return 2.0 * self.radius_m


Shape = Box | Cylinder | Ball
