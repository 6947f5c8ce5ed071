"""Where the TCP of an arm is: before what hangs on its last joint, along the way that this points."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from kinematics.arrays import Array
from kinematics.geometry import poses
from tools.robot_data.drafting.anatomy import Anatomy
from tools.robot_data.drafting.limbs import Limbs

_SNAP_RAD = math.radians(50.0)
"""A way that is this near to an axis of the link, or of its joint, is that axis."""
_INSIDE_TIPS_M = 0.015
"""Between fingers the TCP is so far behind their tips."""
_PALM_M = 0.02
_AHEAD = 0.6
"""Of what hangs there, that beyond this share of the way tells where it points."""


@dataclass(frozen=True, slots=True)
class HandPlace:
    """A hand of an arm.

    Attributes:
        link: The link that carries it.
        link_T_tcp: Its TCP, x along the approach and y along the opening, shape (4, 4).
        fingers: Whether there are fingers.
        why: What it was made from.
    """

    link: str
    link_T_tcp: Array
    fingers: bool
    why: str


def hand_of(anatomy: Anatomy, limbs: Limbs, arm: tuple[str, ...]) -> HandPlace:
    """The hand of an arm, from its shape with the joints at zero."""
    last = arm[-1]
    link = anatomy.joints[last].link
    level_T_link = anatomy.frame(link)
    beyond = [name for name in anatomy.subtree(last) if name != last and name in limbs.fingers]
    tips = _in_link(anatomy.all_points(beyond), level_T_link)
    body = _in_link(anatomy.points(last), level_T_link)
    points = np.vstack([body, tips])
    axis = level_T_link[:3, :3].T @ anatomy.axis(last)
    before = _in_link(anatomy.place(arm[-2])[None, :3, 3], level_T_link)[0] if len(arm) > 1 else np.zeros(3)
    ahead, why = _way(points, tips, axis, before)
    reach = float((points @ ahead).max()) if len(points) else 0.0
    along = max(reach - _INSIDE_TIPS_M, 0.0) if len(tips) else reach + _PALM_M
    middle = _middle(points, ahead, along)
    opening = _opening(anatomy, beyond, level_T_link, ahead)
    across = np.cross(ahead, opening)
    rotation = np.column_stack([ahead, opening, across])
    return HandPlace(link, poses.transform(rotation, middle), bool(len(tips)), why)


def _in_link(points: Array, level_T_link: Array) -> Array:
    return (points - level_T_link[:3, 3]) @ level_T_link[:3, :3]


def _way(points: Array, tips: Array, axis: Array, before: Array) -> tuple[Array, str]:
    """The unit vector that a hand points along, in its link's axes."""
    if len(tips):
        way, why = tips.mean(axis=0), "along the fingers"
    elif len(points) and np.linalg.norm(points, axis=1).max() > _PALM_M:
        far = points[np.linalg.norm(points, axis=1) > _AHEAD * np.linalg.norm(points, axis=1).max()]
        way, why = far.mean(axis=0), "along what hangs on the last joint"
    else:
        way, why = axis * (1.0 if axis @ before <= 0.0 else -1.0), "along the axis of the last joint"
    if np.linalg.norm(way) < 1e-6:
        way = axis
    way = way / np.linalg.norm(way)
    nearest = max((*np.eye(3), *-np.eye(3), axis, -axis), key=lambda one: float(one @ way))
    return (nearest if math.acos(min(1.0, float(nearest @ way))) < _SNAP_RAD else way), why


def _middle(points: Array, ahead: Array, along: float) -> Array:
    """A point so far along the way, in the middle of what is there across it."""
    place = ahead * along
    if not len(points):
        return place
    near = points[points @ ahead > along - 0.06]
    near = near if len(near) else points
    centre = 0.5 * (near.min(axis=0) + near.max(axis=0))
    return np.asarray(place + centre - ahead * (centre @ ahead))


def _opening(anatomy: Anatomy, fingers: list[str], level_T_link: Array, ahead: Array) -> Array:
    """The unit vector along which fingers part, across the approach; without fingers any that is."""
    middles = [
        _in_link(points, level_T_link).mean(axis=0)
        for points in (anatomy.points(name) for name in fingers)
        if len(points)
    ]
    if len(middles) > 1:
        spread = np.array(middles) - np.mean(middles, axis=0)
        spread -= np.outer(spread @ ahead, ahead)
        way = np.linalg.svd(spread)[2][0]
    else:
        way = level_T_link[:3, :3].T @ np.array([0.0, 1.0, 0.0])
    way = way - ahead * (way @ ahead)
    if np.linalg.norm(way) < 0.3:
        way = np.eye(3)[int(np.argmin(np.abs(ahead)))]
        way = way - ahead * (way @ ahead)
    return np.asarray(way / np.linalg.norm(way))
