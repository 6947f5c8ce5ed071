"""Points on a solid's surface with their outward normals, to ask how much of it is in sight."""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np

from kinematics.arrays import Array
from kinematics.geometry.shapes import Ball, Box, Cylinder, Shape

# Slightly above the surface, so that a ray that grazes the solid's own edge is not lost to rounding.
_LIFT_M = 1e-4
# A face that is larger is often seen only in part, between other things.
_LARGE_M = 0.3
# Points of what is made of parts.
_OF_PARTS = 80


@lru_cache(maxsize=256)
def surface_points(shape: Shape) -> tuple[Array, Array]:
    """Sample a solid's surface, spread evenly enough for shares of sight.

    Returns:
        Points in the solid's own frame, m, and unit outward normals; shape (n, 3) each, read-only.
    """
    if shape.parts is not None and len(shape.parts.surface):
        # they are there in no order
        points, normals = shape.parts.surface[:_OF_PARTS], shape.parts.normals[:_OF_PARTS]
    elif isinstance(shape, Box):
        points, normals = _box(np.array(shape.size_m))
    elif isinstance(shape, Cylinder):
        points, normals = _cylinder(shape.radius_m, shape.height_m)
    else:
        points, normals = _ball(shape)
    points = points + _LIFT_M * normals
    points.flags.writeable = normals.flags.writeable = False
    return points, normals


def _box(size: Array) -> tuple[Array, Array]:
    steps = [np.linspace(-0.45, 0.45, 3 if edge < _LARGE_M else 7) for edge in size]
    points, normals = [], []
    for axis in range(3):
        others = [i for i in range(3) if i != axis]
        for side in (-1.0, 1.0):
            for a in steps[others[0]]:
                for b in steps[others[1]]:
                    point = np.zeros(3)
                    point[axis], point[others[0]], point[others[1]] = 0.5 * side, a, b
                    normal = np.zeros(3)
                    normal[axis] = side
                    points.append(point * size)
                    normals.append(normal)
    return np.array(points), np.array(normals)


def _cylinder(radius: float, height: float) -> tuple[Array, Array]:
    points, normals = [], []
    for level, z in enumerate((-0.4, 0.0, 0.4)):
        for k in range(12):
            angle = 2.0 * math.pi * (k + 0.5 * (level % 2)) / 12
            normal = np.array([math.cos(angle), math.sin(angle), 0.0])
            points.append(radius * normal + (0.0, 0.0, z * height))
            normals.append(normal)
    for side in (-1.0, 1.0):
        for k in range(4):
            angle = 0.5 * math.pi * k
            points.append(
                np.array(
                    [0.6 * radius * math.cos(angle), 0.6 * radius * math.sin(angle), 0.5 * side * height]
                )
            )
            normals.append(np.array([0.0, 0.0, side]))
    return np.array(points), np.array(normals)


def _ball(shape: Ball) -> tuple[Array, Array]:
    """Fibonacci lattice."""
    n = 40
    k = np.arange(n) + 0.5
    z = 1.0 - 2.0 * k / n
    around = math.pi * (1.0 + math.sqrt(5.0)) * k
    ring = np.sqrt(1.0 - z * z)
    normals = np.column_stack([ring * np.cos(around), ring * np.sin(around), z])
    return shape.radius_m * normals, normals
