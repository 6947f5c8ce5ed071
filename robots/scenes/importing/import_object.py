"""Importing an object: from a mesh to its model, and to the file that says what was guessed on the way."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from kinematics.arrays import Array
from kinematics.geometry import poses
from kinematics.geometry.convex_parts import ConvexParts
from robots.errors import CannotImportError
from robots.scenes.importing.convex import convex_parts, middle_of, surface_of, volume
from robots.scenes.importing.extra import library
from robots.scenes.importing.mesh_file import Mesh, read_mesh
from robots.scenes.importing.outline import fitted, turn_of
from robots.scenes.importing.resting import guessed_up, rests_of
from robots.scenes.importing.seen_color import said_color, share_of_seen
from robots.scenes.meshes.object_model import ObjectModel, model_file, model_key, write_model
from robots.scenes.meshes.sidecar import Guesses, SidecarDraft, read_sidecar, sidecar_file, sidecar_text
from robots.scenes.meshes.up_axis import UP_AXES, Up, name_of, upright

DENSITY_KG_M3 = 600.0
LIGHTEST_KG, HEAVIEST_KG = 0.02, 5.0
_ROUNDED = 1e-6
_UNITS = ((1.0, "metres"), (0.01, "centimetres"), (0.001, "millimetres"))
LARGEST_M = 0.45
"""No thing that is taken in a hand is longer: a file in which it were has other units."""


@dataclass(frozen=True, slots=True)
class Imported:
    """What came of a mesh.

    Attributes:
        model: The object.
        guesses: What was taken, and why.
        file, sidecar: Where both were written.
    """

    model: ObjectModel
    guesses: Guesses
    file: Path
    sidecar: Path


def import_object(mesh_file: Path, said: Mapping[str, Any] | None = None) -> Imported:
    """Make an object of a mesh, and write both files beside it.

    Args:
        mesh_file: OBJ, STL, GLB or another that is known.
        said: What is known of it, by the sidecar's keys: it is neither guessed nor taken from a sidecar.

    Raises:
        CannotImportError: Nothing can be made of it, the extra is missing, or the folder cannot be written.
        SceneError: There is a sidecar already that cannot be read.
    """
    mesh = read_mesh(mesh_file)
    beside = sidecar_file(mesh_file)
    known = _known(read_sidecar(beside, SidecarDraft) if beside.exists() else None, said or {})
    guesses = _guessed(mesh, mesh_file, known)
    model = made(mesh, guesses)
    guesses = replace(guesses, measured=_measured(model))
    file = model_file(mesh_file)
    try:
        write_model(model, file)
        beside.write_text(sidecar_text(mesh_file.name, guesses), "utf-8")
    except OSError as refused:
        raise CannotImportError(f"{file}: cannot be written: {refused.strerror}") from refused
    return Imported(model, guesses, file, beside)


def _known(sidecar: SidecarDraft | None, said: Mapping[str, Any]) -> dict[str, Any]:
    """What is not to be guessed: a sidecar's values, but for those that are said anew."""
    kept = {} if sidecar is None else {key: getattr(sidecar, key) for key in sidecar.model_fields_set}
    kept.pop("measured", None)
    return {**kept, **said}


def _guessed(mesh: Mesh, file: Path, known: dict[str, Any]) -> Guesses:
    """All values, the guessed ones with their reasons."""
    values: dict[str, Any] = {}
    reasons: dict[str, str] = {}

    def take(key: str, value: object, reason: str) -> None:
        values[key] = known.get(key, value)
        if _same(values[key], value):
            reasons[key] = reason

    take("scale", *_scale(mesh))
    scale = float(values["scale"])
    corners = scale * np.asarray(library("trimesh").convex.convex_hull(mesh.vertices).vertices)
    middle = scale * _middle(mesh)
    up, why = guessed_up(corners, middle, file.suffix.lower())
    known = {**known, **({"up": name_of(_direction(known["up"]))} if "up" in known else {})}
    take("up", name_of(up), why)
    direction = _direction(values["up"])
    turn = turn_of(corners @ upright(direction).T)
    take("turn_rad", turn, "its sides are along x and y then" if turn else "its sides are so already")
    take("label", label_of(file.stem), "the file's name")
    values |= {key: known[key] for key in ("names", "categories", "color") if key in known}
    if "color" not in known and mesh.surface is not None and (color := said_color(mesh.surface)) is not None:
        take("color", color[0], share_of_seen(color[1]))
    hull_m3 = volume(corners)
    mass_kg = min(max(DENSITY_KG_M3 * hull_m3, LIGHTEST_KG), HEAVIEST_KG)
    take("mass_kg", round(mass_kg, 3), f"{DENSITY_KG_M3:g} kg/m3 of its hull, {1000 * hull_m3:.2f} litres")
    take("friction", 0.6, "usual")
    return Guesses(values, reasons)


def _same(value: object, guess: object) -> bool:
    """Whether what is said is what would be guessed, as a file rounds it."""
    if isinstance(value, float | int) and isinstance(guess, float | int):
        return abs(value - guess) <= _ROUNDED
    return value == guess


def _direction(value: Any) -> Up:
    if isinstance(value, str):
        return UP_AXES[value]
    x, y, z = value
    return float(x), float(y), float(z)


def _scale(mesh: Mesh) -> tuple[float, str]:
    """Metres that a unit is, and why."""
    longest = float(np.ptp(mesh.vertices, axis=0).max())
    scale, unit = next((each for each in _UNITS if longest * each[0] <= LARGEST_M), _UNITS[-1])
    return scale, f"its units are {unit}: it is {longest * scale:.3g} m long"


def _middle(mesh: Mesh) -> Array:
    """Centre of mass, of even density where it is closed."""
    found = library("trimesh").Trimesh(mesh.vertices, mesh.faces, process=True)
    return np.asarray(found.center_mass if found.is_watertight else found.convex_hull.center_mass)


def label_of(stem: str) -> str:
    """What people call it, from the name of a file: "soup_can_01" is a "soup can"."""
    words = re.sub(r"(?<=[a-z])(?=[A-Z])", " ", stem)
    words = re.sub(r"[_\-.]+", " ", words)
    return re.sub(r"(\s*\d+)+$", "", words).strip().lower() or stem


def made(mesh: Mesh, guesses: Guesses) -> ObjectModel:
    """The object: placed, cut into parts, and outlined."""
    values = guesses.values
    up, turn = _direction(values["up"]), float(values["turn_rad"])
    rotation = poses.rotation_z(turn) @ upright(up)
    vertices = float(values["scale"]) * mesh.vertices @ rotation.T
    hulls = convex_parts(vertices, mesh.faces)
    fit = fitted(np.concatenate(hulls))
    vertices = vertices - fit.centre
    hulls = [hull - fit.centre for hull in hulls]
    corners = np.concatenate(hulls)
    surface, normals = surface_of(hulls)
    parts = ConvexParts(
        key=model_key(mesh.digest, float(values["scale"]), up, turn),
        corners=corners,
        ends=tuple(np.cumsum([len(hull) for hull in hulls]).tolist()),
        surface=surface,
        normals=normals,
        rests=rests_of(corners, middle_of(hulls)).up,
        outline_error_m=fit.error_m,
    )
    return ObjectModel(
        replace(fit.outline, parts=parts), vertices, mesh.faces, mesh.on_picture, mesh.picture, mesh.color
    )


def _measured(model: ObjectModel) -> dict[str, object]:
    """What a person wants to know of it."""
    outline, parts = model.outline, model.parts
    size = np.ptp(parts.corners, axis=0)
    return {
        "size_m": [round(float(value), 4) for value in size],
        "outline": type(outline).__name__.lower(),
        "outline_error_m": round(parts.outline_error_m, 4),
        "parts": len(parts.ends),
        "ways_to_rest": len(parts.rests),
    }
