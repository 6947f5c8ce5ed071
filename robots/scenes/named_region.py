"""Parts of furniture that have a name of their own: the burner of a stove, a compartment of a caddy."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

PLATE_M = 0.002
"""What is told of a region is its floor, so thin."""
_SMALLEST_M = 0.02

Size = tuple[float, float, float]


@dataclass(frozen=True, slots=True)
class NamedRegion:
    """Room on, or in, a piece of furniture that things are put on, or into.

    Attributes:
        name: What it is called: "burner", "back compartment".
        size_m: Along the furniture's own x and y, and how high it reaches above its floor.
        position_m: Of the middle of its floor in the furniture's frame; z is above the room's floor.
    """

    name: str
    size_m: Size
    position_m: Size

    @property
    def plate(self) -> tuple[Size, Size]:
        """Its floor as a thin box: size, and middle in the furniture's frame."""
        x, y, z = self.position_m
        return (self.size_m[0], self.size_m[1], PLATE_M), (x, y, z - 0.5 * PLATE_M)


def region_defect(regions: Sequence[NamedRegion]) -> tuple[str, str] | None:
    """The key and the reason of the first rule that named regions break, or None."""
    names = [region.name for region in regions]
    for k, region in enumerate(regions):
        if not all(map(math.isfinite, (*region.size_m, *region.position_m))):
            return f"region[{k}].position_m", "must be finite"
        if min(region.size_m[:2]) < _SMALLEST_M or region.size_m[2] < PLATE_M:
            return f"region[{k}].size_m", f"must be at least {_SMALLEST_M:g} m wide and {PLATE_M:g} m high"
        if region.position_m[2] < 0.0:
            return f"region[{k}].position_m", "is in the floor"
        if names.index(region.name) != k:
            return f"region[{k}].name", f"{region.name!r} is another one of its regions"
        if "/" in region.name or not region.name.strip():
            return f"region[{k}].name", "must be a name without '/'"
    return None
