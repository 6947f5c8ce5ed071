"""Read and write scenes as TOML files; ``validate`` is the judge of what they hold."""

from __future__ import annotations

import difflib
import importlib.resources
import json
import math
import tomllib
from collections.abc import Iterable, Mapping
from dataclasses import fields
from importlib.resources.abc import Traversable
from pathlib import Path
from typing import Any

import numpy as np

from kinematics import poses
from kinematics.poses import Transform
from kinematics.shapes import Ball, Box, Cylinder, Shape
from robots import furniture
from robots.boards import board_tops_m
from robots.errors import SceneError
from robots.outside import SCENES, outside_files
from robots.scene_description import (
    Furniture,
    PerceptionModel,
    Person,
    Region,
    RobotStart,
    SceneDescription,
    SceneItem,
)
from robots.scene_parts import part_keys, part_values, read_part
from robots.scene_rules import validate
from robots.scene_words import CYLINDER_KINDS, HOLLOW_KINDS, OBJECT_KINDS, nearest_word

__all__ = ["dump", "known_scenes", "load_scene", "read_scene", "validate"]

Table = Mapping[str, Any]

_TOP_KEYS = ("robot_start", "perception", "furniture", "person", "object", "place")
_LARGEST_FILE = 1_000_000
"""Bytes; a scene that somebody writes by hand is a thousand times smaller."""


def known_scenes() -> list[str]:
    """Names of the scenes that come with the product and with other packages."""
    return sorted({*outside_files(SCENES), *_own_scenes()})


def _own_scenes() -> list[str]:
    names = (item.name for item in _scene_folder().iterdir())
    return [name.removesuffix(".toml") for name in names if name.endswith(".toml")]


def load_scene(name_or_path: str) -> SceneDescription:
    """Read a scene by its name, or from a file.

    Args:
        name_or_path: One of ``known_scenes()``, or the path of a TOML file.

    Raises:
        SceneError: There is no such scene, or it cannot be a world: file, key and reason.
    """
    if name_or_path in known_scenes():
        own = name_or_path in _own_scenes()
        file = _scene_folder() / f"{name_or_path}.toml" if own else outside_files(SCENES)[name_or_path]
        text = file.read_text("utf-8")
        return read_scene(text, f"{name_or_path}.toml", name_or_path)
    path = Path(name_or_path)
    is_path = name_or_path.endswith(".toml") or "/" in name_or_path or _is_file(path)
    if not is_path:
        near = nearest_word(name_or_path, known_scenes())
        reason = f"no scene of that name; the nearest is {near!r}, all: {', '.join(known_scenes())}"
        raise SceneError(name_or_path, "scene", reason)
    try:
        if path.stat().st_size > _LARGEST_FILE:
            raise SceneError(name_or_path, "file", f"larger than {_LARGEST_FILE} bytes")
        text = path.read_text("utf-8")
    except FileNotFoundError:
        near = _near_scene(path.stem)
        raise SceneError(name_or_path, "file", f"there is no such file{near}") from None
    except (OSError, UnicodeDecodeError, ValueError) as broken:
        raise SceneError(name_or_path, "file", f"cannot be read: {broken}") from broken
    return read_scene(text, name_or_path, path.stem)


def read_scene(text: str, source: str, name: str) -> SceneDescription:
    """Make a scene of a TOML document.

    Args:
        text: The document.
        source: File name for messages.
        name: Name of the scene.

    Raises:
        SceneError: It is no TOML, has unknown keys, or cannot be a world.
    """
    try:
        data = tomllib.loads(text)
    except (tomllib.TOMLDecodeError, RecursionError) as broken:
        raise SceneError(source, "file", f"is no TOML: {broken}") from broken
    root = _Reader(data, source, "")
    root.only(_TOP_KEYS)
    pieces = tuple(_furniture(reader) for reader in root.tables("furniture"))
    scene = SceneDescription(
        name=name,
        robot_start=_start(root.table("robot_start")),
        perception=_perception(root.table("perception")),
        furniture=pieces,
        objects=tuple(_item(reader, pieces) for reader in root.tables("object")),
        people=tuple(_person(reader) for reader in root.tables("person")),
        places=tuple(_region(reader) for reader in root.tables("place")),
    )
    validate(scene, source)
    return scene


def dump(scene: SceneDescription) -> str:
    """Write a scene as the TOML document that ``read_scene`` reads back.

    Raises:
        ValueError: An object is tilted, which a file cannot say.
    """
    start, model = scene.robot_start, scene.perception
    lines = [
        f"robot_start = {{ x_m = {start.x_m!r}, y_m = {start.y_m!r}, yaw_rad = {start.yaw_rad!r} }}",
        "",
        "[perception]",
        *(f"{item.name} = {_toml(getattr(model, item.name))}" for item in fields(model)),
    ]
    for piece in scene.furniture:
        lines += ["", "[[furniture]]", *_pairs(name=piece.name, kind=piece.kind, size_m=piece.size_m)]
        lines += _pairs(position_m=piece.position_m, yaw_rad=piece.yaw_rad, friction=piece.friction)
        lines += _pairs(**part_values(piece))
    for person in scene.people:
        lines += ["", "[[person]]", *_pairs(name=person.name, position_m=person.position_m)]
        lines += _pairs(yaw_rad=person.yaw_rad, takes=person.takes)
    for region in scene.places:
        lines += ["", "[[place]]", *_pairs(name=region.name, position_m=region.position_m)]
        lines += _pairs(size_m=region.size_m, yaw_rad=region.yaw_rad)
    for item in scene.objects:
        if item.world_T_object[2, 2] < 1.0 - 1e-12:
            raise ValueError(f"{item.name!r} is tilted; a scene file holds upright objects only")
        color = {} if item.color is None else {"color": item.color}
        lines += ["", "[[object]]", *_pairs(name=item.name, kind=item.kind, **color)]
        lines += _pairs(**_shape_keys(item.shape), mass_kg=item.mass_kg, friction=item.friction)
        if item.wall_m is not None:
            lines += _pairs(wall_m=item.wall_m)
        yaw = poses.yaw_of(item.world_T_object[:3, :3])
        lines += _pairs(position_m=tuple(map(float, item.world_T_object[:3, 3])), yaw_rad=yaw)
    return "\n".join(lines) + "\n"


def _pairs(**values: Any) -> list[str]:
    return [f"{key} = {_toml(value)}" for key, value in values.items()]


def _toml(value: Any) -> str:
    if isinstance(value, str):
        return json.dumps(value)
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, tuple):
        return "[" + ", ".join(_toml(item) for item in value) + "]"
    return repr(float(value))


def _shape_keys(shape: Shape) -> dict[str, Any]:
    match shape:
        case Box(size_m=size):
            return {"size_m": size}
        case Cylinder(radius_m=radius, height_m=height):
            return {"radius_m": radius, "height_m": height}
        case Ball(radius_m=radius):
            return {"radius_m": radius}


def _scene_folder() -> Traversable:
    return importlib.resources.files("robots") / "scenes"


def _is_file(path: Path) -> bool:
    try:
        return path.is_file()
    except (OSError, ValueError):
        return False


def _near_scene(stem: str) -> str:
    close = difflib.get_close_matches(stem, known_scenes(), n=1)
    return f"; did you mean the scene {close[0]!r}?" if close else ""


class _Reader:
    """One table of the document, with its key for messages."""

    def __init__(self, data: Any, source: str, key: str) -> None:
        self.data, self.source, self.key = data, source, key
        if not isinstance(data, dict):
            raise SceneError(source, key, "must be a table")

    def fail(self, key: str, reason: str) -> SceneError:
        return SceneError(self.source, f"{self.key}.{key}" if self.key else key, reason)

    def only(self, known: Iterable[str]) -> None:
        names = list(known)
        for key in self.data:
            if key not in names:
                near = nearest_word(key, names)
                raise self.fail(key, f"unknown key; the nearest is {near!r}, all: {', '.join(names)}")

    def table(self, key: str) -> _Reader:
        return _Reader(self.data.get(key, {}), self.source, f"{self.key}.{key}" if self.key else key)

    def tables(self, key: str) -> list[_Reader]:
        items = self.data.get(key, [])
        if not isinstance(items, list):
            raise self.fail(key, f"must be a list of tables: write [[{key}]]")
        return [_Reader(item, self.source, f"{key}[{i}]") for i, item in enumerate(items)]

    def _get(self, key: str) -> Any:
        if key not in self.data:
            raise self.fail(key, "is missing")
        return self.data[key]

    def text(self, key: str) -> str:
        value = self._get(key)
        if not isinstance(value, str) or not value.strip():
            raise self.fail(key, f"must be a text in quotes, not {value!r}")
        return value

    def word(self, key: str, known: Iterable[str]) -> str:
        value, words = self.text(key), list(known)
        if value not in words:
            near = nearest_word(value, words)
            raise self.fail(key, f"unknown {key} {value!r}; the nearest is {near!r}, all: {', '.join(words)}")
        return value

    def number(self, key: str, default: float | None = None) -> float:
        if default is not None and key not in self.data:
            return default
        return self._number(key, self._get(key))

    def _number(self, key: str, value: Any) -> float:
        if isinstance(value, bool) or not isinstance(value, int | float):
            raise self.fail(key, f"must be a number, not {value!r}")
        try:
            number = float(value)
        except OverflowError:
            number = math.inf
        if not math.isfinite(number):
            raise self.fail(key, f"must be finite, not {value!r}")
        return number

    def flag(self, key: str) -> bool:
        value = self.data.get(key, False)
        if not isinstance(value, bool):
            raise self.fail(key, f"must be true or false, not {value!r}")
        return value

    def numbers(self, key: str, count: int) -> tuple[float, ...]:
        value = self._get(key)
        if not isinstance(value, list) or len(value) != count:
            raise self.fail(key, f"must be a list of {count} numbers, not {value!r}")
        return tuple(self._number(f"{key}[{i}]", item) for i, item in enumerate(value))


def _start(reader: _Reader) -> RobotStart:
    reader.only(("x_m", "y_m", "yaw_rad"))
    return RobotStart(reader.number("x_m", 0.0), reader.number("y_m", 0.0), reader.number("yaw_rad", 0.0))


def _perception(reader: _Reader) -> PerceptionModel:
    default = PerceptionModel()
    names = [item.name for item in fields(PerceptionModel)]
    reader.only(names)
    kind = reader.word("kind", ("stub",)) if "kind" in reader.data else default.kind
    numbers = {name: reader.number(name, getattr(default, name)) for name in names if name != "kind"}
    return PerceptionModel(kind=kind, **numbers)


def _furniture(reader: _Reader) -> Furniture:
    kind = reader.word("kind", furniture.FURNITURE_KINDS)
    reader.only(("name", "kind", "size_m", "position_m", "yaw_rad", "friction", *part_keys(kind)))
    depth, width, height = reader.numbers("size_m", 3)
    x, y = reader.numbers("position_m", 2)
    return Furniture(
        name=reader.text("name"),
        kind=kind,
        size_m=(depth, width, height),
        position_m=(x, y),
        yaw_rad=reader.number("yaw_rad", 0.0),
        friction=reader.number("friction", 0.7),
        opens=read_part(reader, kind),
    )


def _person(reader: _Reader) -> Person:
    reader.only(("name", "position_m", "yaw_rad", "takes"))
    x, y = reader.numbers("position_m", 2)
    return Person(reader.text("name"), (x, y), reader.number("yaw_rad", 0.0), reader.flag("takes"))


def _region(reader: _Reader) -> Region:
    reader.only(("name", "position_m", "size_m", "yaw_rad"))
    x, y = reader.numbers("position_m", 2)
    along, across = reader.numbers("size_m", 2)
    return Region(reader.text("name"), (x, y), (along, across), reader.number("yaw_rad", 0.0))


def _item(reader: _Reader, pieces: tuple[Furniture, ...]) -> SceneItem:
    kind = reader.word("kind", OBJECT_KINDS)
    shape, shape_keys = _shape(reader, kind)
    common = ("name", "kind", "color", "mass_kg", "friction", "on", "board", "position_m", "yaw_rad")
    hollow = ("wall_m",) if kind in HOLLOW_KINDS else ()
    reader.only((*common, *shape_keys, *hollow))
    return SceneItem(
        name=reader.text("name"),
        kind=kind,
        color=reader.text("color") if "color" in reader.data else None,
        shape=shape,
        mass_kg=reader.number("mass_kg"),
        friction=reader.number("friction"),
        world_T_object=_place(reader, shape, pieces),
        wall_m=reader.number("wall_m") if "wall_m" in reader.data else None,
    )


def _shape(reader: _Reader, kind: str) -> tuple[Shape, tuple[str, ...]]:
    if kind == "ball":
        return Ball(reader.number("radius_m")), ("radius_m",)
    if kind in CYLINDER_KINDS:
        return Cylinder(reader.number("radius_m"), reader.number("height_m")), ("radius_m", "height_m")
    x, y, z = reader.numbers("size_m", 3)
    return Box((x, y, z)), ("size_m",)


# An object may reach over an edge, with its centre this share of its base's half-width inside.
STANDING_SHARE = 0.3


def _place(reader: _Reader, shape: Shape, pieces: tuple[Furniture, ...]) -> Transform:
    """``world_T_object`` of an object on furniture, or free with the position of its centre."""
    turn = poses.rotation_z(reader.number("yaw_rad", 0.0))
    if "on" not in reader.data:
        if "board" in reader.data:
            raise reader.fail("board", 'needs the shelf: write on = "..." as well')
        return poses.transform(turn, reader.numbers("position_m", 3))
    name = reader.word("on", [piece.name for piece in pieces]) if pieces else reader.text("on")
    carrier = next((piece for piece in pieces if piece.name == name), None)
    if carrier is None:
        raise reader.fail("on", f"there is no furniture {name!r}")
    x, y = reader.numbers("position_m", 2)
    depth, width, _ = carrier.size_m
    reach_x, reach_y = _base_reach(shape, turn)
    reach_x, reach_y = STANDING_SHARE * reach_x, STANDING_SHARE * reach_y
    if abs(x) + reach_x > 0.5 * depth + 1e-9 or abs(y) + reach_y > 0.5 * width + 1e-9:
        room = f"{depth:g} x {width:g} m, the origin of position_m in its centre"
        raise reader.fail("position_m", f"would tip off the edge of {name!r} ({room})")
    height = _board_m(reader, carrier) + 0.5 * shape.height_m
    return furniture.floor_pose(carrier) @ poses.transform(turn, (x, y, height))


def _board_m(reader: _Reader, carrier: Furniture) -> float:
    """Height of what an object stands on: the board that is named, counted from 0 at the foot, or the top."""
    tops = board_tops_m(carrier)
    if "board" not in reader.data:
        return tops[-1]
    number = reader.data["board"]
    if isinstance(number, bool) or not isinstance(number, int) or not 0 <= number < len(tops):
        reason = f"must be a whole number from 0 to {len(tops) - 1}, the boards of {carrier.name!r}"
        raise reader.fail("board", f"{reason}, not {number!r}")
    return tops[number]


def _base_reach(shape: Shape, turn: np.ndarray[Any, np.dtype[np.float64]]) -> tuple[float, float]:
    """Half-extents of the base along the carrier's x and y; of a ball, which touches in a point, 0."""
    match shape:
        case Box(size_m=size):
            x, y = np.abs(turn[:2, :2]) @ (0.5 * np.asarray(size[:2]))
            return float(x), float(y)
        case Cylinder(radius_m=radius):
            return radius, radius
        case Ball():
            return 0.0, 0.0
