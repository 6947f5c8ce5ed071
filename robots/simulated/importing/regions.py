"""Named parts of foreign furniture: box sites as in LIBERO, geoms called "reg_..." as in RoboCasa."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Any

import mujoco
import numpy as np

from kinematics.arrays import Array, Sealed
from robots.scenes.named_region import PLATE_M
from robots.simulated.importing.bodies import Foreign, label_of_body
from robots.simulated.importing.inventory import FoundPiece

_REGION_GEOM = re.compile(r"(^|_)reg_(?!main$|bbox$)")
_SAYS_NOTHING = re.compile(r"(_|^)(reg|region|contain|site)(?=_|$)")
_SMALLEST_M = 0.03
_SIGNS = np.array([[x, y, z] for x in (-1.0, 1.0) for y in (-1.0, 1.0) for z in (-1.0, 1.0)])
_UNDER_M = 0.03
"""A floor may be so far below what a file says of a region."""


@dataclass(frozen=True, slots=True)
class FoundRegion(Sealed):
    """A part of a piece with a name.

    Attributes:
        said: What the file calls it.
        name: What it is called here.
        corners: Of its box in the world, shape (8, 3), m.
    """

    said: str
    name: str
    corners: Array


def regions_of(foreign: Foreign, piece: FoundPiece) -> tuple[FoundRegion, ...]:
    """The named parts of what does not move of a piece; what goes with a drawer is none."""
    root, found, taken = foreign.name(piece.body), [], set()
    for said, corners in _boxes(foreign, set(piece.bodies)):
        if min(np.ptp(corners, axis=0)[:2]) < _SMALLEST_M:
            continue
        name, number = _called(said, root, piece.label), 1
        while name in taken:
            number += 1
            name = f"{_called(said, root, piece.label)} {number}"
        taken.add(name)
        found.append(FoundRegion(said, name, corners))
    return tuple(found)


def _boxes(foreign: Foreign, bodies: set[int]) -> Iterator[tuple[str, Array]]:
    model, data, box = foreign.model, foreign.data, int(mujoco.mjtGeom.mjGEOM_BOX)
    for k in range(model.nsite):
        name = str(model.site(k).name)
        if int(model.site_bodyid[k]) in bodies and int(model.site_type[k]) == box and name:
            corners = (_SIGNS * model.site_size[k]) @ data.site_xmat[k].reshape(3, 3).T
            yield name, np.asarray(corners + data.site_xpos[k], np.float64)
    for k in range(model.ngeom):
        name = str(model.geom(k).name)
        if int(model.geom_bodyid[k]) in bodies and _REGION_GEOM.search(name):
            yield name, foreign.corners(k)


def _called(said: str, root: str, label: str) -> str:
    """What people call it: "desk_caddy_1_back_contain_region" is "desk caddy back"."""
    own = said.removeprefix(root).removeprefix(re.sub(r"(_main|_object)$", "", root))
    words = label_of_body(_SAYS_NOTHING.sub("", own).strip("_") or "inside")
    return words if words.startswith(label) else f"{label} {words}"


def region_values(
    found: Iterable[FoundRegion], to_own: Array, origin: Array, boxes: Iterable[dict[str, Any]]
) -> list[dict[str, Any]]:
    """What a scene file says of the parts of a piece: each with its floor on what is under its middle.

    Args:
        found: The parts.
        to_own: Turns the world into the piece's own axes, shape (3, 3).
        origin: Of its frame, along its own axes, shape (3,).
        boxes: What it is made of here.
    """
    solids = [(np.array(box["position_m"]), 0.5 * np.array(box["size_m"])) for box in boxes]
    values = []
    for region in found:
        own = region.corners @ to_own.T - origin
        low, high = own.min(axis=0), own.max(axis=0)
        middle = 0.5 * (low + high)
        tops = [
            float(at[2] + half[2])
            for at, half in solids
            if np.all(np.abs(middle[:2] - at[:2]) <= half[:2])
            and low[2] - _UNDER_M <= at[2] + half[2] <= high[2]
        ]
        floor = max(tops, default=float(low[2]))
        size = (*(high - low)[:2], max(float(high[2]) - floor, PLATE_M))
        values.append(
            {
                "name": region.name,
                "size_m": [round(float(value), 4) for value in size],
                "position_m": [round(float(value), 4) for value in (*middle[:2], max(floor, 0.0))],
            }
        )
    return values
