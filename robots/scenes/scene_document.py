"""What a scene file may say, key by key; what is read becomes values of ``scene_description``."""

from __future__ import annotations

import difflib
from dataclasses import replace
from typing import Annotated, Any, ClassVar, Literal

from pydantic import BeforeValidator, Discriminator, Field, FiniteFloat, Tag, ValidationInfo

from kinematics.geometry.shapes import Ball, Box, Cylinder
from robots.scenes.fixed_camera import FixedCamera
from robots.scenes.fixture import Control, FixedBox
from robots.scenes.light import Light, LightChange, LightKind
from robots.scenes.meshes.sidecar import UpKey
from robots.scenes.named_region import NamedRegion
from robots.scenes.opening import Bar, Opening
from robots.scenes.scene_description import (
    Furniture,
    MovingPart,
    PerceptionModel,
    Person,
    Region,
    RobotStart,
)
from robots.scenes.scene_words import CYLINDER_KINDS, OBJECT_KINDS
from robots.scenes.usual_properties import USUAL_FRICTION
from robots.strict_table import (
    TAG,
    AsTable,
    Pair,
    StrictTable,
    Text,
    Texts,
    Triple,
    as_tuple,
    said_of,
    unknown_word,
)


class _PieceTable(StrictTable):
    """``[[furniture]]``: what every piece has."""

    name: Text
    kind: str
    names: Texts = ()
    categories: Texts = ()
    size_m: Triple
    position_m: Pair
    yaw_rad: FiniteFloat = 0.0
    friction: FiniteFloat = 0.7
    region: list[Annotated[NamedRegion, AsTable()]] = Field(default_factory=list)

    def value(self) -> Furniture:
        """What it says."""
        return Furniture(
            name=self.name,
            kind=self.kind,
            size_m=self.size_m,
            position_m=self.position_m,
            yaw_rad=self.yaw_rad,
            friction=self.friction,
            opens=self.part(),
            regions=tuple(self.region),
            names=self.names,
            categories=self.categories,
        )

    def part(self) -> MovingPart | None:
        """What of it opens."""
        return None


class FurnitureTable(_PieceTable):
    """A piece that does not open."""

    kind: Literal["table", "counter", "shelf", "wall"]


class _OpeningTable(_PieceTable):
    """``[[furniture]]`` that opens: what its door and its drawer have in common."""

    mass_kg: FiniteFloat
    locked: bool = False
    handle_height_m: FiniteFloat
    handle_radius_m: FiniteFloat
    handle_length_m: FiniteFloat
    handle_friction: FiniteFloat = 0.9


class DrawersTable(_OpeningTable):
    """A chest of drawers, of which the top one opens."""

    kind: Literal["drawers"]
    mass_kg: FiniteFloat = 4.0
    handle_height_m: FiniteFloat = 0.0
    handle_radius_m: FiniteFloat = 0.010
    handle_length_m: FiniteFloat = 0.16
    friction_n: FiniteFloat = 10.0
    open_m: FiniteFloat = 0.0

    def part(self) -> MovingPart:
        """Its drawer."""
        return MovingPart(
            hinge=None,
            mass_kg=self.mass_kg,
            friction=self.friction_n,
            locked=self.locked,
            opening=self.open_m,
            handle_height_m=self.handle_height_m,
            handle_inset_m=0.0,
            handle_radius_m=self.handle_radius_m,
            handle_length_m=self.handle_length_m,
            handle_friction=self.handle_friction,
        )


class FridgeTable(_OpeningTable):
    """A fridge, whose door opens."""

    kind: Literal["fridge"]
    mass_kg: FiniteFloat = 14.0
    handle_height_m: FiniteFloat = 1.0
    handle_radius_m: FiniteFloat = 0.0125
    handle_length_m: FiniteFloat = 0.36
    hinge: Literal["left", "right"]
    friction_nm: FiniteFloat = 2.0
    seal_n: FiniteFloat = 30.0
    open_rad: FiniteFloat = 0.0
    handle_inset_m: FiniteFloat = 0.06

    def part(self) -> MovingPart:
        """Its door."""
        return MovingPart(
            hinge=self.hinge,
            mass_kg=self.mass_kg,
            friction=self.friction_nm,
            seal_n=self.seal_n,
            locked=self.locked,
            opening=self.open_rad,
            handle_height_m=self.handle_height_m,
            handle_inset_m=self.handle_inset_m,
            handle_radius_m=self.handle_radius_m,
            handle_length_m=self.handle_length_m,
            handle_friction=self.handle_friction,
        )


class OpeningTable(StrictTable):
    """``[[furniture.opening]]``: a door or drawer of a fixture."""

    name: Text
    kind: Literal["door", "drawer"]
    travel: FiniteFloat
    box: list[Annotated[FixedBox, AsTable()]] = Field(default_factory=list)
    bar: Annotated[Bar, AsTable()] | None = None
    hinge: Literal["left", "right"] | None = None
    hinge_m: Pair | None = None
    mass_kg: FiniteFloat = 1.0
    friction: FiniteFloat = 1.0
    seal_n: FiniteFloat = 0.0
    locked: bool = False
    opening: FiniteFloat = Field(0.0, alias="open")
    handle_friction: FiniteFloat = 0.9

    def value(self) -> Opening:
        """What it says."""
        said = {key: getattr(self, key) for key in type(self).model_fields if key != "box"}
        return Opening(boxes=tuple(self.box), **said)


class FixtureTable(_PieceTable):
    """What is fixed where it stands, made of boxes, with its doors, drawers, knobs and buttons."""

    kind: Literal["fixture"]
    foot_m: FiniteFloat = 0.0
    box: list[Annotated[FixedBox, AsTable()]] = Field(default_factory=list)
    control: list[Annotated[Control, AsTable()]] = Field(default_factory=list)
    opening: list[OpeningTable] = Field(default_factory=list)

    def value(self) -> Furniture:
        """What it says."""
        return replace(
            super().value(),
            foot_m=self.foot_m,
            boxes=tuple(self.box),
            controls=tuple(self.control),
            openings=tuple(one.value() for one in self.opening),
        )


def _position(value: Any, info: ValidationInfo) -> Any:
    """Two numbers of what stands on furniture, three of what stands free."""
    return as_tuple(value, 3 if info.data.get("on") is None else 2)


class _ObjectTable(StrictTable):
    """``[[object]]``: what objects of every kind have."""

    like: ClassVar[str]
    """The usual kind that has its shape."""

    name: Text
    kind: Text
    names: Texts = ()
    categories: Texts = ()
    said_shape: str | None = Field(None, alias="shape")
    color: Text | None = None
    mass_kg: FiniteFloat | None = None
    friction: FiniteFloat = USUAL_FRICTION
    on: Text | None = None
    board: Any = None
    position_m: Annotated[tuple[FiniteFloat, ...] | None, BeforeValidator(_position)] = None
    yaw_rad: FiniteFloat = 0.0
    texture: Text | None = None

    @property
    def weighs_as(self) -> str:
        """The usual kind that weighs as much for its size: its own, else the one that has its shape."""
        return self.kind if self.kind in OBJECT_KINDS and self.said_shape is None else self.like


class _RoundTable(_ObjectTable):
    """What stands upright, and is round."""

    radius_m: FiniteFloat
    height_m: FiniteFloat

    def shape(self) -> Cylinder:
        """Its outline."""
        return Cylinder(self.radius_m, self.height_m)


class CylinderTable(_RoundTable):
    """What is round, and closed."""

    like = "can"


class BowlTable(_RoundTable):
    """A bowl, which may be hollow."""

    like = "bowl"
    wall_m: FiniteFloat | None = None


class BoxTable(_ObjectTable):
    """A box, which may be hollow."""

    like = "box"
    size_m: Triple
    wall_m: FiniteFloat | None = None

    def shape(self) -> Box:
        """Its outline."""
        return Box(self.size_m)


class BallTable(_ObjectTable):
    """A ball."""

    like = "ball"
    radius_m: FiniteFloat

    def shape(self) -> Ball:
        """Its outline."""
        return Ball(self.radius_m)


class MeshTable(_ObjectTable):
    """What has a mesh for a shape; what is not said is as its sidecar says."""

    like = "box"
    mesh: Text
    name: Text = ""
    kind: Text = ""
    label: Text | None = None
    scale: FiniteFloat | None = None
    up: UpKey | None = None
    density_kg_m3: FiniteFloat | None = None
    friction: FiniteFloat | None = None  # type: ignore[assignment]


AnyFurniture = Annotated[
    FurnitureTable | DrawersTable | FridgeTable | FixtureTable, Field(discriminator="kind")
]
ObjectTable = CylinderTable | BowlTable | BoxTable | BallTable | MeshTable

_A_SLIP = 0.8
"""Likeness of two words of which one is the other misspelled."""
_SHAPES = ("cylinder", "bowl", "box", "ball")
_USUAL = {**dict.fromkeys(CYLINDER_KINDS, "cylinder"), "bowl": "bowl", "box": "box", "ball": "ball"}
_SIZES = "say size_m = [x, y, z] of a box, radius_m and height_m of a cylinder, or radius_m of a ball"


def _shaped(data: Any) -> Any:
    """Refuse an object whose shape nothing tells; a kind that is nearly a usual one is a slip of the pen."""
    if not isinstance(data, dict) or "mesh" in data or (kind := data.get("kind")) is None:
        return data
    if "shape" in data and data["shape"] not in _SHAPES:
        raise said_of("shape", unknown_word("shape", str(data["shape"]), _SHAPES))
    if _shape_of(data) != _UNTOLD:
        return data
    if not isinstance(kind, str) or not kind.strip():
        raise said_of("kind", f"must be a text in quotes, not {kind!r}")
    if near := difflib.get_close_matches(kind, _USUAL, n=1, cutoff=_A_SLIP):
        told = f"unknown kind {kind!r}; the nearest is {near[0]!r}, all: {', '.join(_USUAL)}"
        raise said_of("kind", f'{told}; of any other kind say the shape, shape = "box"')
    raise said_of("kind", f"{kind!r} is none of the usual kinds, {', '.join(_USUAL)}: {_SIZES}")


_UNTOLD = "untold"


def _shape_of(data: Any) -> str | None:
    """Which table an object is read as; pydantic asks for it."""
    if isinstance(data, dict) and "mesh" in data:
        return f"{TAG}mesh"
    if not isinstance(data, dict) or data.get("kind") is None:
        return None
    kind, shape = data["kind"], data.get("shape")
    if isinstance(shape, str):
        return f"{TAG}{shape}"
    if not isinstance(kind, str) or not kind.strip():
        return _UNTOLD
    if kind in _USUAL:
        return f"{TAG}{_USUAL[kind]}"
    if difflib.get_close_matches(kind, _USUAL, n=1, cutoff=_A_SLIP):
        return _UNTOLD
    if "size_m" in data:
        return f"{TAG}box"
    if "radius_m" in data:
        return f"{TAG}cylinder" if "height_m" in data else f"{TAG}ball"
    return _UNTOLD


AnyObject = Annotated[
    Annotated[CylinderTable, Tag(f"{TAG}cylinder")]
    | Annotated[BowlTable, Tag(f"{TAG}bowl")]
    | Annotated[BoxTable, Tag(f"{TAG}box")]
    | Annotated[BallTable, Tag(f"{TAG}ball")]
    | Annotated[MeshTable, Tag(f"{TAG}mesh")],
    Discriminator(_shape_of),
    BeforeValidator(_shaped),
]


class LightTable(StrictTable):
    """``[light]``."""

    kind: LightKind = "bright"
    change: list[Annotated[LightChange, AsTable()]] = Field(default_factory=list)

    def value(self) -> Light:
        """What it says."""
        return Light(self.kind, tuple(self.change))


class SceneDocument(StrictTable):
    """A scene file."""

    robot_start: Annotated[RobotStart, AsTable()] = RobotStart()
    perception: Annotated[PerceptionModel, AsTable()] = PerceptionModel()
    furniture: list[AnyFurniture] = Field(default_factory=list)
    person: list[Annotated[Person, AsTable(yaw_rad=0.0)]] = Field(default_factory=list)
    object: list[AnyObject] = Field(default_factory=list)
    place: list[Annotated[Region, AsTable()]] = Field(default_factory=list)
    light: LightTable = LightTable()
    camera: list[Annotated[FixedCamera, AsTable()]] = Field(default_factory=list)
