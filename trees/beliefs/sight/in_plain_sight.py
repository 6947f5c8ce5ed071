"""Whether a look would have shown a thing that is believed to stand somewhere."""

from __future__ import annotations

import math
from collections.abc import Iterable

import numpy as np

from kinematics.geometry.shapes import Box
from kinematics.model.camera_description import CameraDescription
from kinematics.scene.line_of_sight import hidden
from kinematics.scene.planning_scene import SceneObject
from kinematics.scene.support_of import half_height_m
from trees.beliefs.sight.sight import Glimpse

_UP = (-0.5, 0.0, 0.8)
_ACROSS = (-0.8, 0.0, 0.8)
"""Where a thing is looked at, as shares of its half height and of its radius across the line of sight."""
_SHARE = 0.75
"""A camera tells a thing by a quarter of it; what is believed is off by a few millimetres, and so is this."""


def in_plain_sight(
    item: SceneObject,
    glimpse: Glimpse,
    camera: CameraDescription,
    others: Iterable[SceneObject],
    within_m: float,
) -> bool:
    """Tell whether three quarters of a thing were in the picture, with nothing before them.

    What was in sight by less may have been missed: it is cut off by the picture's edge, or stands behind
    something else.

    Args:
        item: The thing, odometry frame.
        glimpse: The look.
        camera: Field of view and range.
        others: Everything that may stand before it; the thing itself is left out.
        within_m: A line of sight that passes a part of the robot nearer than this may be blocked.
    """
    middle, eye = item.world_T_object[:3, 3], glimpse.odom_T_camera[:3, 3]
    if not glimpse.shows(camera, middle, within_m):
        return False
    way = middle - eye
    across = np.array([-way[1], way[0], 0.0]) / max(math.hypot(way[0], way[1]), 1e-9)
    up = np.array([0.0, 0.0, half_height_m(item)])
    points = np.array([middle + a * _radius_m(item) * across + b * up for a in _ACROSS for b in _UP])
    shown = np.array([glimpse.shows(camera, point, within_m) for point in points])
    shown &= ~hidden(eye, points, [other for other in others if other.name != item.name])
    return bool(np.count_nonzero(shown) >= _SHARE * len(points))


def _radius_m(item: SceneObject) -> float:
    shape = item.shape
    return 0.5 * min(shape.size_m[:2]) if isinstance(shape, Box) else shape.radius_m
