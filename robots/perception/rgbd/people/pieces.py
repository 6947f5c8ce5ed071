"""What stands or lies on the floor, cut where depth jumps: at half the picture's resolution."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array, InFloat64
from robots.perception.rgbd.cloud import Cloud, depth_jumps

EVERY = 2
_FLOOR_M, _FLOOR_SIGMAS = 0.07, 2.0
_TALLEST_M, _FARTHEST_M = 2.4, 6.0
JUMP_M, JUMP_SIGMAS = 0.06, 6.0
_LEAST_AREA_M2 = 0.004
_LEAST_PIXELS = 12
_MOST = 80


@dataclass(frozen=True, slots=True)
class Piece(InFloat64):
    """Neighbouring pixels without a jump of depth.

    Attributes:
        number: In ``Pieces.labels``.
        points: In the odometry frame, shape (n, 3).
        rows, columns: Of each, at half the picture's resolution.
        area_m2: As seen.
        depth_m: Median.
    """

    number: int
    points: Array
    rows: NDArray[np.int64]
    columns: NDArray[np.int64]
    area_m2: float
    depth_m: float

    @property
    def top_m(self) -> float:
        """Height of its upper end."""
        return float(np.quantile(self.points[:, 2], 0.995))


@dataclass(frozen=True, slots=True)
class Pieces(InFloat64):
    """All pieces of a picture, the largest first, and which pixel belongs to which."""

    labels: NDArray[np.int32]
    all: tuple[Piece, ...]


def pieces_of(cloud: Cloud) -> Pieces:
    """Cut a cloud."""
    part = (slice(None, None, EVERY), slice(None, None, EVERY))
    depth, z, sigma = cloud.depth_m[part], cloud.z[part], cloud.sigma_m[part]
    there = cloud.there[part] & (depth < np.float32(_FARTHEST_M))
    mask = there & (z > np.float32(_FLOOR_M) + np.float32(_FLOOR_SIGMAS) * np.float32(0.4) * sigma)
    mask &= z < np.float32(_TALLEST_M)
    smooth = cv2.medianBlur(depth, 3)
    mask &= (smooth > 0.0) & ~depth_jumps(smooth, sigma, JUMP_M, JUMP_SIGMAS)
    _, labels, stats, _ = cv2.connectedComponentsWithStats(mask.astype(np.uint8), connectivity=4)
    order = np.argsort(-stats[1:, cv2.CC_STAT_AREA], kind="stable")[:_MOST] + 1
    order = order[stats[order, cv2.CC_STAT_AREA] >= _LEAST_PIXELS]
    focal = cloud.picture.camera.focal_px / EVERY
    found = []
    for number in order.tolist():
        left, top, wide, tall = stats[number, :4].tolist()
        rows, columns = np.nonzero(labels[top : top + tall, left : left + wide] == number)
        rows, columns = rows + top, columns + left
        median = float(np.median(depth[rows, columns]))
        area = len(rows) * (median / focal) ** 2
        if area < _LEAST_AREA_M2:
            continue
        r, c = rows * EVERY, columns * EVERY
        points = np.column_stack([cloud.x[r, c], cloud.y[r, c], cloud.z[r, c]]).astype(np.float64)
        found.append(Piece(number, points, rows, columns, area, median))
    return Pieces(labels.astype(np.int32), tuple(found))
