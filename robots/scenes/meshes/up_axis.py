"""Directions of a mesh that may be up, by name."""

from __future__ import annotations

import math

import numpy as np

from kinematics.arrays import Array

Up = tuple[float, float, float]
"""A direction of a mesh, of any length but 0."""

UP_AXES: dict[str, Up] = {
    "+z": (0.0, 0.0, 1.0),
    "+y": (0.0, 1.0, 0.0),
    "+x": (1.0, 0.0, 0.0),
    "-z": (0.0, 0.0, -1.0),
    "-y": (0.0, -1.0, 0.0),
    "-x": (-1.0, 0.0, 0.0),
}
_SAME = 1e-6


def name_of(up: Up) -> str | list[float]:
    """How a file says it: by the axis's name, or as numbers."""
    length = math.hypot(*up)
    for name, axis in UP_AXES.items():
        if math.dist(axis, [value / length for value in up]) < _SAME:
            return name
    return [value / length for value in up]


def upright(up: Up) -> Array:
    """The rotation that brings a direction to z by the shortest way; half a turn is about x."""
    z = np.array(up) / math.hypot(*up)
    axis, cosine = np.cross(z, (0.0, 0.0, 1.0)), float(z[2])
    if cosine < _SAME - 1.0:
        return np.diag([1.0, -1.0, -1.0])
    skew = np.array([[0.0, -axis[2], axis[1]], [axis[2], 0.0, -axis[0]], [-axis[1], axis[0], 0.0]])
    return np.asarray(np.eye(3) + skew + skew @ skew / (1.0 + cosine))
