"""What a door or drawer of a scene must be like to be one."""

from __future__ import annotations

import math

from robots.articulated import ARTICULATED_KINDS, DRAWER_FRONT_HEIGHT_M, WALL_M, opens_to
from robots.scene_description import Furniture

LARGEST_BAR_RADIUS_M = 0.03
"""Thicker bars do not fit into a hand."""


def part_defect(piece: Furniture) -> tuple[str, str] | None:
    """The key and the reason of the first rule that the moving part breaks, or None."""
    part = piece.opens
    if piece.kind not in ARTICULATED_KINDS:
        return None if part is None else ("kind", f"a {piece.kind} does not open")
    if part is None:
        return "kind", f"a {piece.kind} needs the part that opens"
    door = piece.kind == "fridge"
    if (part.hinge is None) == door:
        return "hinge", "a door has a hinge, a drawer has none"
    _, width, height = piece.size_m
    least = {"fridge": (0.3, 0.3, 0.5), "drawers": (0.3, 0.25, DRAWER_FRONT_HEIGHT_M + 0.1)}[piece.kind]
    for axis, value, smallest in zip(("depth", "width", "height"), piece.size_m, least, strict=True):
        if value < smallest:
            return "size_m", f"{axis} must be at least {smallest:g} m, not {value:g}"
    middle = 0.5 * DRAWER_FRONT_HEIGHT_M
    high = (0.1 + part.handle_radius_m, height) if door else (-middle, middle)
    longest = height if door else width - 2.0 * WALL_M
    ranges = (
        ("mass_kg", part.mass_kg, 0.1, 100.0),
        ("friction_nm" if door else "friction_n", part.friction, 0.0, 100.0),
        ("seal_n", part.seal_n, 0.0, 500.0),
        ("open_rad" if door else "open_m", part.opening, 0.0, opens_to(piece)),
        ("handle_radius_m", part.handle_radius_m, 0.003, LARGEST_BAR_RADIUS_M),
        ("handle_length_m", part.handle_length_m, 0.05, longest),
        ("handle_height_m", part.handle_height_m, *high),
        ("handle_inset_m", part.handle_inset_m, 0.0, 0.5 * width),
        ("handle_friction", part.handle_friction, 0.01, 5.0),
    )
    for key, value, lowest, highest in ranges:
        if not (math.isfinite(value) and lowest <= value <= highest):
            return key, f"must be from {lowest:g} to {highest:g}, not {value:g}"
    if part.locked and part.opening > 0.0:
        return "locked", "what is open is not locked"
    return None
