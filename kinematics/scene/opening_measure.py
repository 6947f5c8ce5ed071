"""How far a door or drawer has been moved, from where the hand that holds its handle has been."""

from __future__ import annotations

import math

import numpy as np

from kinematics.arrays import Array
from kinematics.scene.opening_path import DoorArc, OpeningPath

_LONG_ENOUGH_M = 0.25
"""A shorter piece of an arc does not tell its centre."""
_OFF_M = 0.08
"""A fitted hinge farther than this from where it was believed is no hinge."""


def fitted_circle(points: Array) -> tuple[Array, float]:
    """Centre, shape (2,), and radius of the circle nearest to points, shape (n, 2), by Kasa's method."""
    rows = np.column_stack([2.0 * points, np.ones(len(points))])
    x, y, c = np.linalg.lstsq(rows, np.sum(points * points, axis=1), rcond=None)[0]
    return np.array([x, y]), math.sqrt(max(float(c + x * x + y * y), 0.0))


def moved_by(points: Array, path: OpeningPath) -> float:
    """How far the handle has been moved, signed as its path's opening, rad or m.

    Args:
        points: Where the TCP was, from the first to the last, shape (n, 3), m.
        path: What was believed of its way; a long arc is measured about its own centre instead.
    """
    first, last = points[0], points[-1]
    if not isinstance(path, DoorArc):
        return float((last - first) @ path.at(0.0).outward)
    centre = path.hinge_m
    if float(np.linalg.norm(last[:2] - first[:2])) >= _LONG_ENOUGH_M:
        found, _ = fitted_circle(points[:, :2])
        if float(np.linalg.norm(found - centre)) <= _OFF_M:
            centre = found
    a, b = first[:2] - centre, last[:2] - centre
    turned = math.atan2(float(a[0] * b[1] - a[1] * b[0]), float(a @ b))
    return -path.side * turned
