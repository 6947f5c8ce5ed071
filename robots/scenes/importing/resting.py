"""How a thing rests on something level, and which of its sides was meant to be up."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from kinematics.arrays import Array, Sealed
from robots.scenes.importing.extra import library
from robots.scenes.meshes.up_axis import UP_AXES, Up, upright

SURE_MARGIN = 0.12
"""Of what is as wide: a thing stands surely when its middle is so far inside of what it stands on."""
SLIM, SLIM_MARGIN = 2.3, 0.1
"""What is so many times as high as wide is slim; it stands surely with such a share of its height."""
_FLAT_COSINE = np.cos(np.radians(1.0))
_LEAST_MARGIN_M = 0.004
_ALIKE_M = 0.006
_LIFT_M = 0.0015
"""Corners that are this little above the lowest carry as well: what was measured is never quite level."""
_MOST = 12


@dataclass(frozen=True, slots=True)
class Rests(Sealed):
    """Ways to rest.

    Attributes:
        up: Direction of the thing that is up, shape (k, 3), the safest first.
        margin_m: How far the middle is inside of what the thing stands on, shape (k,).
    """

    up: Array
    margin_m: Array


def rests_of(corners: Array, middle: Array) -> Rests:
    """Every way in which a thing lies on a facet of its hull and does not tip; if none is safe, the safest.

    Args:
        corners: Of the thing, shape (n, 3), m.
        middle: Its centre of mass, shape (3,), m.
    """
    hull = library("scipy.spatial").ConvexHull(corners)
    normals: list[Array] = []
    for normal in hull.equations[:, :3]:
        if not any(normal @ other > _FLAT_COSINE for other in normals):
            normals.append(normal)
    found = [(margin_m(corners, middle, -normal), -normal) for normal in normals]
    found = sorted((each for each in found if each[0] > 0.0), key=lambda each: -each[0])[:_MOST]
    safe = [each for each in found if each[0] >= _LEAST_MARGIN_M] or found[:1]
    return Rests(np.array([up for _, up in safe]).reshape(-1, 3), np.array([margin for margin, _ in safe]))


def margin_m(corners: Array, middle: Array, up: Array) -> float:
    """How far the middle is inside of what a thing stands on, with a direction of it up; below 0 it tips."""
    turn = upright(_direction(up))
    placed, centre = corners @ turn.T, turn @ middle
    foot = placed[placed[:, 2] <= placed[:, 2].min() + _LIFT_M, :2] - centre[:2]
    if len(foot) < 3 or np.linalg.svd(foot - foot.mean(axis=0), compute_uv=False)[1] < 1e-6:
        return -1.0
    # equations of a polygon's edges: outward normal and offset, negative inside
    return float(-library("scipy.spatial").ConvexHull(foot).equations[:, 2].max())


def guessed_up(corners: Array, middle: Array, ending: str) -> tuple[Up, str]:
    """The direction of a mesh that is most likely up, and why.

    What people call a thing's top is one of the mesh's axes nearly always: the long one of what is slim and
    stands on its end, a carton, a bottle; else the file's own habit where the thing stands so, then the next
    on which it stands; where it stands on none, as it is hardest to tip over.

    Args:
        corners: Of the hull, shape (n, 3), m.
        middle: Centre of mass, shape (3,), m.
        ending: Of the file: of GLB, y is up.
    """
    usual = "+y" if ending in (".glb", ".gltf") else "+z"
    names = [usual, *(name for name in UP_AXES if name != usual)]
    slim = [name for name in names if _stands_slim(corners, middle, name)]
    if slim:
        best = max(
            slim, key=lambda name: round(margin_m(corners, middle, np.array(UP_AXES[name])) / _ALIKE_M)
        )
        return UP_AXES[best], "it is slim, and stands on its end so"
    for name in names:
        up = np.array(UP_AXES[name])
        if _is_slim(corners, name):
            continue  # it would stand on an end that is too small for it
        across = np.ptp(corners @ upright(UP_AXES[name]).T, axis=0)[:2].max()
        if margin_m(corners, middle, up) >= max(_LEAST_MARGIN_M, SURE_MARGIN * across):
            why = (
                "it stands so, and files of this kind have that axis up" if name == usual else "it stands so"
            )
            return UP_AXES[name], why
    rests = rests_of(corners, middle)
    if not len(rests.up):
        return UP_AXES[usual], "files of this kind have that axis up; it stands on no side"
    heights_m = rests.up @ middle - (rests.up @ corners.T).min(axis=1)
    steadiest = int(np.argmax(rests.margin_m / heights_m))
    return _direction(rests.up[steadiest]), "it stands on none of its axes, and is so hardest to tip over"


def _stands_slim(corners: Array, middle: Array, name: str) -> bool:
    """Whether a thing is much higher than wide with an axis up, and stands so."""
    if not _is_slim(corners, name):
        return False
    high = float(np.ptp(corners @ np.array(UP_AXES[name])))
    return margin_m(corners, middle, np.array(UP_AXES[name])) >= max(_LEAST_MARGIN_M, SLIM_MARGIN * high)


def _is_slim(corners: Array, name: str) -> bool:
    """Whether a thing is much higher than wide with an axis up."""
    wide, deep, high = np.ptp(corners @ upright(UP_AXES[name]).T, axis=0).tolist()
    return bool(high >= SLIM * max(wide, deep))


def _direction(up: Array) -> Up:
    x, y, z = (float(value) for value in up)
    return x, y, z
