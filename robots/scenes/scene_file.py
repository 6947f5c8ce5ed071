"""Read scenes from TOML files; ``validate`` is the judge of what they hold."""

from __future__ import annotations

import difflib
import importlib.resources
from collections.abc import Mapping
from dataclasses import fields
from importlib.resources.abc import Traversable
from pathlib import Path
from typing import Any, cast

import numpy as np

from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Ball, Box, Cylinder, Shape
from robots.errors import SceneError
from robots.outside import SCENES, outside_files
from robots.scenes import furniture
from robots.scenes.furniture import board_tops_m
from robots.scenes.scene_description import (
    GESTURES,
    POSTURES,
    Furniture,
    PerceptionModel,
    Person,
    Posture,
    Region,
    RobotStart,
    SceneDescription,
    SceneItem,
)
from robots.scenes.scene_parts import part_keys, read_part
from robots.scenes.scene_rules import validate
from robots.scenes.scene_table import SceneTable
from robots.scenes.scene_words import CYLINDER_KINDS, HOLLOW_KINDS, OBJECT_KINDS, nearest_word
from robots.scenes.usual_properties import USUAL_FRICTION, usual_mass_kg
from robots.toml_text import TomlTextError, read_toml

Table = Mapping[str, Any]

_TOP_KEYS = ("robot_start", "perception", "furniture", "person", "object", "place")
_LARGEST_FILE = 1_000_000
"""Bytes; a scene that somebody writes by hand is a thousand times smaller."""

MOST_THINGS = 500
"""Furniture, objects, people and places: each is held against each of the others."""


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
        data = read_toml(text)
    except TomlTextError as broken:
        raise SceneError(source, "file", f"is no TOML: {broken}") from broken
    root = SceneTable(data, source, "")
    root.only(_TOP_KEYS)
    count = sum(len(found) for key in _TOP_KEYS if isinstance(found := data.get(key), list))
    if count > MOST_THINGS:
        raise SceneError(source, "file", f"has {count} things; a scene holds at most {MOST_THINGS}")
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


def _start(reader: SceneTable) -> RobotStart:
    reader.only(("x_m", "y_m", "yaw_rad"))
    return RobotStart(reader.number("x_m", 0.0), reader.number("y_m", 0.0), reader.number("yaw_rad", 0.0))


def _perception(reader: SceneTable) -> PerceptionModel:
    default = PerceptionModel()
    names = [item.name for item in fields(PerceptionModel)]
    reader.only(names)
    kind = reader.word("kind", ("stub",)) if "kind" in reader.data else default.kind
    texts = ("kind", "labels")
    numbers = {name: reader.number(name, getattr(default, name)) for name in names if name not in texts}
    return PerceptionModel(kind=kind, labels=reader.texts("labels"), **numbers)


def _furniture(reader: SceneTable) -> Furniture:
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


def _person(reader: SceneTable) -> Person:
    reader.only([item.name for item in fields(Person)])
    x, y = reader.numbers("position_m", 2)
    usual = Person("", (x, y), 0.0)
    return Person(
        name=reader.text("name"),
        position_m=(x, y),
        yaw_rad=reader.number("yaw_rad", 0.0),
        takes=reader.flag("takes"),
        posture=cast(Posture, reader.word("posture", POSTURES)) if "posture" in reader.data else "standing",
        gesture=reader.word("gesture", GESTURES) if "gesture" in reader.data else None,
        clothes=reader.texts("clothes"),
        way_m=reader.points("way_m"),
        speed_m_s=reader.number("speed_m_s", usual.speed_m_s),
        starts_s=reader.number("starts_s", usual.starts_s),
    )


def _region(reader: SceneTable) -> Region:
    reader.only(("name", "position_m", "size_m", "yaw_rad"))
    x, y = reader.numbers("position_m", 2)
    along, across = reader.numbers("size_m", 2)
    return Region(reader.text("name"), (x, y), (along, across), reader.number("yaw_rad", 0.0))


def _item(reader: SceneTable, pieces: tuple[Furniture, ...]) -> SceneItem:
    kind = reader.text("kind")
    solid = _solid(reader, kind)
    shape, shape_keys = _shape(reader, solid)
    hollow = ("wall_m",) if solid in HOLLOW_KINDS else ()
    reader.only((*_ITEM_KEYS, *shape_keys, *hollow))
    wall_m = reader.number("wall_m") if "wall_m" in reader.data else None
    return SceneItem(
        name=reader.text("name"),
        kind=kind,
        color=reader.text("color") if "color" in reader.data else None,
        shape=shape,
        mass_kg=reader.number("mass_kg", usual_mass_kg(solid, shape, wall_m)),
        friction=reader.number("friction", USUAL_FRICTION),
        world_T_object=_place(reader, shape, pieces),
        wall_m=wall_m,
        names=reader.texts("names"),
        categories=reader.texts("categories"),
    )


_ITEM_KEYS = (
    *("name", "kind", "names", "categories", "shape", "color"),
    *("mass_kg", "friction", "on", "board", "position_m", "yaw_rad"),
)
_SHAPED_LIKE = {"cylinder": "can", "box": "box", "ball": "ball", "bowl": "bowl"}
"""What ``shape`` may say, and the usual kind whose keys and weight it has."""


def _solid(reader: SceneTable, kind: str) -> str:
    """The usual kind that an object is shaped like: its own, what ``shape`` says, or what its sizes tell.

    A kind that is spelled nearly like a usual one is taken for a slip of the pen, unless ``shape`` is said.
    """
    if "shape" in reader.data:
        return _SHAPED_LIKE[reader.word("shape", _SHAPED_LIKE)]
    if kind in OBJECT_KINDS:
        return kind
    if near := difflib.get_close_matches(kind, OBJECT_KINDS, n=1, cutoff=_A_SLIP):
        raise reader.fail(
            "kind", f'unknown kind {kind!r}; the nearest is {near[0]!r}, or say shape = "cylinder"'
        )
    if "size_m" in reader.data:
        return "box"
    if "radius_m" in reader.data:
        return "can" if "height_m" in reader.data else "ball"
    reason = "say size_m = [x, y, z] of a box, radius_m and height_m of a cylinder, or radius_m of a ball"
    raise reader.fail("kind", f"{kind!r} is none of the usual kinds, {', '.join(OBJECT_KINDS)}: {reason}")


_A_SLIP = 0.8
"""Likeness of two words of which one is the other misspelled."""


def _shape(reader: SceneTable, kind: str) -> tuple[Shape, tuple[str, ...]]:
    if kind == "ball":
        return Ball(reader.number("radius_m")), ("radius_m",)
    if kind in CYLINDER_KINDS:
        return Cylinder(reader.number("radius_m"), reader.number("height_m")), ("radius_m", "height_m")
    x, y, z = reader.numbers("size_m", 3)
    return Box((x, y, z)), ("size_m",)


# An object may reach over an edge, with its centre this share of its base's half-width inside.
STANDING_SHARE = 0.3


def _place(reader: SceneTable, shape: Shape, pieces: tuple[Furniture, ...]) -> Transform:
    """``world_T_object`` of an object on furniture, or free with the position of its centre."""
    turn = poses.rotation_z(reader.number("yaw_rad", 0.0))
    if "on" not in reader.data:
        if "board" in reader.data:
            raise reader.fail("board", 'needs the shelf: write on = "..." as well')
        if "position_m" not in reader.data:
            named = f', or on = "{pieces[0].name}" to stand on that' if pieces else ""
            raise reader.fail("position_m", f"is missing: say where its centre is, [x, y, z]{named}")
        return poses.transform(turn, reader.numbers("position_m", 3))
    name = reader.word("on", [piece.name for piece in pieces]) if pieces else reader.text("on")
    carrier = next((piece for piece in pieces if piece.name == name), None)
    if carrier is None:
        raise reader.fail("on", f"there is no furniture {name!r}")
    x, y = reader.numbers("position_m", 2) if "position_m" in reader.data else (0.0, 0.0)
    depth, width, _ = carrier.size_m
    reach_x, reach_y = _base_reach(shape, turn)
    reach_x, reach_y = STANDING_SHARE * reach_x, STANDING_SHARE * reach_y
    if abs(x) + reach_x > 0.5 * depth + 1e-9 or abs(y) + reach_y > 0.5 * width + 1e-9:
        room = f"{depth:g} x {width:g} m, the origin of position_m in its centre"
        raise reader.fail("position_m", f"would tip off the edge of {name!r} ({room})")
    height = _board_m(reader, carrier) + 0.5 * shape.height_m
    return furniture.floor_pose(carrier) @ poses.transform(turn, (x, y, height))


def _board_m(reader: SceneTable, carrier: Furniture) -> float:
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
