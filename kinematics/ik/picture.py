"""What a camera has in its picture."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array
from kinematics.geometry import poses

# A point nearer to the edge of the picture than this share may be cut off.
IN_PICTURE = 0.9


def in_picture(
    points: Array, world_T_camera: poses.Transform, horizontal_rad: float, vertical_rad: float
) -> NDArray[np.bool_]:
    """Which points, shape (n, 3), a camera has well inside its picture."""
    x, y, z = world_T_camera[:3, :3].T @ (points - world_T_camera[:3, 3]).T
    wide, high = IN_PICTURE * np.tan([0.5 * horizontal_rad, 0.5 * vertical_rad])
    return np.asarray((z > 0.0) & (np.abs(x) <= wide * z) & (np.abs(y) <= high * z), dtype=np.bool_)
