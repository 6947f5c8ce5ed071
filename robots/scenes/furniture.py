"""Pieces of furniture as the solids that they are made of."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from types import MappingProxyType

from kinematics.arrays import Sealed
from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Box
from robots.scenes.articulated import ARTICULATED_KINDS, fixed_boxes
from robots.scenes.fixture import fixture_boxes
from robots.scenes.furniture_names import FIXTURE
from robots.scenes.scene_description import Furniture

BOARD_KINDS = ("counter", "shelf")


BOARD_M = 0.02


"""Thickness of a shelf's boards and sides."""


PITCH_M = 0.40


"""From board to board, about: room for a bottle and a hand above it."""


WORKTOP_M = 0.04


OVERHANG_M = 0.03


"""A worktop stands out so far before what carries it: room for a thigh."""


PLINTH_HEIGHT_M, PLINTH_M = 0.10, 0.09


"""What carries a counter draws back so far at the floor: room for toes."""


Boxes = list[tuple[str, tuple[float, float, float], tuple[float, float, float]]]


def board_tops_m(item: Furniture) -> tuple[float, ...]:
    """Heights above the floor at which things can stand, the lowest first.

    A shelf has a board at its foot and one at its top, and others between them about ``PITCH_M`` apart;
    all else carries on its top alone.
    """
    height = item.size_m[2]
    if item.kind != "shelf":
        return (height,)
    rooms = max(1, round((height - BOARD_M) / PITCH_M))
    return tuple(BOARD_M + (height - BOARD_M) * k / rooms for k in range(rooms + 1))


def board_boxes(item: Furniture) -> Boxes:
    """The solids of a shelf or counter: part, size, and centre in its frame; the top first."""
    return _shelf(item) if item.kind == "shelf" else _counter(item)


def _shelf(item: Furniture) -> Boxes:
    depth, width, height = item.size_m
    *inner, top = board_tops_m(item)
    between, below = width - 2.0 * BOARD_M, height - BOARD_M
    y = 0.5 * (width - BOARD_M)
    return [
        ("top", (depth, width, BOARD_M), (0.0, 0.0, top - 0.5 * BOARD_M)),
        *(
            (f"board_{k}", (depth - BOARD_M, between, BOARD_M), (-0.5 * BOARD_M, 0.0, z - 0.5 * BOARD_M))
            for k, z in enumerate(inner)
        ),
        ("left", (depth, BOARD_M, below), (0.0, y, 0.5 * below)),
        ("right", (depth, BOARD_M, below), (0.0, -y, 0.5 * below)),
        ("back", (BOARD_M, between, below), (0.5 * (depth - BOARD_M), 0.0, 0.5 * below)),
    ]


def _counter(item: Furniture) -> Boxes:
    depth, width, height = item.size_m
    body, plinth = depth - OVERHANG_M, depth - PLINTH_M
    rise = height - WORKTOP_M - PLINTH_HEIGHT_M
    return [
        ("top", (depth, width, WORKTOP_M), (0.0, 0.0, height - 0.5 * WORKTOP_M)),
        ("body", (body, width, rise), (0.5 * OVERHANG_M, 0.0, PLINTH_HEIGHT_M + 0.5 * rise)),
        ("plinth", (plinth, width, PLINTH_HEIGHT_M), (0.5 * PLINTH_M, 0.0, 0.5 * PLINTH_HEIGHT_M)),
    ]


WALL = "wall"


def wall_boxes(item: Furniture) -> list[tuple[str, tuple[float, float, float], tuple[float, float, float]]]:
    """The one solid of a wall: part, size, and centre in its frame."""
    depth, width, height = item.size_m
    return [("face", (depth, width, height), (0.0, 0.0, 0.5 * height))]


TABLE_TOP_M = 0.04
"""Thickness of a table's top, usual for a kitchen table."""
TABLE_LEG_M = 0.05
"""Edge of a table's square legs, flush with the corners of the top."""

FURNITURE_KINDS = ("table", *BOARD_KINDS, WALL, *ARTICULATED_KINDS, FIXTURE)


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


def region_plates(item: Furniture) -> tuple[FurnitureSolid, ...]:
    """The floors of its named regions, as what is told of them: "stove/burner"."""
    plates = []
    for region in item.regions:
        size, place = region.plate
        pose = floor_pose(item) @ poses.translation(*place)
        plates.append(FurnitureSolid(f"{item.name}/{region.name}", Box(size), pose))
    return tuple(plates)


_BOXES: Mapping[str, Callable[[Furniture], Boxes]] = MappingProxyType(
    {
        WALL: wall_boxes,
        FIXTURE: lambda item: fixture_boxes(item.size_m, item.foot_m, item.boxes),
        **dict.fromkeys(BOARD_KINDS, board_boxes),
        **dict.fromkeys(ARTICULATED_KINDS, fixed_boxes),
    }
)
"""What all but tables are made of."""
