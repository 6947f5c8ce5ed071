"""The sole of a leg: the lowest face of its foot, with the joints at zero and the base level."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from kinematics.arrays import Array
from kinematics.geometry import poses
from tools.robot_data.drafting.anatomy import Anatomy

_FACE_M = 0.015
"""Corners that are this near to the lowest belong to the face that stands."""
_EDGE_M = 0.005
"""What the rectangle keeps from the face's edge: soles are round there."""
_LEAST_M = 0.02


@dataclass(frozen=True, slots=True)
class SolePlace:
    """A sole.

    Attributes:
        link: The foot's link.
        link_T_sole: Its frame, z up when flat, x towards the toes, shape (4, 4); below the ankle.
        x_m, y_m: The rectangle that carries, in that frame.
    """

    link: str
    link_T_sole: Array
    x_m: tuple[float, float]
    y_m: tuple[float, float]


def sole_of(anatomy: Anatomy, leg: tuple[str, ...]) -> SolePlace:
    """The sole of a leg.

    Raises:
        ValueError: Its foot has no shape.
    """
    link = anatomy.joints[leg[-1]].link
    points = anatomy.points(leg[-1])
    if not len(points):
        points = anatomy.all_points(anatomy.subtree(leg[-1]))
    if not len(points):
        raise ValueError(f"the foot {link!r} has no shape to stand on")
    level_T_link = anatomy.frame(link)
    ankle = level_T_link[:3, 3]
    lowest = float(points[:, 2].min())
    face = points[points[:, 2] < lowest + _FACE_M][:, :2] - ankle[:2]
    low, high = face.min(axis=0) + _EDGE_M, face.max(axis=0) - _EDGE_M
    middle = 0.5 * (low + high)
    half = np.maximum(0.5 * (high - low), _LEAST_M)
    backwards = middle[0] < 0.0 and abs(low[0]) > 1.5 * abs(high[0])  # toes point along -x
    turn = poses.rotation_z(np.pi) if backwards else np.eye(3)
    sign = -1.0 if backwards else 1.0
    level_T_sole = poses.transform(turn, [ankle[0], ankle[1], lowest])
    centre = sign * middle
    return SolePlace(
        link,
        poses.inverse(level_T_link) @ level_T_sole,
        (float(centre[0] - half[0]), float(centre[0] + half[0])),
        (float(centre[1] - half[1]), float(centre[1] + half[1])),
    )
