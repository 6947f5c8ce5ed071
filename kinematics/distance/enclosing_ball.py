"""A ball that holds some points, nearly the smallest."""

from __future__ import annotations

import numpy as np

from kinematics.arrays import Array
from kinematics.compiled.compiler import compiled

_STEPS = 200


def ball_centre(points: Array) -> Array:
    """Centre of a nearly smallest enclosing ball of points, shape (n, 3) (Badoiu and Clarkson, 2003)."""
    centre: Array = points.mean(axis=0)
    # a copy: to the compiler, what cannot be written is of another type
    _towards_farthest(np.array(points, np.float64, order="C"), centre)
    return centre


@compiled
def _towards_farthest(points: Array, centre: Array) -> None:
    for step in range(1, _STEPS):
        farthest, most = 0, -1.0
        for k in range(len(points)):
            x, y, z = points[k, 0] - centre[0], points[k, 1] - centre[1], points[k, 2] - centre[2]
            square = x * x + y * y + z * z
            if square > most:
                farthest, most = k, square
        for axis in range(3):
            centre[axis] += (points[farthest, axis] - centre[axis]) / (step + 1)
