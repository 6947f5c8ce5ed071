"""What is fixed where it stands and is no furniture of a usual kind: a stove, a coffee machine, a cabinet.

It is made of boxes, stands on the floor or on something else, and may have knobs that turn and buttons that
give way. In its own frame (origin in its centre on the floor, x along its depth) whoever uses it stands at
negative x and looks along x.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

import numpy as np

from kinematics.arrays import Sealed
from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Box
from robots.scenes.furniture_names import BUTTON, KNOB

CONTROL_KINDS = (KNOB, BUTTON)
KNOB_THICK_M = 0.024
"""Of the bar that fingers turn a knob by: fingers that are closer than this count as empty."""

Size = tuple[float, float, float]


@dataclass(frozen=True, slots=True)
class FixedBox:
    """A box of a fixture.

    Attributes:
        size_m: Along the fixture's own x, y and z.
        position_m: Of its middle in the fixture's frame; z is above the floor.
    """

    size_m: Size
    position_m: Size


@dataclass(frozen=True, slots=True)
class Control:
    """A knob or a button.

    Attributes:
        name: What it is called beside the others of its piece: "knob", "left knob", "power button".
        kind: "knob" turns about the way it faces, "button" gives way against it.
        position_m: Of the middle of its foot in the fixture's frame; z is above the floor.
        facing: Where it stands out to: "front" is to who stands before it, "top" is up.
        radius_m: Half its width; a knob's bar is so long to either side.
        length_m: How far it stands out.
        travel: How far it turns, rad, clockwise for who looks at it; or gives way, m.
        resistance: Torque of a knob, Nm; force of a button's spring when it is fully pressed, N.
        at: How far it is turned when the scene begins, rad; buttons are out.
    """

    name: str
    kind: Literal["knob", "button"]
    position_m: Size
    facing: Literal["front", "top"] = "front"
    radius_m: float = 0.026
    length_m: float = 0.045
    travel: float = 1.6
    resistance: float = 0.08
    at: float = 0.0


@dataclass(frozen=True, slots=True)
class ControlSolid(Sealed):
    """The one solid of a knob or button, at rest.

    Attributes:
        shape: Its x is along its length, outwards; its y is across, its z is a knob's thickness.
        furniture_T_solid: Pose in the fixture's frame when not turned and not pressed, shape (4, 4).
    """

    shape: Box
    furniture_T_solid: Transform


def control_solid(control: Control) -> ControlSolid:
    """What a control is made of: x of the solid points inwards, as a hand does that comes to it."""
    wide = 2.0 * control.radius_m
    size = (control.length_m, wide, KNOB_THICK_M if control.kind == KNOB else wide)
    inwards = np.eye(3) if control.facing == "front" else poses.rotation_y(0.5 * math.pi)
    foot = poses.transform(inwards, control.position_m)
    return ControlSolid(Box(size), foot @ poses.translation(-0.5 * control.length_m, 0.0, 0.0))


def moved_control(control: Control, by: float) -> Transform:
    """Motion of a control in its solid's frame: a turn about x, clockwise for who looks at it, or a shift."""
    if control.kind == KNOB:
        return poses.transform(poses.rotation_x(by), (0.0, 0.0, 0.0))
    return poses.translation(by, 0.0, 0.0)


def fixture_boxes(size_m: Size, foot_m: float, boxes: tuple[FixedBox, ...]) -> list[tuple[str, Size, Size]]:
    """The solids of a fixture: part, size and centre in its frame, the one that carries things first."""
    depth, width, top = size_m
    if not boxes:
        tall = top - foot_m
        return [("top", (depth, width, tall), (0.0, 0.0, foot_m + 0.5 * tall))]
    tops = [one.position_m[2] + 0.5 * one.size_m[2] for one in boxes]
    near = [k for k, height in enumerate(tops) if height >= max(tops) - 0.01]
    first = max(near, key=lambda k: boxes[k].size_m[0] * boxes[k].size_m[1])
    order = [first, *(k for k in range(len(boxes)) if k != first)]
    names = ["top", *(f"box_{k}" for k in range(1, len(boxes)))]
    return [(name, boxes[k].size_m, boxes[k].position_m) for name, k in zip(names, order, strict=True)]


def fixture_defect(
    size_m: Size, foot_m: float, boxes: tuple[FixedBox, ...], controls: tuple[Control, ...]
) -> tuple[str, str] | None:
    """The key and the reason of the first rule that a fixture breaks, or None."""
    if not 0.0 <= foot_m < size_m[2]:
        return "foot_m", f"must be from 0 to below its top at {size_m[2]:g} m, not {foot_m:g}"
    for k, box in enumerate(boxes):
        if min(box.size_m) < _SMALLEST_BOX_M or not all(map(math.isfinite, (*box.size_m, *box.position_m))):
            return f"box[{k}].size_m", f"must be at least {_SMALLEST_BOX_M:g} m in all directions"
        if box.position_m[2] - 0.5 * box.size_m[2] < -_SMALLEST_BOX_M:
            return f"box[{k}].position_m", "is in the floor"
    if not boxes and size_m[2] - foot_m < _SMALLEST_BOX_M:
        return "foot_m", f"it must be at least {_SMALLEST_BOX_M:g} m high"
    names = [control.name for control in controls]
    for k, control in enumerate(controls):
        for key, value, low, high in _ranges(control):
            if not (math.isfinite(value) and low <= value <= high):
                return f"control[{k}].{key}", f"must be from {low:g} to {high:g}, not {value:g}"
        if names.index(control.name) != k:
            return f"control[{k}].name", f"{control.name!r} is another one of its controls"
        if "/" in control.name or not control.name.strip():
            return f"control[{k}].name", "must be a name without '/'"
    return None


_SMALLEST_BOX_M = 0.001


def _ranges(control: Control) -> tuple[tuple[str, float, float, float], ...]:
    knob = control.kind == KNOB
    return (
        ("radius_m", control.radius_m, 0.005, 0.1),
        ("length_m", control.length_m, 0.004, 0.1),
        ("travel", control.travel, *((0.2, 6.0) if knob else (0.001, 0.03))),
        ("resistance", control.resistance, *((0.0, 1.0) if knob else (0.5, 15.0))),
        ("at", control.at, 0.0, control.travel if knob else 0.0),
    )
