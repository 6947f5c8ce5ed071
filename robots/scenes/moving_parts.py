"""What of a piece of furniture moves: the door of a fridge, a chest's drawer, all that a fixture opens."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from kinematics.arrays import Sealed
from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Box, Cylinder
from kinematics.scene.known_part import KnownPart
from robots.scenes import articulated
from robots.scenes.articulated import (
    DRAWER,
    DRAWER_BOTTOM,
    DRAWER_WALL,
    HANDLE,
    POST_M,
    MovingSolid,
    SolidKind,
)
from robots.scenes.fixture import FixedBox
from robots.scenes.opening import Opening
from robots.scenes.scene_description import Furniture, MovingPart


@dataclass(frozen=True, slots=True)
class Moving(Sealed):
    """A door or drawer of a piece of furniture.

    Attributes:
        name: As tests and evaluations ask for it: "fridge", "wooden cabinet/top drawer".
        part: What it weighs, how it moves, and how far it is open.
        furniture_T_part: Its frame while shut: a hinge's axis on the floor, or the front's middle; x inwards.
        travel: How far it opens, rad or m.
        lever_m: From a door's hinge to its handle; 0 of a drawer.
        solids: The front first, then the handle's bar.
        recognised: Whether a detector knows its piece by a model of it, and where it is when it is shut.
    """

    name: str
    part: MovingPart
    furniture_T_part: Transform
    travel: float
    lever_m: float
    solids: tuple[MovingSolid, ...]
    recognised: bool

    @property
    def side(self) -> float:
        """+1 for a hinge at the left (positive y), -1 at the right, 0 of a drawer."""
        return {"left": 1.0, "right": -1.0, None: 0.0}[self.part.hinge]

    def opened(self, amount: float) -> Transform:
        """Its motion in its own frame: a turn about z, outwards, or a shift towards negative x."""
        if self.part.hinge is not None:
            return poses.transform(poses.rotation_z(-self.side * amount), (0.0, 0.0, 0.0))
        return poses.translation(-amount, 0.0, 0.0)

    def world_T_solid(self, world_T_furniture: Transform, solid: MovingSolid) -> Transform:
        """Where one of its solids is when the scene begins."""
        moved = self.opened(self.part.opening)
        return np.asarray(world_T_furniture @ self.furniture_T_part @ moved @ solid.part_T_solid)

    def known_part(
        self, world_T_furniture: Transform, solid: MovingSolid, of: str, names: tuple[str, ...] = ()
    ) -> KnownPart | None:
        """What a detector tells with one of its solids; None of what it has no model of."""
        if not self.recognised:
            return None
        x, y = (float(value) for value in poses.inverse(solid.part_T_solid)[:2, 3])
        shut = np.asarray(world_T_furniture @ self.furniture_T_part @ solid.part_T_solid)
        hinge_m = (x, y) if self.side else (0.0, 0.0)
        return KnownPart(shut, self.travel, of, self.name.rpartition("/")[2], self.side, hinge_m, names)


def moving_parts(item: Furniture) -> tuple[Moving, ...]:
    """Everything of a piece that opens."""
    if item.opens is None:
        return tuple(_of_fixture(item, one) for one in item.openings)
    part = item.opens
    lever_m = 0.0 if part.hinge is None else item.size_m[1] - part.handle_inset_m
    return (
        Moving(
            item.name,
            part,
            articulated.furniture_T_part(item),
            articulated.opens_to(item),
            lever_m,
            articulated.moving_solids(item),
            recognised=False,
        ),
    )


def _of_fixture(item: Furniture, one: Opening) -> Moving:
    part = MovingPart(
        hinge=one.hinge,
        mass_kg=one.mass_kg,
        friction=one.friction,
        seal_n=one.seal_n,
        locked=one.locked,
        opening=one.opening,
        handle_friction=one.handle_friction,
    )
    front = one.boxes[0]
    x, y, z = front.position_m if one.kind == DRAWER else (*one.axis_m, 0.0)
    frame = poses.translation(x, y, z)
    name = f"{item.name}/{one.name}"
    solids = [MovingSolid(f"{name}/front", one.kind, Box(front.size_m), _in(frame, front))]
    solids += _bar(name, one, frame)
    lever_m = 0.0
    if one.kind == "door":
        lever_m = abs((front.position_m if one.bar is None else one.bar.position_m)[1] - y)
        rest: list[tuple[SolidKind, FixedBox]] = [("", box) for box in one.boxes[1:]]
    else:
        rest = _inside(one.boxes[1:])
    for k, (kind, box) in enumerate(rest, start=1):
        solids.append(MovingSolid(f"{name}/box_{k}", kind, Box(box.size_m), _in(frame, box)))
    return Moving(name, part, frame, one.travel, lever_m, tuple(solids), recognised=True)


def _in(frame: Transform, box: FixedBox) -> Transform:
    return np.asarray(poses.inverse(frame) @ poses.translation(*box.position_m))


def _inside(boxes: tuple[FixedBox, ...]) -> list[tuple[SolidKind, FixedBox]]:
    """What is behind a drawer's front: its bottom is the widest floor of it, all else are walls."""
    flat = [box for box in boxes if box.size_m[2] <= min(box.size_m[:2])]
    bottom = max(flat, key=lambda box: box.size_m[0] * box.size_m[1], default=None)
    return [(DRAWER_BOTTOM if box is bottom else DRAWER_WALL, box) for box in boxes]


def _bar(name: str, one: Opening, frame: Transform) -> list[MovingSolid]:
    """A bar on two posts, which reach from its middle to the front."""
    if one.bar is None:
        return []
    bar, front = one.bar, one.boxes[0]
    at = poses.inverse(frame) @ poses.translation(*bar.position_m)
    lying = np.eye(4) if bar.upright else poses.transform(poses.rotation_x(0.5 * np.pi), (0.0, 0.0, 0.0))
    solids = [
        MovingSolid(f"{name}/handle", HANDLE, Cylinder(bar.radius_m, bar.length_m), at @ lying, grasped=True)
    ]
    out_m = front.position_m[0] - 0.5 * front.size_m[0] - bar.position_m[0]
    thick_m = min(POST_M, bar.length_m / 6.0)
    if out_m <= bar.radius_m:
        return solids
    for k, end in enumerate((-1.0, 1.0), start=1):
        shift = end * 0.5 * (bar.length_m - thick_m)
        aside = (0.0, shift) if bar.upright else (shift, 0.0)
        place = at @ poses.translation(0.5 * out_m, *aside)
        post = Box((out_m, thick_m, thick_m))
        solids.append(MovingSolid(f"{name}/handle_post_{k}", "", post, place, grasped=True))
    return solids
