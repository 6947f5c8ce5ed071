"""The objects of a foreign scene, each made into files beside the scene file, and where they stand in it."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from robots.scenes.importing.seen_color import share_of_seen
from robots.scenes.meshes.object_model import model_file, write_model
from robots.scenes.meshes.sidecar import Guesses, sidecar_file, sidecar_text
from robots.simulated.importing.foreign_object import ForeignObject, foreign_object
from robots.simulated.importing.inventory import FoundObject, Inventory

_NEAR_TOP_M, _FALLS_M = 0.06, 0.2
"""How deep in a top, and how high above it, a thing may be that stands on it once it has settled."""
_LIGHTEST_KG = 0.02
_TOPS = ("counter", "shelf", "table")
_FLOOR = "the floor"


@dataclass(frozen=True, slots=True)
class Placed:
    """An object.

    Attributes:
        name: In the scene.
        values: Its keys there, without its name; None where it cannot be put into it.
        why_not: In words then.
        guess: What was guessed of it.
    """

    name: str
    values: dict[str, Any] | None
    why_not: str
    guess: dict[str, Any]


def placed_objects(
    found: Inventory, furniture: Mapping[str, Mapping[str, Any]], scene_file: Path
) -> list[Placed]:
    """Write the objects' files, and tell where each stands.

    Args:
        found: What is in the foreign scene.
        furniture: Its furniture as the scene file has it, by name.
        scene_file: The scene file.

    Raises:
        OSError: A file cannot be written.
    """
    taken = set(furniture)
    placed: list[Placed] = []
    for thing in found.objects:
        name, number = thing.label, 1
        while name in taken:
            number += 1
            name = f"{thing.label} {number}"
        taken.add(name)
        placed.append(_placed(found, thing, name, furniture, scene_file))
    return placed


def _placed(
    found: Inventory,
    thing: FoundObject,
    name: str,
    furniture: Mapping[str, Mapping[str, Any]],
    scene_file: Path,
) -> Placed:
    made = foreign_object(found.foreign, thing.bodies)
    folder = scene_file.with_suffix("").name + "_objects"
    mass = max(thing.mass_kg, _LIGHTEST_KG)
    file = scene_file.parent / folder / name.replace(" ", "_")
    _write(found, thing, made, file, mass)
    place = made.world_T_object.copy()
    place[2, 3] -= found.ground_m
    half = 0.5 * made.model.outline.height_m
    foot = float(place[2, 3]) - half
    on, top = _carrier(place, foot, furniture)
    guess = {
        "body": found.foreign.name(thing.body),
        "label": thing.label,
        "on": on or "nothing",
        "falls_m": round(foot - top, 4),
        "mass_kg": mass,
        "parts": len(made.model.parts.ends),
        **({} if made.color is None else {"color": made.color[0]}),
    }
    if on is None:
        return Placed(name, None, f"stands on nothing that is known, its foot at {foot:.2f} m", guess)
    yaw = math.atan2(place[1, 0], place[0, 0])
    values: dict[str, Any] = {"mesh": f"{folder}/{file.name}"}
    if on in furniture and furniture[on]["kind"] in _TOPS:
        piece = furniture[on]
        values |= {"on": on, "position_m": list(_within(piece, place)), "yaw_rad": yaw - piece["yaw_rad"]}
    else:
        values |= {"position_m": [float(place[0, 3]), float(place[1, 3]), top + half], "yaw_rad": yaw}
    return Placed(name, values, "", guess)


def _write(found: Inventory, thing: FoundObject, made: ForeignObject, file: Path, mass: float) -> None:
    file.parent.mkdir(parents=True, exist_ok=True)
    write_model(made.model, model_file(file))
    values: dict[str, Any] = {"scale": 1.0, "up": "+z", "label": thing.label, "mass_kg": mass}
    reasons = {"up": "as it stands there", "label": f"the body {found.foreign.name(thing.body)!r}"}
    if made.color is not None:
        values["color"], reasons["color"] = made.color[0], share_of_seen(made.color[1])
    if mass > thing.mass_kg:
        reasons["mass_kg"] = f"it says {thing.mass_kg:.4g}"
    measured = {"parts": len(made.model.parts.ends), "solids_left_out": made.left_out}
    sidecar_file(file).write_text(sidecar_text(file.name, Guesses(values, reasons, measured)), "utf-8")


def _carrier(
    place: Transform, foot: float, furniture: Mapping[str, Mapping[str, Any]]
) -> tuple[str | None, float]:
    """What an object falls on, and the height of that; None where that is far below its foot."""
    tops = [(0.0, _FLOOR)]
    for name, piece in furniture.items():
        tops += [(top, name) for top in _tops_under(piece, place)]
    under = [(top, name) for top, name in tops if top <= foot + _NEAR_TOP_M]
    top, name = max(under, default=(-1.0, _FLOOR))
    return (name, top) if foot - top <= _FALLS_M else (None, 0.0)


def _tops_under(piece: Mapping[str, Any], place: Transform) -> Sequence[float]:
    x, y = _within(piece, place)
    if piece["kind"] in _TOPS:
        depth, width, top = piece["size_m"]
        return [top] if abs(x) <= 0.5 * depth and abs(y) <= 0.5 * width else []
    return [
        box["position_m"][2] + 0.5 * box["size_m"][2]
        for box in piece.get("box", ())
        if abs(x - box["position_m"][0]) <= 0.5 * box["size_m"][0]
        and abs(y - box["position_m"][1]) <= 0.5 * box["size_m"][1]
    ]


def _within(piece: Mapping[str, Any], place: Transform) -> tuple[float, float]:
    """Where something is from the middle of a piece, along its own axes."""
    off = np.array([place[0, 3] - piece["position_m"][0], place[1, 3] - piece["position_m"][1], 0.0])
    own = poses.rotation_z(-piece["yaw_rad"]) @ off
    return float(own[0]), float(own[1])
