"""What an object weighs and how it slides, where a scene does not say: as household things of its kind do."""

from __future__ import annotations

import math
from collections.abc import Mapping
from types import MappingProxyType

from kinematics.geometry.shapes import Ball, Box, Cylinder, Shape

USUAL_FRICTION = 0.6
"""Of glass, tin, cardboard and glazed clay on wood or rubber, 0.5 to 0.7 by the usual tables."""

LIGHTEST_KG, HEAVIEST_KG = 0.01, 5.0
"""What is not said to be lighter or heavier is within these."""

_SOLID_KG_M3: Mapping[str, float] = MappingProxyType(
    {"cup": 650.0, "bottle": 700.0, "can": 850.0, "bowl": 330.0, "box": 570.0, "ball": 660.0}
)
"""Mass by the volume of the outline: a mug of 0.2 kg, half a litre in a bottle, a full tin, a packet."""
_WALL_KG_M3: Mapping[str, float] = MappingProxyType({"box": 700.0, "bowl": 1400.0})
"""Of the walls of what is hollow: thin wood or plastic, glazed clay."""


def usual_mass_kg(kind: str, shape: Shape, wall_m: float | None = None) -> float:
    """Mass of an object of a kind and size, kg.

    Args:
        kind: One of ``scene_words.OBJECT_KINDS``.
        shape: Its outline.
        wall_m: Thickness of walls and bottom where it is hollow and open at the top.
    """
    outline = inside_m3(shape)
    if wall_m is None:
        mass_kg = outline * _SOLID_KG_M3[kind]
    else:
        mass_kg = (outline - inside_m3(shape, wall_m)) * _WALL_KG_M3[kind]
    return max(LIGHTEST_KG, min(HEAVIEST_KG, mass_kg))


def inside_m3(shape: Shape, wall_m: float = 0.0) -> float:
    """What a solid holds, m^3.

    Args:
        shape: Its outline.
        wall_m: How thick its walls and its bottom are.
    """
    match shape:
        case Box(size_m=(x, y, z)):
            return max(x - 2.0 * wall_m, 0.0) * max(y - 2.0 * wall_m, 0.0) * max(z - wall_m, 0.0)
        case Cylinder(radius_m=radius, height_m=height):
            inside = max(radius - wall_m, 0.0)
            return math.pi * inside * inside * max(height - wall_m, 0.0)
        case Ball(radius_m=radius):
            inside = max(radius - wall_m, 0.0)
            return 4.0 / 3.0 * math.pi * inside * inside * inside
