"""Importing an object whose maker gave it solids already: an MJCF or URDF file of one thing."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from kinematics.geometry.convex_parts import ConvexParts
from robots.errors import CannotImportError
from robots.scenes.importing.convex import middle_of, of_few_corners, volume
from robots.scenes.importing.import_object import (
    DENSITY_KG_M3,
    HEAVIEST_KG,
    LIGHTEST_KG,
    Imported,
    label_of,
)
from robots.scenes.importing.resting import guessed_up
from robots.scenes.importing.seen_color import share_of_seen
from robots.scenes.meshes.object_model import digest_of, model_file, model_key, write_model
from robots.scenes.meshes.sidecar import Guesses, SidecarDraft, read_sidecar, sidecar_file, sidecar_text
from robots.scenes.meshes.up_axis import UP_AXES, Up, name_of, upright
from robots.simulated.importing.bodies import WORLD, Foreign, read_foreign
from robots.simulated.importing.foreign_object import foreign_object, solids_of

ENDINGS = (".xml", ".urdf", ".mjcf")
_UNSAID_KG = 2e-4
"""What weighs so little for each of its bodies was made so that the simulator takes it."""


def import_foreign_object(file: Path, said: Mapping[str, Any] | None = None) -> Imported:
    """Make an object of all bodies of a file, and write both files beside it.

    Args:
        file: MJCF or URDF.
        said: What is known of it, by the sidecar's keys; its scale is the file's own.

    Raises:
        CannotImportError: Nothing can be made of it, or the folder cannot be written.
        SceneError: There is a sidecar already that cannot be read.
    """
    foreign = read_foreign(file)
    bodies = foreign.subtree(WORLD)[1:]
    if not foreign.solid_geoms(bodies):
        bodies = [WORLD]  # written to be put into a body of somebody else's
    geoms = foreign.solid_geoms(bodies)
    if not geoms:
        raise CannotImportError(f"{file}: has no solid")
    beside = sidecar_file(file)
    draft = read_sidecar(beside, SidecarDraft) if beside.exists() else SidecarDraft()
    kept = {key: getattr(draft, key) for key in draft.model_fields_set - {"measured", "scale", "turn_rad"}}
    known: dict[str, Any] = {**kept, **(said or {})}
    corners = of_few_corners(np.concatenate([foreign.corners(geom) for geom in geoms]))
    solids = [hull for geom in geoms for hull in solids_of(foreign, geom, np.eye(3))]
    guess, why = guessed_up(corners, middle_of(solids or [corners]), file.suffix)
    up: Up = _direction(known.get("up", guess))
    made = foreign_object(foreign, bodies, upright(up), model_key(digest_of(file), 1.0, up, 0.0))
    guesses: dict[str, tuple[Any, str]] = {
        "up": (name_of(guess), why),
        "label": (label_of(file.stem), "the file's name"),
        "mass_kg": _mass(foreign, made.model.parts),
        "friction": (0.6, "usual"),
    }
    values: dict[str, Any] = {"scale": 1.0}
    reasons: dict[str, str] = {}
    for key, (value, reason) in guesses.items():
        values[key] = name_of(up) if key == "up" else known.get(key, value)
        if values[key] == value:
            reasons[key] = reason
    values |= {key: known[key] for key in ("names", "categories", "color") if key in known}
    if made.color is not None and "color" not in known:
        values["color"], reasons["color"] = made.color[0], share_of_seen(made.color[1])
    outline, parts = made.model.outline, made.model.parts
    measured = {
        "size_m": [round(float(value), 4) for value in np.ptp(parts.corners, axis=0)],
        "outline": type(outline).__name__.lower(),
        "outline_error_m": round(parts.outline_error_m, 4),
        "parts": len(parts.ends),
        "solids_left_out": made.left_out,
        "mended": list(foreign.mends),
    }
    told = Guesses(values, reasons, measured)
    try:
        write_model(made.model, model_file(file))
        beside.write_text(sidecar_text(file.name, told), "utf-8")
    except OSError as refused:
        raise CannotImportError(f"{file}: cannot be written beside: {refused.strerror}") from refused
    return Imported(made.model, told, model_file(file), beside)


def _mass(foreign: Foreign, parts: ConvexParts) -> tuple[float, str]:
    """How heavy it is, kg, and why."""
    said = float(foreign.model.body_subtreemass[WORLD])
    if said > _UNSAID_KG * foreign.model.nbody:
        return max(said, LIGHTEST_KG), f"it says {said:.4g}"
    solid_m3 = sum(volume(corners) for corners in np.split(parts.corners, parts.ends[:-1]))
    mass_kg = min(max(DENSITY_KG_M3 * solid_m3, LIGHTEST_KG), HEAVIEST_KG)
    return round(mass_kg, 3), f"it says nothing; {DENSITY_KG_M3:g} kg/m3, {1000 * solid_m3:.2f} litres"


def _direction(value: Any) -> Up:
    if isinstance(value, str):
        return UP_AXES[value]
    x, y, z = value
    return float(x), float(y), float(z)
