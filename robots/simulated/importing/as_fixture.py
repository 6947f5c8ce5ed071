"""A foreign piece as a fixture of ours: its solids as boxes along its own axes, with knobs and buttons."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from kinematics.arrays import Array
from kinematics.geometry import poses
from robots.scenes.furniture_names import BUTTON, KNOB
from robots.simulated.importing.as_opening import (
    box_of,
    names_of,
    numbers,
    opening_values,
    why_stuck,
    within,
)
from robots.simulated.importing.bodies import Foreign
from robots.simulated.importing.inventory import FoundPiece
from robots.simulated.importing.openings import Opening
from robots.simulated.importing.regions import region_values, regions_of

_LENGTH_M, _RADIUS_M = (0.006, 0.06), (0.008, 0.05)
_BUTTON_M = (0.003, 0.03)
_KNOB_RAD = (0.3, 6.0)
_MOST_BOXES = 60


def fixture_values(foreign: Foreign, piece: FoundPiece, ground_m: float) -> tuple[dict[str, Any], list[str]]:
    """What a scene file says of a piece, without its name, and what of it is not as it was.

    Args:
        foreign: The model.
        piece: The piece.
        ground_m: Height of its floor.
    """
    controls = [one for one in piece.openings if one.kind in (KNOB, BUTTON)]
    own = {one.body for one in controls}
    yaw = _front_yaw(piece)
    to_own = poses.rotation_z(-yaw)
    others = [one for one in piece.openings if one.body not in own]
    stuck = why_stuck(foreign, others, to_own)
    told = list(stuck.values())
    shut = [one for k, one in enumerate(others) if k in stuck]
    moving = [one for k, one in enumerate(others) if k not in stuck]
    bodies = [*piece.bodies, *(each for one in shut for each in _with_children(foreign, one.body, own))]
    clouds = [foreign.corners(geom) @ to_own.T for geom in foreign.solid_geoms(bodies)]
    parts = [
        [
            np.maximum(foreign.corners(geom) @ to_own.T, (-np.inf, -np.inf, ground_m))
            for geom in foreign.solid_geoms(_with_children(foreign, one.body, own))
        ]
        for one in moving
    ]
    if not clouds:
        clouds = [np.array([piece.low, piece.high]) @ poses.rotation_z(piece.yaw_rad - yaw).T]
    if len(clouds) > _MOST_BOXES:
        told.append(f"{len(clouds) - _MOST_BOXES} of its {len(clouds)} solids are left out, the smallest")
        clouds = sorted(clouds, key=lambda cloud: -float(np.prod(np.ptp(cloud, axis=0))))[:_MOST_BOXES]
    clouds = [np.maximum(cloud, (-np.inf, -np.inf, ground_m)) for cloud in clouds]
    every = np.concatenate([*clouds, *(cloud for part in parts for cloud in part)])
    low, high = every.min(axis=0), every.max(axis=0)
    middle = 0.5 * (low + high)
    place = to_own.T @ middle
    origin = np.array([middle[0], middle[1], ground_m])
    values: dict[str, Any] = {
        "kind": "fixture",
        "size_m": numbers([*(high - low)[:2], high[2] - ground_m]),
        "position_m": numbers(place[:2]),
        "yaw_rad": round(float(yaw), 5),
        "foot_m": round(max(float(low[2] - ground_m), 0.0), 4),
        "box": [box_of(cloud - origin) for cloud in clouds],
    }
    said = _controls(foreign, controls, to_own, origin)
    if said:
        values["control"] = said
    names = names_of(moving, to_own)
    if moving:
        values["opening"] = [
            opening_values(foreign, one, name, part, to_own, origin)
            for one, name, part in zip(moving, names, parts, strict=True)
        ]
    if regions := region_values(regions_of(foreign, piece), to_own, origin, values["box"]):
        values["region"] = regions
    return values, told


def _with_children(foreign: Foreign, body: int, without: set[int]) -> list[int]:
    return [each for each in foreign.subtree(body) if each not in without]


def _front_yaw(piece: FoundPiece) -> float:
    """Its heading: against the way in which it opens or its controls face, as far as that is level."""
    for one in sorted(piece.openings, key=lambda opening: opening.kind in (KNOB, BUTTON)):
        x, y, _ = one.outwards
        if math.hypot(x, y) > 0.7:
            return math.atan2(-y, -x)
    return piece.yaw_rad


def _controls(
    foreign: Foreign, controls: list[Opening], to_own: Array, origin: Array
) -> list[dict[str, Any]]:
    """Knobs and buttons, of several of a kind each by what its body is called."""
    found = []
    names: set[str] = set()
    for one in controls:
        name, number = one.kind if len(controls) == 1 else _called(foreign, one), 1
        while name in names:
            number += 1
            name = f"{_called(foreign, one)} {number}"
        names.add(name)
        clouds = [foreign.corners(geom) @ to_own.T - origin for geom in foreign.solid_geoms([one.body])]
        corners = np.concatenate(clouds)
        way = to_own @ one.outwards
        top = way[2] > 0.7
        out, across = (2, (0, 1)) if top else (0, (1, 2))
        low, high = corners.min(axis=0), corners.max(axis=0)
        size, at = high - low, 0.5 * (low + high)
        at[out] = low[2] if top else high[0]
        knob = one.kind == KNOB
        found.append(
            {
                "name": name,
                "kind": one.kind,
                "position_m": numbers(at),
                "facing": "top" if top else "front",
                "radius_m": within(0.5 * max(size[axis] for axis in across), _RADIUS_M),
                "length_m": within(size[out], _LENGTH_M),
                "travel": within(one.range, _KNOB_RAD if knob else _BUTTON_M),
            }
        )
        if not knob:
            found[-1]["resistance"] = 4.0
    return found


def _called(foreign: Foreign, one: Opening) -> str:
    words = foreign.name(one.body).replace("_", " ").split()
    digits = [word for word in words if word.isdigit()]
    return " ".join([one.kind, *digits[-1:]]) if len(words) > 1 or digits else one.kind
