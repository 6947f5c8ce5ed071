"""The convex hull of a mesh file, of every kind that planner and checker read (COLLADA too)."""

from __future__ import annotations

import coal
import numpy as np

from kinematics.arrays import Array


def hull_corners(file: str) -> Array:
    """Corners of a mesh's convex hull, m, shape (n, 3), not scaled.

    Args:
        file: Its path.

    Raises:
        ValueError: The file cannot be read, or encloses no volume.
    """
    solid = coal.MeshLoader().load(file, np.ones(3))
    solid.buildConvexHull(True, "Qt")
    return np.array(solid.convex.points(), dtype=np.float64)
