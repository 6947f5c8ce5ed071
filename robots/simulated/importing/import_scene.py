"""Importing a foreign scene: a scene file of ours, its objects beside it, and a file of every guess."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from robots.errors import CannotImportError, SceneError
from robots.scenes.meshes.sidecar import toml_text
from robots.scenes.scene_file import read_scene
from robots.simulated.importing.bodies import read_foreign
from robots.simulated.importing.inventory import FoundPiece, Inventory, inventory_of
from robots.simulated.importing.openings import Opening
from robots.simulated.importing.our_furniture import OurPiece, our_piece
from robots.simulated.importing.placed_objects import Placed, placed_objects
from robots.simulated.importing.regions import regions_of
from robots.simulated.importing.standing_place import starts_before

_TOPS = ("counter", "shelf", "table")
_ROOM_M = 0.15
"""About the middles of objects that stand on the floor."""
_AT_FAULT = re.compile(r"^(object|furniture)\[(\d+)\]|^(robot_start)")


@dataclass(slots=True)
class Written:
    """What an import wrote.

    Attributes:
        scene, guesses: The two files.
        objects, furniture: What is in the scene, by name.
        told: What could not be put into it, or not as it was, with the reason.
        asked: What nobody but a person can tell, as questions; they stand in the file of guesses, too.
    """

    scene: Path
    guesses: Path
    objects: list[str] = field(default_factory=list)
    furniture: list[str] = field(default_factory=list)
    told: list[str] = field(default_factory=list)
    asked: list[str] = field(default_factory=list)


def import_scene(file: Path, into: Path | None = None) -> Written:
    """Make a scene file of an MJCF or URDF file.

    Args:
        file: The foreign scene.
        into: The scene file that is written; beside the foreign one when left out.

    Raises:
        CannotImportError: Nothing can be made of it, or a file cannot be written.
    """
    found = inventory_of(read_foreign(file))
    scene_file = into or file.with_suffix(".toml")
    written = Written(scene_file, scene_file.with_suffix(".guesses.toml"))
    guesses: list[str] = [f"# What was guessed when {file.name} was imported."]
    pieces = _furniture(found, written, guesses)
    try:
        scene_file.parent.mkdir(parents=True, exist_ok=True)
        objects = placed_objects(found, {name: ours.values for name, (_, ours) in pieces.items()}, scene_file)
        guesses += [_block("object", one.guess) for one in objects]
        text = _accepted(file, pieces, objects, written)
        for name, reason in found.left_out:
            written.told.append(f"{name}: left out, {reason}")
        guesses += [_block("left_out", {"body": name, "why": why}) for name, why in found.left_out]
        guesses += [_block("not_here", {"what": told}) for told in written.told]
        guesses += [_block("mended", {"what": mend}) for mend in found.foreign.mends]
        scene_file.write_text(text, "utf-8")
        written.guesses.write_text("\n".join(guesses) + "\n", "utf-8")
    except OSError as refused:
        raise CannotImportError(f"{scene_file}: cannot be written: {refused.strerror}") from refused
    return written


def _block(kind: str, values: Mapping[str, Any]) -> str:
    return "\n".join(["", f"[[{kind}]]", *(f"{key} = {toml_text(value)}" for key, value in values.items())])


def _accepted(
    file: Path, pieces: dict[str, tuple[FoundPiece, OurPiece]], objects: list[Placed], written: Written
) -> str:
    """The scene file's text: what cannot stand in a world of ours where it is, is left out and told.

    Raises:
        CannotImportError: The scene is none, whatever is left out of it.
    """
    head = f"# Made of {file.name}; what was guessed is in {written.guesses.name}."
    furniture = {name: ours.values for name, (_, ours) in pieces.items()}
    things = []
    for one in objects:
        if one.values is None:
            written.told.append(f"{one.name}: {one.why_not}")
        else:
            things.append((one.name, one.values))
    tops = [values for values in furniture.values() if values["kind"] in _TOPS] or list(furniture.values())
    starts = starts_before(tops or [_about(things)] if things or tops else [])
    start = next(starts)
    while True:
        text = "\n".join([head, *_start(start), *_tables("furniture", list(furniture.items())),
                          *_tables("object", things)]) + "\n"  # fmt: skip
        try:
            read_scene(text, str(written.scene), file.stem)
            break
        except SceneError as refused:
            fault = _AT_FAULT.match(refused.key)
            if fault is not None and "the robot's start" in refused.reason:
                fault = _AT_FAULT.match("robot_start")
            if fault is None:
                raise CannotImportError(f"{file}: {refused}") from refused
            if fault[3]:
                start = next(starts, None)
                if start is None:
                    raise CannotImportError(f"{file}: nowhere to stand: {refused.reason}") from refused
                continue
            name = _without(fault[1], int(fault[2]), furniture, things)
            written.told.append(f"{name}: left out, {refused.reason}")
    written.objects += [name for name, _ in things]
    written.furniture += list(furniture)
    return text


def _about(things: list[tuple[str, Any]]) -> dict[str, Any]:
    """Of objects on the floor what they take up of it, as if it were a piece of furniture."""
    places = np.array([values["position_m"][:2] for _, values in things])
    low, high = places.min(axis=0) - _ROOM_M, places.max(axis=0) + _ROOM_M
    return {"position_m": 0.5 * (low + high), "size_m": high - low, "yaw_rad": 0.0}


def _without(group: str, index: int, furniture: dict[str, Any], things: list[tuple[str, Any]]) -> str:
    """Take the thing out that a scene file cannot have; its name."""
    if group == "object":
        return things.pop(index)[0]
    name = list(furniture)[index]
    del furniture[name]
    for k in [k for k, (_, values) in enumerate(things) if values.get("on") == name][::-1]:
        things[k][1]["on"] = None
    return name


def _start(start: tuple[float, float, float] | None) -> list[str]:
    if start is None:
        return []
    x, y, yaw = start
    return ["", f"robot_start = {{ x_m = {x:.4f}, y_m = {y:.4f}, yaw_rad = {yaw:.4f} }}"]


def _tables(group: str, named: list[tuple[str, dict[str, Any]]]) -> list[str]:
    lines: list[str] = []
    for name, values in named:
        lines += ["", *_table(f"[[{group}]]", group, {"name": name, **values})]
    return lines


def _table(head: str, path: str, values: Mapping[str, Any]) -> list[str]:
    """A table and those in it; its own keys come first."""
    lines = [head]
    plain = {key: value for key, value in values.items() if not (_several(value) or isinstance(value, dict))}
    lines += [f"{key} = {toml_text(value)}" for key, value in plain.items()]
    for key, value in values.items():
        if isinstance(value, dict):
            lines += _table(f"[{path}.{key}]", f"{path}.{key}", value)
        for one in value if _several(value) else ():
            lines += _table(f"[[{path}.{key}]]", f"{path}.{key}", one)
    return lines


def _several(value: Any) -> bool:
    return isinstance(value, list) and bool(value) and isinstance(value[0], dict)


def _furniture(
    found: Inventory, written: Written, guesses: list[str]
) -> dict[str, tuple[FoundPiece, OurPiece]]:
    """What the furniture is here, by name, and what it may be asked about."""
    pieces: dict[str, tuple[FoundPiece, OurPiece]] = {}
    ask: Callable[[str], None] = written.asked.append
    for piece in found.pieces:
        name, ours = free_name(piece.label, pieces), our_piece(found.foreign, piece, found.ground_m)
        size = piece.high - piece.low
        said: dict[str, Any] = {
            "body": found.foreign.name(piece.body),
            "label": name,
            "size_m": [round(float(value), 4) for value in size],
            "top_m": round(float(piece.high[2]) - found.ground_m, 4),
            "yaw_rad": round(piece.yaw_rad, 4),
            "taken_for": ours.values["kind"],
        }
        if piece.is_nameless:
            said["ask"] = "its name tells nothing: what is it called?"
            ask(f"{name}: {said['ask']}")
        guesses.append(_block("furniture", said))
        for opening in piece.openings:
            told = _told_of(found, opening, name)
            if "ask" in told:
                ask(f"{told['body']} of the {name}: {told['ask']}")
            guesses.append(_block("opening", told))
        for region in regions_of(found.foreign, piece):
            told = {"said": region.said, "of": name, "name": region.name}
            guesses.append(_block("region", {**told, "is_here": "region" in ours.values}))
        pieces[name] = piece, ours
        written.told += [f"{name}: {told}" for told in ours.told]
    return pieces


def _told_of(found: Inventory, opening: Opening, of: str) -> dict[str, Any]:
    told: dict[str, Any] = {
        "body": found.foreign.name(opening.body),
        "of": of,
        "kind": opening.kind,
        "range": round(opening.range, 4),
        "outwards": [round(float(value), 4) for value in opening.outwards],
    }
    handle = opening.handle
    if handle is not None:
        told |= {
            "handle_m": [round(float(value), 4) for value in handle.middle],
            "handle_along": [round(float(value), 4) for value in handle.along],
            "handle_length_m": round(handle.length_m, 4),
        }
    elif opening.kind in ("drawer", "door", "lid", "sliding door"):
        told["ask"] = "nothing protrudes where it opens: where is it taken hold of?"
    return told


def free_name(label: str, taken: Any) -> str:
    """A label, numbered from 2 on where it is taken."""
    name, number = label, 1
    while name in taken:
        number += 1
        name = f"{label} {number}"
    return name
