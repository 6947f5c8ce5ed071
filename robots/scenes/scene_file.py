"""Read scenes from TOML files; ``validate`` is the judge of what they hold."""

from __future__ import annotations

import difflib
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Ball, Box, Cylinder, Shape
from robots.errors import SceneError
from robots.outside import known_scenes, scene_files
from robots.scenes import furniture
from robots.scenes.furniture import board_tops_m
from robots.scenes.meshes.mesh_thing import mesh_thing
from robots.scenes.picture_file import picture_file
from robots.scenes.scene_description import (
    Furniture,
    SceneDescription,
    SceneItem,
)
from robots.scenes.scene_document import BowlTable, BoxTable, MeshTable, ObjectTable, SceneDocument
from robots.scenes.scene_rules import validate
from robots.scenes.scene_words import nearest_word
from robots.scenes.usual_properties import usual_mass_kg
from robots.strict_table import read_table, unknown_word
from robots.toml_text import TomlTextError, read_toml

_LARGEST_FILE = 1_000_000
"""Bytes; a scene that somebody writes by hand is a thousand times smaller."""

MOST_THINGS = 500
"""Furniture, objects, people and places: each is held against each of the others."""


def load_scene(name_or_path: str) -> SceneDescription:
    """Read a scene by its name, or from a file.

    Args:
        name_or_path: One of ``known_scenes()``, or the path of a TOML file.

    Raises:
        SceneError: There is no such scene, or it cannot be a world: file, key and reason.
    """
    known = scene_files()
    if name_or_path in known:
        text = known[name_or_path].read_text("utf-8")
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
    count = sum(len(found) for found in data.values() if isinstance(found, list))
    if count > MOST_THINGS:
        raise SceneError(source, "file", f"has {count} things; a scene holds at most {MOST_THINGS}")
    document = read_table(SceneDocument, data, partial(SceneError, source))
    pieces = tuple(table.value() for table in document.furniture)
    scene = SceneDescription(
        name=name,
        robot_start=document.robot_start,
        perception=document.perception,
        furniture=pieces,
        objects=tuple(_item(table, pieces, source, i) for i, table in enumerate(document.object)),
        people=tuple(document.person),
        places=tuple(document.place),
        light=document.light.value(),
        cameras=tuple(document.camera),
    )
    validate(scene, source)
    return scene


def _is_file(path: Path) -> bool:
    try:
        return path.is_file()
    except (OSError, ValueError):
        return False


def _near_scene(stem: str) -> str:
    close = difflib.get_close_matches(stem, known_scenes(), n=1)
    return f"; did you mean the scene {close[0]!r}?" if close else ""


def _item(table: ObjectTable, pieces: tuple[Furniture, ...], source: str, index: int) -> SceneItem:
    if isinstance(table, MeshTable):
        return _mesh_item(table, pieces, source, index)
    shape = table.shape()
    wall_m = table.wall_m if isinstance(table, BowlTable | BoxTable) else None
    usual_kg = usual_mass_kg(table.weighs_as, shape, wall_m) if table.mass_kg is None else table.mass_kg

    def fail(key: str, reason: str) -> SceneError:
        return SceneError(source, f"object[{index}].{key}", reason)

    return SceneItem(
        name=table.name,
        kind=table.kind,
        color=table.color,
        shape=shape,
        mass_kg=usual_kg,
        friction=table.friction,
        world_T_object=_place(table, shape, pieces, fail),
        wall_m=wall_m,
        names=table.names,
        categories=table.categories,
        texture=None if table.texture is None else picture_file(table.texture, shape, source, fail),
    )


def _mesh_item(table: MeshTable, pieces: tuple[Furniture, ...], source: str, index: int) -> SceneItem:
    def fail(key: str, reason: str) -> SceneError:
        return SceneError(source, f"object[{index}].{key}", reason)

    thing = mesh_thing(table, source, fail)
    return SceneItem(
        name=thing.name,
        kind=thing.kind,
        color=thing.color,
        shape=thing.model.outline,
        mass_kg=thing.mass_kg,
        friction=thing.friction,
        world_T_object=_place(table, thing.model.outline, pieces, fail),
        names=thing.names,
        categories=thing.categories,
        mesh=thing.file,
        model=thing.model,
    )


# An object may reach over an edge, with its centre this share of its base's half-width inside.
STANDING_SHARE = 0.3


def _place(
    table: ObjectTable, shape: Shape, pieces: tuple[Furniture, ...], fail: Callable[[str, str], SceneError]
) -> Transform:
    """``world_T_object`` of an object on furniture, or free with the position of its centre."""
    turn = poses.rotation_z(table.yaw_rad)
    if table.on is None:
        if table.board is not None:
            raise fail("board", 'needs the shelf: write on = "..." as well')
        if table.position_m is None:
            named = f', or on = "{pieces[0].name}" to stand on that' if pieces else ""
            raise fail("position_m", f"is missing: say where its centre is, [x, y, z]{named}")
        return poses.transform(turn, table.position_m)
    carrier = next((piece for piece in pieces if piece.name == table.on), None)
    if carrier is None and not pieces:
        raise fail("on", f"there is no furniture {table.on!r}")
    if carrier is None:
        raise fail("on", unknown_word("on", table.on, [piece.name for piece in pieces]))
    x, y = table.position_m or (0.0, 0.0)
    depth, width, _ = carrier.size_m
    reach_x, reach_y = _base_reach(shape, turn)
    reach_x, reach_y = STANDING_SHARE * reach_x, STANDING_SHARE * reach_y
    if abs(x) + reach_x > 0.5 * depth + 1e-9 or abs(y) + reach_y > 0.5 * width + 1e-9:
        room = f"{depth:g} x {width:g} m, the origin of position_m in its centre"
        raise fail("position_m", f"would tip off the edge of {carrier.name!r} ({room})")
    tops = board_tops_m(carrier)
    if table.board is not None and (type(table.board) is not int or not 0 <= table.board < len(tops)):
        boards = f"from 0 to {len(tops) - 1}, the boards of {carrier.name!r}"
        raise fail("board", f"must be a whole number {boards}, not {table.board!r}")
    top_m = tops[-1 if table.board is None else table.board]
    return furniture.floor_pose(carrier) @ poses.transform(turn, (x, y, top_m + 0.5 * shape.height_m))


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
