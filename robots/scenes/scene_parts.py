"""The keys of a scene file that describe a door or drawer."""

from __future__ import annotations

from typing import Any

from robots.scenes.articulated import ARTICULATED_KINDS
from robots.scenes.scene_description import Furniture, MovingPart
from robots.scenes.scene_table import SceneTable

_COMMON = (
    "mass_kg",
    "locked",
    "handle_height_m",
    "handle_radius_m",
    "handle_length_m",
    "handle_friction",
)
_OF_KIND = {
    "fridge": ("hinge", "friction_nm", "seal_n", "open_rad", "handle_inset_m"),
    "drawers": ("friction_n", "open_m"),
}
_DOOR = MovingPart(hinge="left", mass_kg=14.0, friction=2.0, seal_n=30.0)
_DRAWER = MovingPart(
    hinge=None, mass_kg=4.0, friction=10.0, handle_height_m=0.0, handle_radius_m=0.010, handle_length_m=0.16
)


def part_keys(kind: str) -> tuple[str, ...]:
    """Further keys of a piece of furniture of this kind."""
    return (*_COMMON, *_OF_KIND[kind]) if kind in ARTICULATED_KINDS else ()


def read_part(reader: SceneTable, kind: str) -> MovingPart | None:
    """The door or drawer of a piece of furniture; None when its kind has none."""
    if kind not in ARTICULATED_KINDS:
        return None
    door = kind == "fridge"
    default = _DOOR if door else _DRAWER
    hinge = reader.word("hinge", ("left", "right")) if door else None
    return MovingPart(
        hinge=None if hinge is None else "left" if hinge == "left" else "right",
        mass_kg=reader.number("mass_kg", default.mass_kg),
        friction=reader.number("friction_nm" if door else "friction_n", default.friction),
        seal_n=reader.number("seal_n", default.seal_n) if door else 0.0,
        locked=reader.flag("locked"),
        opening=reader.number("open_rad" if door else "open_m", 0.0),
        handle_height_m=reader.number("handle_height_m", default.handle_height_m),
        handle_inset_m=reader.number("handle_inset_m", default.handle_inset_m) if door else 0.0,
        handle_radius_m=reader.number("handle_radius_m", default.handle_radius_m),
        handle_length_m=reader.number("handle_length_m", default.handle_length_m),
        handle_friction=reader.number("handle_friction", default.handle_friction),
    )


def part_values(piece: Furniture) -> dict[str, Any]:
    """What ``read_part`` reads back."""
    part = piece.opens
    if part is None:
        return {}
    values: dict[str, Any] = {key: getattr(part, key) for key in _COMMON}
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
