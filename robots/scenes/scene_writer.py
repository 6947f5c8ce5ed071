"""Write scenes as TOML documents."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import MISSING, fields
from typing import Any

from kinematics.geometry import poses
from kinematics.geometry.shapes import Ball, Box, Cylinder, Shape
from robots.scenes.fixed_camera import FixedCamera
from robots.scenes.fixture import Control
from robots.scenes.light import Light
from robots.scenes.opening import Opening
from robots.scenes.scene_description import Furniture, Person, SceneDescription, SceneItem

_OF_EVERY_PART = (
    "mass_kg",
    "locked",
    "handle_height_m",
    "handle_radius_m",
    "handle_length_m",
    "handle_friction",
)


def dump(scene: SceneDescription) -> str:
    """Write a scene as the TOML document that ``scene_file.read_scene`` reads back.

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
    if scene.light != Light():
        lines += ["", "[light]", *_pairs(kind=scene.light.kind)]
        for change in scene.light.changes:
            lines += ["[[light.change]]", *_pairs(at_s=change.at_s, kind=change.kind)]
    for piece in scene.furniture:
        lines += ["", "[[furniture]]", *_pairs(name=piece.name, kind=piece.kind, size_m=piece.size_m)]
        lines += _called(piece)
        lines += _pairs(position_m=piece.position_m, yaw_rad=piece.yaw_rad, friction=piece.friction)
        lines += _pairs(**_part_values(piece))
        if piece.foot_m != 0.0:
            lines += _pairs(foot_m=piece.foot_m)
        for box in piece.boxes:
            lines += ["[[furniture.box]]", *_pairs(size_m=box.size_m, position_m=box.position_m)]
        for control in piece.controls:
            said = {item.name: getattr(control, item.name) for item in fields(Control)}
            lines += ["[[furniture.control]]", *_pairs(**said)]
        for opening in piece.openings:
            lines += ["[[furniture.opening]]", *_opening_lines(opening)]
        for part in piece.regions:
            said = {"name": part.name, "size_m": part.size_m, "position_m": part.position_m}
            lines += ["[[furniture.region]]", *_pairs(**said)]
    for person in scene.people:
        lines += ["", "[[person]]", *_pairs(name=person.name, position_m=person.position_m)]
        lines += _pairs(yaw_rad=person.yaw_rad, takes=person.takes)
        usual = Person(person.name, person.position_m, person.yaw_rad, person.takes)
        said = {item.name: getattr(person, item.name) for item in fields(Person)}
        lines += _pairs(**{key: value for key, value in said.items() if value != getattr(usual, key)})
    for region in scene.places:
        lines += ["", "[[place]]", *_pairs(name=region.name, position_m=region.position_m)]
        lines += _pairs(size_m=region.size_m, yaw_rad=region.yaw_rad)
    for camera in scene.cameras:
        lines += ["", "[[camera]]", *_camera_lines(camera)]
    for item in scene.objects:
        if item.world_T_object[2, 2] < 1.0 - 1e-12:
            raise ValueError(f"{item.name!r} is tilted; a scene file holds upright objects only")
        color = {} if item.color is None else {"color": item.color}
        lines += ["", "[[object]]", *_pairs(name=item.name, kind=item.kind, **color)]
        lines += _called(item)
        shape = _shape_keys(item.shape) if item.mesh is None else {"mesh": item.mesh}
        lines += _pairs(**shape, mass_kg=item.mass_kg, friction=item.friction)
        if item.wall_m is not None:
            lines += _pairs(wall_m=item.wall_m)
        if item.texture is not None:
            lines += _pairs(texture=item.texture)
        yaw = poses.yaw_of(item.world_T_object[:3, :3])
        lines += _pairs(position_m=tuple(map(float, item.world_T_object[:3, 3])), yaw_rad=yaw)
    return "\n".join(lines) + "\n"


def _called(thing: SceneItem | Furniture) -> list[str]:
    """What it is called besides its own name and its kind."""
    called = {"names": thing.names, "categories": thing.categories}
    return _pairs(**{key: words for key, words in called.items() if words})


def _camera_lines(camera: FixedCamera) -> list[str]:
    """What is said of a camera: what it is like where it is not a usual one."""
    said = {
        item.name: getattr(camera, item.name)
        for item in fields(FixedCamera)
        if item.name != "errors" and (item.default is MISSING or getattr(camera, item.name) != item.default)
    }
    wrong = {
        item.name: getattr(camera.errors, item.name)
        for item in fields(camera.errors)
        if getattr(camera.errors, item.name) != item.default
    }
    lines = _numbers(said)
    return [*lines, "[camera.errors]", *_numbers(wrong)] if wrong else lines


def _opening_lines(opening: Opening) -> list[str]:
    """What is said of a door or drawer of a fixture."""
    told = {"opening": "open"}
    said = {
        told.get(item.name, item.name): getattr(opening, item.name)
        for item in fields(Opening)
        if item.name not in ("boxes", "bar") and getattr(opening, item.name) is not None
    }
    lines = _pairs(**said)
    for box in opening.boxes:
        lines += ["[[furniture.opening.box]]", *_pairs(size_m=box.size_m, position_m=box.position_m)]
    if (bar := opening.bar) is not None:
        lines += ["[furniture.opening.bar]", *_pairs(**{x.name: getattr(bar, x.name) for x in fields(bar)})]
    return lines


def _numbers(values: Mapping[str, Any]) -> list[str]:
    """The same as ``_pairs``, of values among which pixels are whole numbers."""
    return [
        f"{key} = {value}" if isinstance(value, int) else f"{key} = {_toml(value)}"
        for key, value in values.items()
    ]


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


def _part_values(piece: Furniture) -> dict[str, Any]:
    """What is said of a door or drawer."""
    part = piece.opens
    if part is None:
        return {}
    values: dict[str, Any] = {key: getattr(part, key) for key in _OF_EVERY_PART}
    if part.hinge is None:
        return {**values, "friction_n": part.friction, "open_m": part.opening}
    return {
        **values,
        "hinge": part.hinge,
        "friction_nm": part.friction,
        "seal_n": part.seal_n,
        "open_rad": part.opening,
        "handle_inset_m": part.handle_inset_m,
    }
