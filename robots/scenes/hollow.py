"""Boxes and bowls that are open at the top, as the solids that they are made of."""

from __future__ import annotations

import math

from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Box, Cylinder, Shape
from robots.scenes.scene_description import SceneItem

WALLS_OF_A_BOWL = 12
"""Flat walls that a round one is made of."""

Part = tuple[str, Shape, Transform, float]
"""Name, solid, ``item_T_part`` and share of the mass; the first part is the bottom, named as the item."""


def hollow_parts(item: SceneItem) -> list[Part]:
    """Bottom and walls of a hollow item; nothing for one that is solid."""
    if item.wall_m is None:
        return []
    wall, height = item.wall_m, item.shape.height_m
    down, up = poses.translation(0.0, 0.0, 0.5 * (wall - height)), 0.5 * wall
    parts: list[tuple[str, Shape, Transform]] = []
    if isinstance(item.shape, Box):
        x, y, _ = item.shape.size_m
        parts.append((item.name, Box((x, y, wall)), down))
        for k, side in enumerate((1.0, -1.0)):
            across = poses.translation(side * 0.5 * (x - wall), 0.0, up)
            parts.append((f"{item.name}/wall_{k}", Box((wall, y, height - wall)), across))
            along = poses.translation(0.0, side * 0.5 * (y - wall), up)
            parts.append((f"{item.name}/wall_{k + 2}", Box((x - 2.0 * wall, wall, height - wall)), along))
    else:
        radius = item.shape.radius_m
        parts.append((item.name, Cylinder(radius, wall), down))
        width = 2.0 * radius * math.tan(math.pi / WALLS_OF_A_BOWL)
        for k in range(WALLS_OF_A_BOWL):
            turn = poses.transform(poses.rotation_z(2.0 * math.pi * k / WALLS_OF_A_BOWL), (0.0, 0.0, up))
            place = turn @ poses.translation(radius - 0.5 * wall, 0.0, 0.0)
            parts.append((f"{item.name}/wall_{k}", Box((wall, width, height - wall)), place))
    total = sum(_volume(shape) for _, shape, _ in parts)
    return [(name, shape, pose, _volume(shape) / total) for name, shape, pose in parts]


def _volume(shape: Shape) -> float:
    if isinstance(shape, Box):
        return math.prod(shape.size_m)
    return math.pi * shape.radius_m**2 * shape.height_m
