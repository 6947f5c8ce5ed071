"""Drawers and doors of foreign furniture, found by their joints, and their handles by what protrudes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import mujoco
import numpy as np

from kinematics.arrays import Array, Sealed
from robots.simulated.importing.bodies import Foreign

_LEAST_SLIDE_M, _LEAST_TURN_RAD = 0.03, 0.3
"""What moves by less is a knob, a button or a spring."""
_SMALL_M, _SMALL_SHARE = 0.16, 0.5
"""What turns, is no larger, and is so much smaller than what it is on, is for fingers: a knob, a switch."""
_PANEL_SHARE = 0.45
"""The front is the farthest solid that covers so much of the part as seen from where it opens to."""
_PROTRUDES_M = 0.008
_CLEAR_M = 0.001
_THIN_SHARE = 0.35


@dataclass(frozen=True, slots=True)
class Handle(Sealed):
    """A handle.

    Attributes:
        middle: In the world, shape (3,), m.
        along: Its longest direction, shape (3,).
        length_m, thick_m: Along that, and across it.
        out_m: How far its middle is before the front.
    """

    middle: Array
    along: Array
    length_m: float
    thick_m: float
    out_m: float


@dataclass(frozen=True, slots=True)
class Opening(Sealed):
    """A part that opens.

    Attributes:
        body: MuJoCo's index.
        kind: "drawer" slides, "sliding door" does so along its own front, "door" turns about an upright axis,
            "lid" about a level one, "knob" turns on the spot, "button" hardly moves.
        outwards: Direction in which it opens when closed, shape (3,).
        low, high: Middle corner and extent of its solids in the world: lowest and highest corner, shape (3,).
        range: How far it opens, m or rad.
        axis: Of its joint, in the world, shape (3,).
        anchor: A point on that, shape (3,).
        handle: Its handle; None where nothing protrudes.
    """

    body: int
    kind: Literal["drawer", "sliding door", "door", "lid", "knob", "button"]
    outwards: Array
    low: Array
    high: Array
    range: float
    axis: Array
    anchor: Array
    handle: Handle | None


def opening_of(foreign: Foreign, body: int) -> Opening | None:
    """What opens by a body's only joint; None where that cannot be told."""
    joints = foreign.joints(body)
    geoms = foreign.solid_geoms([body])
    if len(joints) != 1 or not geoms:
        return None
    joint = joints[0]
    model, data = foreign.model, foreign.data
    axis, anchor = np.array(data.xaxis[joint]), np.array(data.xanchor[joint])
    clouds = [foreign.corners(geom) for geom in geoms]
    every = np.concatenate(clouds)
    low, high = every.min(axis=0), every.max(axis=0)
    middle = 0.5 * (low + high)
    now = float(data.qpos[int(model.jnt_qposadr[joint])])
    first, last = (float(value) for value in model.jnt_range[joint])
    if not model.jnt_limited[joint]:
        first, last = -np.pi, np.pi
    sign = 1.0 if last - now >= now - first else -1.0
    reach = max(last - now, now - first)
    front: Array | None = None
    slides = foreign.joint_type(joint) == int(mujoco.mjtJoint.mjJNT_SLIDE)
    if slides:
        outwards, kind = sign * axis, "drawer" if reach >= _LEAST_SLIDE_M else "button"
        if kind == "drawer" and (normal := _front_beside(_panel(clouds), outwards)) is not None:
            kind, front = "sliding door", normal
    else:
        arm = middle - anchor
        arm -= axis * (axis @ arm)
        extent = float(np.linalg.norm(np.ptp(every, axis=0)))
        small = _is_small(foreign, body, every)
        if np.linalg.norm(arm) < 0.15 * extent or reach < _LEAST_TURN_RAD or small:
            outwards, kind = axis, "knob"
        else:
            outwards = sign * np.cross(axis, arm)
            outwards = _panel_normal(clouds, outwards / np.linalg.norm(outwards))
            kind = "door" if abs(axis[2]) > 0.7 else "lid"
    handle = None
    if kind in ("drawer", "door", "lid", "sliding door"):
        ways = [outwards] if front is None else [front, -front]
        # a door's handle may be a part that turns on it
        hanging = [foreign.corners(geom) for geom in foreign.solid_geoms(foreign.subtree(body)[1:])]
        solids = [clouds, [*clouds, *hanging]] if hanging else [clouds]
        found = (_handle(these, way) for these in solids for way in ways)
        handle = next((one for one in found if one is not None), None)
    return Opening(body, kind, outwards, low, high, reach, axis, anchor, handle)  # type: ignore[arg-type]


def _is_small(foreign: Foreign, body: int, corners: Array) -> bool:
    """Whether a part is for fingers, beside what it is on."""
    largest = float(np.ptp(corners, axis=0).max())
    root = int(foreign.model.body_rootid[body])
    carrier = foreign.solid_geoms([each for each in foreign.subtree(root) if not foreign.joints(each)])
    if not carrier or largest > _SMALL_M:
        return False
    size = np.ptp(np.concatenate([foreign.corners(geom) for geom in carrier]), axis=0).max()
    return largest <= _SMALL_SHARE * float(size)


def _panel_normal(clouds: list[Array], outwards: Array) -> Array:
    """The normal of a door's panel, its largest solid, on the side to which it opens."""
    panel = _panel(clouds)
    _, thickness, directions = np.linalg.svd(panel - panel.mean(axis=0), full_matrices=False)
    normal = directions[2]
    if thickness[2] > 0.5 * thickness[1] or abs(normal @ outwards) < 0.7:
        return outwards
    return np.asarray(normal * np.sign(normal @ outwards))


def _panel(clouds: list[Array]) -> Array:
    """The solid with the largest face."""
    return max(clouds, key=lambda cloud: float(np.prod(np.sort(np.ptp(cloud, axis=0))[1:])))


def _front_beside(corners: Array, outwards: Array) -> Array | None:
    """The level normal of a thin upright part that slides along itself; None of a drawer."""
    beside = np.cross((0.0, 0.0, 1.0), outwards)
    if np.linalg.norm(beside) < 0.7:
        return None
    beside /= np.linalg.norm(beside)
    thick, long, high = (
        float(np.ptp(corners @ way)) for way in (beside, outwards, np.array([0.0, 0.0, 1.0]))
    )
    return np.asarray(beside) if thick < _THIN_SHARE * min(long, high) else None


def _handle(clouds: list[Array], outwards: Array) -> Handle | None:
    """What protrudes before the front along the way of opening.

    The front is the solid that covers most of the part as seen from where it opens to; boxes need not be
    along the axes of the world.
    """
    across = np.linalg.svd(outwards[None])[2][1:]
    every = np.concatenate(clouds) @ across.T
    whole = float(np.prod(np.ptp(every, axis=0)))
    panels = [
        float((cloud @ outwards).max())
        for cloud in clouds
        if np.prod(np.ptp(cloud @ across.T, axis=0)) >= _PANEL_SHARE * whole
    ]
    if not panels:
        return None
    front = max(panels)
    out = [cloud for cloud in clouds if (cloud @ outwards).max() > front + _PROTRUDES_M]
    if not out:
        return None
    # the bar is what is farthest out, and clear of the front; its posts come from there
    out = [cloud for cloud in out if (cloud @ outwards).min() > front + _CLEAR_M] or out
    farthest = max(float((cloud @ outwards).max()) for cloud in out)
    bar = np.concatenate([cloud for cloud in out if (cloud @ outwards).max() > farthest - _PROTRUDES_M])
    middle = 0.5 * (bar.min(axis=0) + bar.max(axis=0))
    level = bar - bar.mean(axis=0)
    level -= np.outer(level @ outwards, outwards)
    along = np.linalg.svd(level, full_matrices=False)[2][0]
    if middle @ outwards <= front:
        return None
    third = np.cross(outwards, along)
    return Handle(
        middle=middle,
        along=along,
        length_m=float(np.ptp(bar @ along)),
        thick_m=float(min(np.ptp(bar @ third), np.ptp(bar @ outwards))),
        out_m=float(middle @ outwards) - front,
    )
