"""Pieces of furniture as the solids that they are made of."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from types import MappingProxyType

from kinematics import poses
from kinematics.arrays import Sealed
from kinematics.poses import Transform
from kinematics.shapes import Box
from robots.articulated import ARTICULATED_KINDS, fixed_boxes
from robots.boards import BOARD_KINDS, Boxes, board_boxes
from robots.scene_description import Furniture
from robots.walls import WALL, wall_boxes

TABLE_TOP_M = 0.04
"""Thickness of a table's top, usual for a kitchen table."""
TABLE_LEG_M = 0.05
"""Edge of a table's square legs, flush with the corners of the top."""

FURNITURE_KINDS = ("table", *BOARD_KINDS, WALL, *ARTICULATED_KINDS)


@dataclass(frozen=True, slots=True)
class FurnitureSolid(Sealed):
    """One solid of a piece of furniture; ``name`` is "table/top", "table/leg_1", ..."""

    name: str
    shape: Box
    world_T_solid: Transform


def floor_pose(item: Furniture) -> Transform:
    """``world_T_furniture``: its centre on the floor, x along its depth."""
    return poses.transform(poses.rotation_z(item.yaw_rad), (*item.position_m, 0.0))


def solids(item: Furniture) -> tuple[FurnitureSolid, ...]:
    """The solids of a piece of furniture that do not move, the one that carries things first."""
    if item.kind != "table":
        boxes = _BOXES[item.kind](item)
        return tuple(
            FurnitureSolid(f"{item.name}/{part}", Box(size), floor_pose(item) @ poses.translation(*place))
            for part, size, place in boxes
        )
    depth, width, height = item.size_m
    world_T_furniture = floor_pose(item)
    leg_height = height - TABLE_TOP_M

    def solid(part: str, size_m: tuple[float, float, float], x: float, y: float, z: float) -> FurnitureSolid:
        return FurnitureSolid(
            f"{item.name}/{part}", Box(size_m), world_T_furniture @ poses.translation(x, y, z)
        )

    x, y = 0.5 * (depth - TABLE_LEG_M), 0.5 * (width - TABLE_LEG_M)
    legs = [
        solid(f"leg_{i}", (TABLE_LEG_M, TABLE_LEG_M, leg_height), sx * x, sy * y, 0.5 * leg_height)
        for i, (sx, sy) in enumerate(((1, 1), (1, -1), (-1, -1), (-1, 1)), start=1)
    ]
    top = solid("top", (depth, width, TABLE_TOP_M), 0.0, 0.0, height - 0.5 * TABLE_TOP_M)
    return (top, *legs)


_BOXES: Mapping[str, Callable[[Furniture], Boxes]] = MappingProxyType(
    {
        WALL: wall_boxes,
        **dict.fromkeys(BOARD_KINDS, board_boxes),
        **dict.fromkeys(ARTICULATED_KINDS, fixed_boxes),
    }
)
"""What all but tables are made of."""
