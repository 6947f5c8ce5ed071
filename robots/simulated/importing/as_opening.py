"""Doors and drawers of foreign furniture as those of a fixture of ours: own boxes, own bar, own way."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from kinematics.arrays import Array
from robots.simulated.importing.bodies import Foreign
from robots.simulated.importing.openings import Opening

_FACING_COS = 0.97
"""What opens to another side than that of its piece where somebody stands does not move here."""
_TRAVEL = {"drawer": (0.05, 1.5), "door": (0.2, math.pi)}
_BAR_RADIUS_M, _BAR_LENGTH_M = (0.002, 0.03), (0.01, 2.0)
_MASS_KG = (0.3, 30.0)
_FRICTION = {"drawer": 2.0, "door": 0.3}
"""N and Nm, of joints that say none: they would be pushed open by a touch."""
_MOST_FRICTION = 30.0
_BEFORE_M = 0.004
"""What is farther before the front than this is a handle."""
_PANEL_M, _PANEL_SHARE = 0.02, 0.45
"""A front may be of several layers within this; each covers so much of it."""
_THIN_M = 0.08
"""A door that is no thicker is all front."""
_THINNEST_M = 0.002
_IN_COLUMN = {2: ("top", "bottom"), 3: ("top", "middle", "bottom")}


def why_stuck(foreign: Foreign, openings: Sequence[Opening], to_own: Array) -> dict[int, str]:
    """Why some openings of a piece do not move here, by their places in the list.

    Args:
        foreign: The model.
        openings: Those of one piece.
        to_own: From the world's axes to its own, shape (3, 3); who uses it stands at negative x.
    """
    told = {}
    for k, one in enumerate(openings):
        what = f"its {one.kind} {foreign.name(one.body)} does not move here"
        if one.kind not in _TRAVEL:
            told[k] = what
        elif float((to_own @ one.outwards)[0]) > -_FACING_COS:
            told[k] = f"{what}: it opens to another side than the rest"
        elif one.range < _TRAVEL[one.kind][0]:
            told[k] = f"{what}: it opens by {one.range:.2f} only"
    return told


def opening_values(
    foreign: Foreign, one: Opening, name: str, clouds: Sequence[Array], to_own: Array, origin: Array
) -> dict[str, Any]:
    """What a scene file says of a door or drawer.

    Args:
        foreign: The model.
        one: The door or drawer.
        name: What it is called beside the others.
        clouds: Corners of its solids along the piece's own axes, each of shape (n, 3).
        to_own: As above.
        origin: Of the piece's frame along those axes, shape (3,).
    """
    own = [cloud - origin for cloud in clouds]
    bar = None if one.handle is None else to_own @ one.handle.middle - origin
    front_x = math.inf if bar is None or one.handle is None else float(bar[0]) + one.handle.out_m
    kept = [cloud for cloud in own if bar is None or float(cloud[:, 0].mean()) > front_x - _BEFORE_M] or own
    front = _front(one.kind, kept)
    rest = [] if front is None else [cloud for cloud in kept if not _is_within(cloud, front)]
    if front is None:
        front = np.concatenate(kept)
    values: dict[str, Any] = {
        "name": name,
        "kind": one.kind,
        "travel": within(one.range, _TRAVEL[one.kind]),
        "mass_kg": within(sum(foreign.model.body_mass[each] for each in foreign.subtree(one.body)), _MASS_KG),
        "friction": _friction(foreign, one),
        "box": [box_of(cloud) for cloud in [front, *rest]],
    }
    if one.kind == "door":
        at = to_own @ one.anchor - origin
        low, high = front[:, 1].min(), front[:, 1].max()
        values["hinge"] = "left" if float(at[1]) > 0.5 * float(low + high) else "right"
        values["hinge_m"] = numbers(at[:2])
    if bar is not None and one.handle is not None:
        along = to_own @ one.handle.along
        values["bar"] = {
            "position_m": numbers(bar),
            "length_m": within(one.handle.length_m, _BAR_LENGTH_M),
            "radius_m": within(0.5 * one.handle.thick_m, _BAR_RADIUS_M),
            "upright": bool(abs(float(along[2])) > abs(float(along[1]))),
        }
    return values


def names_of(openings: Sequence[Opening], to_own: Array) -> list[str]:
    """What the doors and drawers of a piece are called beside each other: "top drawer", "left door"."""
    names: list[str] = [one.kind for one in openings]
    for kind in _TRAVEL:
        alike = [k for k, one in enumerate(openings) if one.kind == kind]
        if len(alike) < 2:
            continue
        middles = np.array([to_own @ (0.5 * (openings[k].low + openings[k].high)) for k in alike])
        spread = np.ptp(middles, axis=0)
        if spread[2] >= spread[1]:
            order = [alike[k] for k in np.argsort(-middles[:, 2], kind="stable")]
            words: Sequence[str] = _IN_COLUMN.get(len(alike), ())
        else:
            order = [alike[k] for k in np.argsort(-middles[:, 1], kind="stable")]
            words = ("left", "right") if len(alike) == 2 else ()
        for number, k in enumerate(order):
            names[k] = f"{words[number]} {kind}" if words else f"{kind} {number + 1}"
    return names


def _front(kind: str, clouds: Sequence[Array]) -> Array | None:
    """Corners of what is seen of a part from where it opens to; None where it has no panel."""
    every = np.concatenate(clouds)
    if kind == "door" and float(np.ptp(every[:, 0])) <= _THIN_M:
        return every
    whole = float(np.prod(np.ptp(every[:, 1:], axis=0)))
    panels = [cloud for cloud in clouds if np.prod(np.ptp(cloud[:, 1:], axis=0)) >= _PANEL_SHARE * whole]
    thin = [cloud for cloud in panels if float(np.ptp(cloud[:, 0])) <= _THIN_M]
    if not thin:
        return None
    first = min(float(cloud[:, 0].min()) for cloud in thin)
    return np.concatenate(
        [cloud for cloud in thin if float(cloud[:, 0].max()) <= first + _PANEL_M] or thin[:1]
    )


def _is_within(cloud: Array, front: Array) -> bool:
    low, high = front.min(axis=0) - _THINNEST_M, front.max(axis=0) + _THINNEST_M
    return bool(np.all(cloud.min(axis=0) >= low) and np.all(cloud.max(axis=0) <= high))


def _friction(foreign: Foreign, one: Opening) -> float:
    (joint,) = foreign.joints(one.body)
    said = float(foreign.model.dof_frictionloss[int(foreign.model.jnt_dofadr[joint])])
    return round(min(said, _MOST_FRICTION) if said > 0.0 else _FRICTION[one.kind], 4)


def box_of(cloud: Array) -> dict[str, Any]:
    """A box of a scene file about some corners, shape (n, 3)."""
    low, high = cloud.min(axis=0), cloud.max(axis=0)
    return {
        "size_m": numbers(np.maximum(high - low, _THINNEST_M)),
        "position_m": numbers(0.5 * (low + high)),
    }


def numbers(values: Any) -> list[float]:
    """As a scene file has them, to a tenth of a millimetre."""
    return [round(float(value), 4) for value in values]


def within(value: Any, bounds: tuple[float, float]) -> float:
    """The same of one number, within what a scene allows."""
    return round(float(np.clip(value, *bounds)), 4)
