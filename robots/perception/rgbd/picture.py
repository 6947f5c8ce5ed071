"""A picture in colour and depth, with where it was taken from."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array, InFloat64
from kinematics.geometry.poses import Transform
from robots.interface.depth_camera import DepthCamera

Colors = NDArray[np.uint8]
Depths = NDArray[np.float32]
Mask = NDArray[np.bool_]


Window = tuple[slice, slice]
"""Some rows and columns."""


def window_of(mask: Mask, room_px: int) -> Window:
    """The rows and columns of a picture that show something, with some around; both begin at even ones."""
    left, top, wide, tall = cv2.boundingRect(mask.view(np.uint8))
    rows, columns = max(top - room_px, 0) // 2 * 2, max(left - room_px, 0) // 2 * 2
    return slice(rows, top + tall + room_px), slice(columns, left + wide + room_px)


@dataclass(frozen=True, slots=True)
class Picture(InFloat64):
    """One picture.

    Attributes:
        camera: What took it.
        color: Red, green, blue, shape (height, width, 3).
        depth_m: Depth along the optical axis, 0 where nothing came back, shape (height, width).
        own: Where the robot sees itself, from its encoders, shape (height, width).
        odom_T_camera: Where the robot believes the camera to have been, shape (4, 4); upright, because an IMU
            tells where up is.
        stamp_s: When it was taken.
    """

    camera: DepthCamera
    color: Colors
    depth_m: Depths
    own: Mask
    odom_T_camera: Transform
    stamp_s: float

    def rays(self) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
        """Tangents of the pixels: across of each column, down of each row; shape (width,) and (height,)."""
        height, width = self.depth_m.shape
        focal = self.camera.focal_px
        across = (np.arange(width, dtype=np.float32) - 0.5 * (width - 1)) / focal
        down = (np.arange(height, dtype=np.float32) - 0.5 * (height - 1)) / focal
        return across, down

    def pixels_of(self, camera_points: Array) -> Array:
        """Column and row of points in the camera's frame, shape (n, 3), as floats, shape (n, 2)."""
        height, width = self.depth_m.shape
        z = np.maximum(camera_points[:, 2], 1e-6)
        u = self.camera.focal_px * camera_points[:, 0] / z + 0.5 * (width - 1)
        v = self.camera.focal_px * camera_points[:, 1] / z + 0.5 * (height - 1)
        return np.column_stack([u, v])
