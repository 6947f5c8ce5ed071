"""A door or drawer of a fixture: its own boxes, its own handle, its own way."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final, Literal

from robots.scenes.fixture import FixedBox, Size

OPENING_KINDS: Final = ("door", "drawer")


@dataclass(frozen=True, slots=True)
class Bar:
    """The bar of a handle.

    Attributes:
        position_m: Its middle in the fixture's frame while shut; z is above the floor.
        length_m, radius_m: Of the bar; what is flat counts as round, as thick as it is across.
        upright: Whether it stands; else it lies along the fixture's y.
    """

    position_m: Size
    length_m: float
    radius_m: float
    upright: bool = False


@dataclass(frozen=True, slots=True)
class Opening:
    """A part of a fixture that opens towards who stands before it.

    Attributes:
        name: What it is called beside the others of its piece: "top drawer", "door".
        kind: "drawer" slides along the fixture's negative x, "door" turns outwards about an upright hinge.
        travel: How far it opens, m of a drawer, rad of a door.
        boxes: What it is made of while shut, in the fixture's frame, its front first.
        bar: Of its handle; None where nothing protrudes.
        hinge: On which side a door hangs, seen by who stands before it; None of a drawer.
        hinge_m: Where its hinge stands, x and y in the fixture's frame; None: at the front's edge.
        mass_kg: Of all that moves.
        friction: Of the hinge, Nm, or of the slide, N.
        seal_n: Pull at the handle of a magnetic seal, while a door is nearly closed.
        locked: It does not open.
        opening: How far it is open when the scene begins, m or rad.
        handle_friction: Effective, with the finger pads.
    """

    name: str
    kind: Literal["door", "drawer"]
    travel: float
    boxes: tuple[FixedBox, ...]
    bar: Bar | None = None
    hinge: Literal["left", "right"] | None = None
    hinge_m: tuple[float, float] | None = None
    mass_kg: float = 1.0
    friction: float = 1.0
    seal_n: float = 0.0
    locked: bool = False
    opening: float = 0.0
    handle_friction: float = 0.9

    @property
    def axis_m(self) -> tuple[float, float]:
        """Where a door's hinge stands, in the fixture's frame."""
        if self.hinge_m is not None:
            return self.hinge_m
        front = self.boxes[0]
        side = 0.5 if self.hinge == "left" else -0.5
        return front.position_m[0], front.position_m[1] + side * front.size_m[1]


def openings_defect(openings: tuple[Opening, ...], taken: tuple[str, ...]) -> tuple[str, str] | None:
    """The key and the reason of the first rule that the openings of a fixture break, or None.

    Args:
        openings: All of a piece.
        taken: Names of its other parts.
    """
    names = [*taken, *(one.name for one in openings)]
    for k, one in enumerate(openings):
        key = f"opening[{k}]"
        if "/" in one.name or not one.name.strip():
            return f"{key}.name", "must be a name without '/'"
        if names.count(one.name) > 1:
            return f"{key}.name", f"{one.name!r} is another one of its parts"
        if not one.boxes:
            return f"{key}.box", "needs at least one box, its front first"
        if (one.hinge is None) == (one.kind == "door"):
            return f"{key}.hinge", 'a door has a hinge, "left" or "right"; a drawer has none'
        for name, value, low, high in _ranges(one):
            if not (math.isfinite(value) and low <= value <= high):
                return f"{key}.{name}", f"must be from {low:g} to {high:g}, not {value:g}"
        if any(min(box.size_m) < _SMALLEST_BOX_M for box in one.boxes):
            return f"{key}.box", f"must be at least {_SMALLEST_BOX_M:g} m in all directions"
        if one.locked and one.opening > 0.0:
            return f"{key}.locked", "what is open is not locked"
    return None


_SMALLEST_BOX_M = 0.001


def _ranges(one: Opening) -> tuple[tuple[str, float, float, float], ...]:
    bar = () if one.bar is None else (
        ("bar.length_m", one.bar.length_m, 0.01, 2.0),
        ("bar.radius_m", one.bar.radius_m, 0.002, 0.03),
    )  # fmt: skip
    return (
        ("travel", one.travel, *((0.05, 1.5) if one.kind == "drawer" else (0.2, math.pi))),
        ("mass_kg", one.mass_kg, 0.05, 100.0),
        ("friction", one.friction, 0.0, 100.0),
        ("seal_n", one.seal_n, 0.0, 500.0 if one.kind == "door" else 0.0),
        ("open", one.opening, 0.0, one.travel),
        ("handle_friction", one.handle_friction, 0.01, 5.0),
        *bar,
    )
