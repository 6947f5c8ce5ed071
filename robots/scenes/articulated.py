"""Furniture that opens: a fridge with a hinged door, a chest whose top drawer slides.

In the furniture's own frame (origin in its centre on the floor, x along its depth) the front is at
negative x: whoever stands before it and looks along x sees it. ``hinge`` is named from there, so a left
hinge is at positive y.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final, Literal

import numpy as np

from kinematics.arrays import Sealed
from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Box, Cylinder
from robots.scenes.scene_description import Furniture, MovingPart

ARTICULATED_KINDS = ("drawers", "fridge")
DOOR: Final = "door"
DRAWER: Final = "drawer"
HANDLE: Final = "handle"
"""Kinds of the moving solids, as perception tells them."""
PART_KINDS = (DOOR, DRAWER, HANDLE)
DRAWER_BOTTOM: Final = "drawer bottom"
DRAWER_WALL: Final = "drawer wall"
"""Kinds of what an open drawer shows behind its front; perception tells them together, as one piece."""

WALL_M = 0.02
PANEL_M = 0.04
"""Thickness of a door."""
FRONT_M = 0.02
"""Thickness of a drawer's front."""
GAP_M = 0.01
"""Between a door or front and what it closes."""
STANDOFF_M = {"fridge": 0.055, "drawers": 0.05}
"""From the surface of the front to the middle of the handle's bar: room for a hand's fingers."""
DOOR_OPENS_RAD = math.radians(115.0)
DRAWER_FRONT_HEIGHT_M = 0.18
DRAWER_LENGTH_SHARE = 0.9
DRAWER_OPENS_SHARE = 0.85
POST_M = 0.016
BAR_MASS_KG = 0.3


SolidKind = Literal["door", "drawer", "handle", "drawer bottom", "drawer wall", ""]


@dataclass(frozen=True, slots=True)
class MovingSolid(Sealed):
    """One solid of a door or drawer, closed.

    Attributes:
        name: "fridge/door", "fridge/handle", ...
        kind: "door", "drawer", "handle", "drawer bottom" or "drawer wall" for what perception tells, "" for
            the rest.
        shape: Its solid.
        part_T_solid: Pose in the moving part's frame, shape (4, 4).
        grasped: Whether a hand takes hold of it: bar and posts.
    """

    name: str
    kind: SolidKind
    shape: Box | Cylinder
    part_T_solid: Transform
    grasped: bool = False


def moving_part(item: Furniture) -> MovingPart:
    """The part of a piece of furniture that opens.

    Raises:
        ValueError: It has none.
    """
    if item.opens is None:
        raise ValueError(f"{item.name!r} has nothing that opens")
    return item.opens


def opens_to(item: Furniture) -> float:
    """How far it can open: rad of a door, m of a drawer."""
    if item.kind == "fridge":
        return DOOR_OPENS_RAD
    return DRAWER_OPENS_SHARE * DRAWER_LENGTH_SHARE * item.size_m[0]


def hinge_side(item: Furniture) -> float:
    """+1 for a hinge at the left (positive y), -1 at the right."""
    return 1.0 if moving_part(item).hinge == "left" else -1.0


def furniture_T_part(item: Furniture) -> Transform:
    """Frame of the moving part while closed: the hinge axis on the floor, or the front's middle."""
    depth, width, height = item.size_m
    if item.kind == "fridge":
        return poses.translation(-0.5 * depth + 0.5 * PANEL_M, hinge_side(item) * 0.5 * width, 0.0)
    return poses.translation(
        -0.5 * depth + 0.5 * FRONT_M, 0.0, height - WALL_M - GAP_M - 0.5 * DRAWER_FRONT_HEIGHT_M
    )


def opened(item: Furniture, amount: float) -> Transform:
    """Motion of the part in its own frame: a turn about z, outwards, or a shift towards negative x."""
    if item.kind == "fridge":
        return poses.transform(poses.rotation_z(-hinge_side(item) * amount), (0.0, 0.0, 0.0))
    return poses.translation(-amount, 0.0, 0.0)


def fixed_boxes(item: Furniture) -> list[tuple[str, tuple[float, float, float], tuple[float, float, float]]]:
    """What does not move: name of the part, size, and centre in the furniture's frame; largest first."""
    depth, width, height = item.size_m
    front = (PANEL_M if item.kind == "fridge" else FRONT_M) + GAP_M
    length = depth - front
    x, back = -0.5 * depth + front + 0.5 * length, 0.5 * depth - 0.5 * WALL_M
    y = 0.5 * (width - WALL_M)
    if item.kind == "fridge":
        shelves = [
            ("shelf_1", 0.40 * height),
            ("shelf_2", 0.65 * height),
        ]
        return [
            ("top", (length, width, WALL_M), (x, 0.0, height - 0.5 * WALL_M)),
            ("bottom", (length, width, 0.1), (x, 0.0, 0.05)),
            *((name, (length, width - 2.0 * WALL_M, WALL_M), (x, 0.0, z)) for name, z in shelves),
            ("left", (length, WALL_M, height), (x, y, 0.5 * height)),
            ("right", (length, WALL_M, height), (x, -y, 0.5 * height)),
            ("back", (WALL_M, width, height), (back, 0.0, 0.5 * height)),
        ]
    below = height - WALL_M - 2.0 * GAP_M - DRAWER_FRONT_HEIGHT_M
    rise, middle = height - below, 0.5 * (height + below)
    return [
        ("top", (length, width, WALL_M), (x, 0.0, height - 0.5 * WALL_M)),
        ("block", (depth, width, below), (0.0, 0.0, 0.5 * below)),
        ("left", (length, WALL_M, rise), (x, y, middle)),
        ("right", (length, WALL_M, rise), (x, -y, middle)),
        ("back", (WALL_M, width, rise), (back, 0.0, middle)),
    ]


def moving_solids(item: Furniture) -> tuple[MovingSolid, ...]:
    """The solids of the door or drawer: the front first, then the handle's bar."""
    return _door(item) if item.kind == "fridge" else _drawer(item)


def _door(item: Furniture) -> tuple[MovingSolid, ...]:
    part, (_, width, height) = moving_part(item), item.size_m
    side, tall = hinge_side(item), height - 0.1
    middle = poses.translation(0.0, -side * 0.5 * width, 0.1 + 0.5 * tall)
    y, x = -side * (width - part.handle_inset_m), -(0.5 * PANEL_M + STANDOFF_M["fridge"])
    bar = poses.translation(x, y, part.handle_height_m)
    return (
        MovingSolid(f"{item.name}/door", DOOR, Box((PANEL_M, width, tall)), middle),
        *_handle(item, bar, -0.5 * PANEL_M),
    )


def _drawer(item: Furniture) -> tuple[MovingSolid, ...]:
    part, (depth, width, _) = moving_part(item), item.size_m
    length, high, wide = DRAWER_LENGTH_SHARE * depth, DRAWER_FRONT_HEIGHT_M, width - 4.0 * WALL_M
    back, wall = 0.5 * FRONT_M + length, 0.01
    x = 0.5 * FRONT_M + 0.5 * length
    sides: list[tuple[str, tuple[float, float, float], tuple[float, float, float]]] = [
        ("floor", (length, wide, wall), (x, 0.0, -0.5 * high + 0.02)),
        ("side_1", (length, wall, 0.6 * high), (x, 0.5 * wide, -0.1 * high)),
        ("side_2", (length, wall, 0.6 * high), (x, -0.5 * wide, -0.1 * high)),
        ("end", (wall, wide, 0.6 * high), (back, 0.0, -0.1 * high)),
    ]
    lying = poses.transform(
        poses.rotation_x(0.5 * math.pi), (-(0.5 * FRONT_M + STANDOFF_M["drawers"]), 0.0, 0.0)
    )
    lift = poses.translation(0.0, 0.0, part.handle_height_m)
    return (
        MovingSolid(f"{item.name}/drawer", DRAWER, Box((FRONT_M, width, high)), np.eye(4)),
        *_handle(item, lift @ lying, -0.5 * FRONT_M),
        *(
            MovingSolid(
                f"{item.name}/drawer_{name}",
                DRAWER_BOTTOM if name == "floor" else DRAWER_WALL,
                Box(size),
                poses.translation(*place),
            )
            for name, size, place in sides
        ),
    )


def _handle(item: Furniture, part_T_bar: Transform, surface_x_m: float) -> list[MovingSolid]:
    """A bar on two posts."""
    part = moving_part(item)
    bar = Cylinder(part.handle_radius_m, part.handle_length_m)
    solids = [MovingSolid(f"{item.name}/handle", HANDLE, bar, part_T_bar, grasped=True)]
    length = surface_x_m - float(part_T_bar[0, 3])
    for i, end in enumerate((-1.0, 1.0), start=1):
        at = part_T_bar @ np.array([0.0, 0.0, end * (0.5 * part.handle_length_m - POST_M), 1.0])
        place = poses.translation(float(at[0]) + 0.5 * length, float(at[1]), float(at[2]))
        post = Box((length, POST_M, POST_M))
        solids.append(MovingSolid(f"{item.name}/handle_post_{i}", "", post, place, grasped=True))
    return solids
