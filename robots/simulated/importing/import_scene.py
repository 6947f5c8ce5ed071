"""Importing a foreign scene: a scene file of ours, its objects beside it, and a file of every guess."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from kinematics.geometry import poses
from robots.errors import CannotImportError
from robots.scenes.meshes.object_model import model_file, write_model
from robots.scenes.meshes.sidecar import Guesses, sidecar_file, sidecar_text, toml_text
from robots.simulated.importing.bodies import read_foreign
from robots.simulated.importing.foreign_object import foreign_object
from robots.simulated.importing.inventory import FoundPiece, Inventory, inventory_of
from robots.simulated.importing.openings import Opening
from robots.simulated.importing.our_furniture import OurPiece, our_piece

_NEAR_TOP_M = 0.06
_LIGHTEST_KG = 0.02
_BEFORE_M = 0.42
"""From the edge of a table to who stands before it."""
_TOPS = ("counter", "shelf", "table")


@dataclass(frozen=True, slots=True)
class Placed:
    """A foreign piece, and what it is here."""

    piece: FoundPiece
    ours: OurPiece


@dataclass(slots=True)
class Written:
    """What an import wrote.

    Attributes:
        scene, guesses: The two files.
        objects, furniture: What is in the scene, by name.
        told: What could not be put into it, with the reason.
    """

    scene: Path
    guesses: Path
    objects: list[str] = field(default_factory=list)
    furniture: list[str] = field(default_factory=list)
    told: list[str] = field(default_factory=list)


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
    lines: list[str] = [f"# Made of {file.name}; what was guessed is in {written.guesses.name}."]
    guesses: list[str] = [f"# What was guessed when {file.name} was imported."]
    placed = _furniture(found, written, guesses)
    lines += [*_start(placed), *(line for name, one in placed.items() for line in _lines_of(name, one.ours))]
    tables = {name: one.piece for name, one in placed.items() if one.ours.values["kind"] in _TOPS}
    try:
        scene_file.parent.mkdir(parents=True, exist_ok=True)
        lines += _objects(found, tables, written, guesses)
        for name, reason in found.left_out:
            written.told.append(f"{name}: left out, {reason}")
        guesses += [_block("left_out", {"body": name, "why": why}) for name, why in found.left_out]
        guesses += [_block("mended", {"what": mend}) for mend in found.foreign.mends]
        scene_file.write_text("\n".join(lines) + "\n", "utf-8")
        written.guesses.write_text("\n".join(guesses) + "\n", "utf-8")
    except OSError as refused:
        raise CannotImportError(f"{scene_file}: cannot be written: {refused.strerror}") from refused
    return written


def _block(kind: str, values: dict[str, Any]) -> str:
    return "\n".join(["", f"[[{kind}]]", *(f"{key} = {toml_text(value)}" for key, value in values.items())])


def _furniture(found: Inventory, written: Written, guesses: list[str]) -> dict[str, Placed]:
    """What of the furniture is some of ours, by name; the rest is told."""
    placed: dict[str, Placed] = {}
    for piece in found.pieces:
        name, ours = _free(piece.label, placed), our_piece(found.foreign, piece)
        size = piece.high - piece.low
        said = {
            "body": found.foreign.name(piece.body),
            "label": name,
            "size_m": [round(float(value), 4) for value in size],
            "top_m": round(float(piece.high[2]), 4),
            "yaw_rad": round(piece.yaw_rad, 4),
        }
        kind = "none of ours" if isinstance(ours, str) else ours.values["kind"]
        guesses.append(_block("furniture", {**said, "taken_for": kind}))
        guesses += [_block("opening", _told_of(found, opening, name)) for opening in piece.openings]
        if isinstance(ours, str):
            written.told.append(f"{name}: left out, {ours}")
            continue
        placed[name] = Placed(piece, ours)
        written.furniture.append(name)
        written.told += [f"{name}: {told}" for told in ours.told]
    return placed


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
    elif opening.kind in ("drawer", "door"):
        told["ask"] = "nothing protrudes where it opens: where is it taken hold of?"
    return told


def _start(placed: Mapping[str, Placed]) -> list[str]:
    """Where the robot begins: before the largest top, looking at it."""
    tops = [one.piece for one in placed.values() if one.ours.values["kind"] in _TOPS]
    if not tops:
        return []
    piece = max(tops, key=lambda one: float(np.prod((one.high - one.low)[:2])))
    middle, yaw = 0.5 * (piece.low + piece.high), piece.yaw_rad
    away = 0.5 * float(piece.high[0] - piece.low[0]) + _BEFORE_M
    x, y, _ = poses.rotation_z(yaw) @ (middle - np.array([away, 0.0, 0.0]))
    return ["", f"robot_start = {{ x_m = {x:.4f}, y_m = {y:.4f}, yaw_rad = {yaw:.4f} }}"]


def _lines_of(name: str, ours: OurPiece) -> list[str]:
    values = {"name": name, **ours.values}
    return ["", "[[furniture]]", *(f"{key} = {toml_text(value)}" for key, value in values.items())]


def _objects(
    found: Inventory, tables: dict[str, FoundPiece], written: Written, guesses: list[str]
) -> list[str]:
    folder = written.scene.with_suffix("").name + "_objects"
    lines: list[str] = []
    taken: set[str] = set(written.furniture)
    for thing in found.objects:
        made = foreign_object(found.foreign, thing.bodies)
        name = _free(thing.label, taken)
        taken.add(name)
        place, outline = made.world_T_object, made.model.outline
        bottom = float(place[2, 3]) - 0.5 * outline.height_m
        on = next((one for one, piece in tables.items() if _is_on(piece, place, bottom)), None)
        mass = max(thing.mass_kg, _LIGHTEST_KG)
        file = written.scene.parent / folder / name.replace(" ", "_")
        file.parent.mkdir(parents=True, exist_ok=True)
        write_model(made.model, model_file(file))
        values = {"scale": 1.0, "up": "+z", "label": thing.label, "mass_kg": mass}
        reasons = {"up": "as it stands there", "label": f"the body {found.foreign.name(thing.body)!r}"}
        if mass > thing.mass_kg:
            reasons["mass_kg"] = f"it says {thing.mass_kg:.4g}"
        measured = {"parts": len(made.model.parts.ends), "solids_left_out": made.left_out}
        sidecar_file(file).write_text(sidecar_text(file.name, Guesses(values, reasons, measured)), "utf-8")
        guesses.append(
            _block(
                "object",
                {
                    "body": found.foreign.name(thing.body),
                    "label": thing.label,
                    "on": on or "nothing",
                    "mass_kg": mass,
                    "parts": len(made.model.parts.ends),
                },
            )
        )
        if on is None:
            written.told.append(f"{name}: stands on nothing that is known, its foot at {bottom:.2f} m")
            continue
        written.objects.append(name)
        yaw = math.atan2(place[1, 0], place[0, 0])
        x, y = _on_table(tables[on], place)
        said = {"mesh": f"{folder}/{file.name}", "name": name, "on": on, "position_m": [x, y],
                "yaw_rad": yaw - tables[on].yaw_rad}  # fmt: skip
        lines += ["", "[[object]]", *(f"{key} = {toml_text(value)}" for key, value in said.items())]
    return lines


def _is_on(piece: FoundPiece, place: Any, bottom: float) -> bool:
    x, y = _on_table(piece, place)
    half = 0.5 * (piece.high - piece.low)
    return abs(x) <= half[0] and abs(y) <= half[1] and abs(bottom - float(piece.high[2])) <= _NEAR_TOP_M


def _on_table(piece: FoundPiece, place: Any) -> tuple[float, float]:
    """Where something is from the middle of a table, along its own axes."""
    middle = 0.5 * (piece.low + piece.high)
    own = poses.rotation_z(-piece.yaw_rad) @ place[:3, 3] - middle
    return float(own[0]), float(own[1])


def _free(label: str, taken: Any) -> str:
    name, number = label, 1
    while name in taken:
        number += 1
        name = f"{label} {number}"
    return name
