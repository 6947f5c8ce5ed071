"""Which of our own kinds of furniture a foreign piece is, and what a scene file says of it then."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from kinematics.arrays import Array
from robots.scenes.articulated import DRAWER_FRONT_HEIGHT_M, GAP_M, WALL_M
from robots.scenes.fixture import CONTROL_KINDS
from robots.scenes.furniture_names import is_called_a, kind_that_name_contradicts
from robots.simulated.importing.as_fixture import fixture_values
from robots.simulated.importing.bodies import Foreign
from robots.simulated.importing.inventory import FoundPiece
from robots.simulated.importing.openings import Opening

_ON_FLOOR_M = 0.08
_TABLE_M, _LOWEST_TOP_M, _HIGHEST_TOP_M = 0.3, 0.3, 1.3
"""A table is as deep and as wide, and its top is between these heights."""
_BOARD_M = 0.12
_WALL_THICK_M, _WALL_HIGH_M = 0.3, 1.2
_LEAST = {"drawers": (0.3, 0.25, 0.28), "fridge": (0.3, 0.3, 0.5)}
_BAR_RADIUS_M, _BAR_LENGTH_M = (0.004, 0.016), 0.08
_TOPS = ("counter", "shelf", "table")


@dataclass(frozen=True, slots=True)
class OurPiece:
    """A piece as a scene file has it.

    Attributes:
        values: Its keys, without its name.
        top_m: Height of what things stand on; None of a wall.
        told: What of it is not as it was.
    """

    values: dict[str, Any]
    top_m: float | None
    told: tuple[str, ...] = ()


def our_piece(foreign: Foreign, piece: FoundPiece, ground_m: float = 0.0) -> OurPiece:
    """What it is here: furniture of a usual kind where it is like that, a fixture else.

    Args:
        foreign: The model.
        piece: The piece.
        ground_m: Height of its floor.
    """
    found = "its floor is elsewhere" if ground_m else _usual(foreign, piece)
    if isinstance(found, OurPiece) and not any(one.kind in CONTROL_KINDS for one in piece.openings):
        return found
    values, told = fixture_values(foreign, piece, ground_m)
    return OurPiece(values, float(piece.high[2]) - ground_m, tuple(told))


def _usual(foreign: Foreign, piece: FoundPiece) -> OurPiece | str:
    """Which of the usual kinds it is; in words why it is none of them.

    A fridge or a chest is one that is called so, and has one such part that opens. Whatever else opens is a
    fixture: each of its parts moves, and it is called as it is.
    """
    drawers = [one for one in piece.openings if one.kind == "drawer"]
    doors = [one for one in piece.openings if one.kind == "door"]
    if not drawers and not doors:
        return _plain(piece)
    stands = float(piece.low[2]) <= _ON_FLOOR_M
    if stands and is_called_a("drawers", piece.label) and len(drawers) == 1 and not doors:
        return _opening(foreign, piece, drawers[0], "drawers")
    if stands and is_called_a("fridge", piece.label) and len(doors) == 1:
        return _opening(foreign, piece, doors[0], "fridge")
    return "has parts of its own that open"


def _plain(piece: FoundPiece) -> OurPiece | str:
    size, top = piece.high - piece.low, float(piece.high[2])
    floats = float(piece.low[2]) > _ON_FLOOR_M and not _is_board(piece)
    if floats:
        return f"stands at {float(piece.low[2]):.2f} m"
    told = tuple(f"its {one.kind} {_what(one)} does not move here" for one in piece.openings)
    seen = f"{size[0]:.2f} x {size[1]:.2f} m with its top at {top:.2f} m"
    if min(size[:2]) <= _WALL_THICK_M and top - float(piece.low[2]) >= _WALL_HIGH_M:
        return OurPiece(_said("wall", piece, size, top), None, told)
    if min(size[:2]) < _TABLE_M or not _LOWEST_TOP_M <= top <= _HIGHEST_TOP_M:
        return f"is no furniture of ours, {seen}"
    kind = next((word for word in _TOPS if word in piece.label.split()), "table")
    told_kind = kind_that_name_contradicts(piece.label, kind)
    return OurPiece(_said(told_kind if told_kind in _TOPS else kind, piece, size, top), top, told)


def _is_board(piece: FoundPiece) -> bool:
    """Whether it is a top alone, as of a table whose legs nothing touches."""
    size = piece.high - piece.low
    return bool(size[2] <= _BOARD_M and min(size[:2]) >= _TABLE_M)


def _what(opening: Opening) -> str:
    return f"that opens by {opening.range:.2f}"


def _said(kind: str, piece: FoundPiece, size: Array, top: float) -> dict[str, Any]:
    middle = 0.5 * (piece.low + piece.high)
    c, s = math.cos(piece.yaw_rad), math.sin(piece.yaw_rad)
    place = [float(c * middle[0] - s * middle[1]), float(s * middle[0] + c * middle[1])]
    return {
        "kind": kind,
        "size_m": [float(size[0]), float(size[1]), top],
        "position_m": place,
        "yaw_rad": piece.yaw_rad,
    }


def _opening(foreign: Foreign, piece: FoundPiece, opening: Opening, kind: str) -> OurPiece | str:
    """A chest or a fridge: its x goes inwards, against the way of opening."""
    yaw = math.atan2(-opening.outwards[1], -opening.outwards[0])
    c, s = math.cos(yaw), math.sin(yaw)
    to_own = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
    geoms = foreign.solid_geoms([*piece.bodies, opening.body])
    bar = None if opening.handle is None else opening.handle
    solids = [foreign.corners(geom) @ to_own for geom in geoms]
    front = math.inf if bar is None else float((bar.middle @ to_own)[0]) + bar.out_m
    kept = [solid for solid in solids if bar is None or solid[:, 0].mean() > front - 0.004]
    own = np.concatenate(kept or solids)
    low, high = own.min(axis=0), own.max(axis=0)
    size, middle = high - low, 0.5 * (low + high)
    top = float(high[2])
    if any(value < least for value, least in zip((*size[:2], top), _LEAST[kind], strict=True)):
        seen = " x ".join(f"{value:.2f}" for value in size)
        return f"is too small for a {kind} of ours, {seen} m"
    values: dict[str, Any] = {
        "kind": kind,
        "size_m": [float(size[0]), float(size[1]), top],
        "position_m": [float(value) for value in (to_own @ middle)[:2]],
        "yaw_rad": yaw,
    }
    told = [
        f"its {one.kind} {foreign.name(one.body)} does not move here"
        for one in piece.openings
        if one is not opening
    ]
    if kind == "fridge":
        values["hinge"] = "left" if float((opening.anchor @ to_own)[1]) > middle[1] else "right"
    if bar is None:
        told.append("its handle was not found: it is where such a thing has it usually")
        return OurPiece(values, top, tuple(told))
    at = bar.middle @ to_own
    values["handle_radius_m"] = float(np.clip(0.5 * bar.thick_m, *_BAR_RADIUS_M))
    values["handle_length_m"] = float(
        np.clip(bar.length_m, _BAR_LENGTH_M, size[2 if kind == "fridge" else 1] - 0.1)
    )
    if kind == "fridge":
        free = low[1] if values["hinge"] == "left" else high[1]
        values["handle_height_m"] = float(np.clip(at[2], 0.15, top - 0.05))
        values["handle_inset_m"] = float(np.clip(abs(at[1] - free), 0.03, 0.45 * size[1]))
    else:
        half = 0.5 * DRAWER_FRONT_HEIGHT_M
        off = float(at[2]) - (top - WALL_M - GAP_M - half)
        values["handle_height_m"] = float(np.clip(off, -0.8 * half, 0.8 * half))
    return OurPiece(values, top, tuple(told))
