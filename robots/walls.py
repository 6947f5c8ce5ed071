"""Walls: upright boxes from the floor up. A doorway is where two of them leave a gap."""

from __future__ import annotations

from robots.scene_description import Furniture

WALL = "wall"


def wall_boxes(item: Furniture) -> list[tuple[str, tuple[float, float, float], tuple[float, float, float]]]:
    """The one solid of a wall: part, size, and centre in its frame."""
    depth, width, height = item.size_m
    return [("face", (depth, width, height), (0.0, 0.0, 0.5 * height))]
