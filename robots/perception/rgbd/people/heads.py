"""Finds heads: discs as large as heads that are free on all sides but that of the neck."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import cv2
import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array, InFloat64
from robots.perception.rgbd.cloud import Cloud
from robots.perception.rgbd.people.pieces import EVERY, Piece

HEAD_M = 0.11
"""Radius."""
_CELL_M, _ROOM = 0.015, 20
_BESIDE_AN_ARM = 0.77
"""What a disc that is free on one side counts, beside one that is free on both."""
_LEAST_FIT = 0.60
_LEAST_BULGE_M = 0.02
_ROUND_M, _BEFORE_M = 0.022, 0.04
_CANDIDATES, _LIKE = 8, 0.4
"""What hair and a face count beside the fit of the disc."""


@dataclass(frozen=True, slots=True)
class Head(InFloat64):
    """A head.

    Attributes:
        middle: In the odometry frame, shape (3,).
        row, column: Of its middle in the whole picture.
        radius_px: In the whole picture.
        fit: How well the disc fits, 1 at best.
    """

    middle: Array
    row: float
    column: float
    radius_px: float
    fit: float


def find_head(cloud: Cloud, piece: Piece) -> Head | None:
    """The head of a piece that may be somebody upright, or None.

    Args:
        cloud: The points.
        piece: What may be somebody.
    """
    focal = cloud.picture.camera.focal_px
    scale = piece.depth_m / (focal / EVERY) / _CELL_M
    top, left = int(piece.rows.min()), int(piece.columns.min())
    tall, wide = int(piece.rows.max()) - top + 1, int(piece.columns.max()) - left + 1
    size = max(round(wide * scale), 3), max(round(tall * scale), 3)
    if max(size) > 400:
        return None
    mask = np.zeros((tall, wide), np.uint8)
    mask[piece.rows - top, piece.columns - left] = 255
    mask = cv2.morphologyEx(mask, cv2.MORPH_CLOSE, np.ones((3, 3), np.uint8))
    image = cv2.resize(mask, size, interpolation=cv2.INTER_AREA).astype(np.float32) / np.float32(255.0)
    image = _with_room(image, piece, cloud)
    best = np.max([cv2.filter2D(image, -1, template) for template in _templates()], axis=0)
    found: list[tuple[float, Head]] = []
    for _ in range(_CANDIDATES):
        y, x = np.unravel_index(int(best.argmax()), best.shape)
        fit = float(best[y, x])
        if fit < _LEAST_FIT:
            break
        head = _measured(cloud, piece, top + (y - _ROOM) / scale, left + (x - _ROOM) / scale, fit)
        if head is not None:
            found.append((fit + _LIKE * min(facing(cloud, head, 255.0)[1], 0.5), head))
        cv2.circle(best, (int(x), int(y)), 4, -1.0, -1)
    return max(found, key=lambda one: one[0])[1] if found else None


def _with_room(image: NDArray[np.float32], piece: Piece, cloud: Cloud) -> NDArray[np.float32]:
    """With free cells all around, but where the picture ends: there it goes on as it is at the edge.

    What the picture cuts off above the chest is no head that is free on all sides.
    """
    last = (np.array(cloud.depth_m.shape) - 1) // EVERY
    rows, columns = piece.rows, piece.columns
    sides = (rows.min() <= 0, rows.max() >= last[0], columns.min() <= 0, columns.max() >= last[1])
    for side, is_cut in enumerate(sides):
        above, below, left, right = (_ROOM if k == side else 0 for k in range(4))
        kind = cv2.BORDER_REPLICATE if is_cut else cv2.BORDER_CONSTANT
        wider = cv2.copyMakeBorder(image, above, below, left, right, kind, value=0.0)
        image = np.asarray(wider, np.float32)
    return image


def _measured(cloud: Cloud, piece: Piece, row: float, column: float, fit: float) -> Head | None:
    """Where a disc is in space, if it bulges as a head does."""
    focal = cloud.picture.camera.focal_px / EVERY
    away = np.hypot(piece.rows - row, piece.columns - column)
    radius = HEAD_M * focal / piece.depth_m
    inner, rim = away < 0.45 * radius, (away > 0.75 * radius) & (away < 1.05 * radius)
    if inner.sum() < 6 or rim.sum() < 6:
        return None
    forward = cloud.odom_T_camera[:3, 2]
    eye = cloud.odom_T_camera[:3, 3]
    along = (piece.points - eye) @ forward
    front = float(np.median(along[inner]))
    # what is nearer than a head's middle is an arm before it
    rim &= along > front - _BEFORE_M
    if rim.sum() < 6 or float(np.median(along[rim])) - front < _LEAST_BULGE_M:
        return None
    across, down = cloud.picture.rays()
    r = float(np.interp(row * EVERY, np.arange(len(down)), down))
    c = float(np.interp(column * EVERY, np.arange(len(across)), across))
    middle = eye + cloud.odom_T_camera[:3, :3] @ (np.array([c, r, 1.0]) * (front + 0.92 * HEAD_M))
    radius_px = HEAD_M * cloud.picture.camera.focal_px / (front + HEAD_M)
    # the points of a head are at its radius from its middle, those of a board are not
    own = (away < 0.9 * radius) & (along > front - _BEFORE_M)
    off = np.linalg.norm(piece.points[own] - middle, axis=1) - HEAD_M
    errors = cloud.picture.camera.errors
    if float(np.median(np.abs(off))) > _ROUND_M + 1.2 * errors.depth_sigma_m(front):
        return None
    return Head(middle, row * EVERY, column * EVERY, radius_px, fit)


@lru_cache(maxsize=1)
def _templates() -> tuple[NDArray[np.float32], ...]:
    """Discs of weight 1, with a free ring of weight -1 but where the neck is, or a raised arm as well."""
    reach = round(1.6 * HEAD_M / _CELL_M)
    rows, columns = np.mgrid[-reach : reach + 1, -reach : reach + 1]
    away = np.hypot(rows, columns) * _CELL_M / HEAD_M
    towards_neck = np.abs(np.arctan2(columns, rows)) < np.radians(62.0)
    disc = (away < 0.95).astype(np.float32)
    ring = (away > 1.22) & (away < 1.55) & ~towards_neck
    made = []
    for side, least in ((0, 1.0), (1, _BESIDE_AN_ARM), (-1, _BESIDE_AN_ARM)):
        free = (ring & (side * columns * _CELL_M < 0.3 * HEAD_M)).astype(np.float32)
        made.append((least * (disc / disc.sum() - free / free.sum())).astype(np.float32))
    return tuple(made)


def facing(cloud: Cloud, head: Head, white: float) -> tuple[float | None, float]:
    """Where a head faces, in the odometry frame, rad, None where that cannot be told; and how sure that is.

    Hair is darker than a face, and covers the back and the top of a head.

    Args:
        cloud: The points.
        head: The head.
        white: How bright a thing is in the picture that reflects everything, in [0, 255].

    Returns:
        The second is the share of what is seen of the disc that a face between hair explains, in [0, 1].
    """
    color = cloud.picture.color
    reach = max(round(0.92 * head.radius_px), 2)
    row, column = round(head.row), round(head.column)
    every = max(reach // _FINE, 1)
    rows, columns = np.mgrid[
        row - reach : row + reach + 1 : every, column - reach : column + reach + 1 : every
    ]
    across, down = (columns - head.column) / head.radius_px, (rows - head.row) / head.radius_px
    inside = across**2 + down**2 < 0.85
    inside &= (rows >= 0) & (rows < color.shape[0]) & (columns >= 0) & (columns < color.shape[1])
    rows, columns, across, down = rows[inside], columns[inside], across[inside], down[inside]
    if len(rows) < 20:
        return None, 0.0
    wide = max(int(0.25 * head.radius_px), 1)
    low, high = max(int(rows.min()) - wide, 0), int(rows.max()) + wide + 1
    left, right = max(int(columns.min()) - wide, 0), int(columns.max()) + wide + 1
    patch = cv2.blur(color[low:high, left:right], (wide, wide))
    bright = patch[rows - low, columns - left].astype(np.float64).max(axis=1)
    near = -np.sqrt(np.maximum(1.0 - across**2 - down**2, 0.0))
    ray = head.middle - cloud.odom_T_camera[:3, 3]
    # axes across the line of sight to this head
    ahead = ray / np.linalg.norm(ray)
    sideways = np.cross(ahead, (0.0, 0.0, 1.0))
    sideways /= np.linalg.norm(sideways)
    below = np.cross(ahead, sideways)
    normals = across[:, None] * sideways + down[:, None] * below + near[:, None] * ahead
    yaws = np.arange(72) * (2.0 * np.pi / 72)
    forward = np.column_stack([np.cos(yaws), np.sin(yaws)]) @ normals[:, :2].T
    face = (_FACE[0] * forward + _FACE[1] * normals[None, :, 2] > _FACE[2]).astype(np.float64)
    # brightness = a + b face, with b >= 0; what is left tells how well a yaw fits
    face -= face.mean(axis=1, keepdims=True)
    seen = bright - bright.mean()
    gain = face @ seen
    power = (face**2).sum(axis=1)
    explained = np.where(gain > 0.0, gain**2 / np.maximum(power, 1e-3 * len(seen)), 0.0)
    best = int(explained.argmax())
    share = float(explained[best] / max(float(seen @ seen), 1e-9))
    if share > _EXPLAINS:
        return float(yaws[best]), share
    # nothing but hair, or nothing but a face
    towards = float(np.arctan2(-ray[1], -ray[0]))
    return (towards + np.pi if float(np.median(bright)) < _HAIR * white else towards), share


_FINE = 14
"""Pixels from the middle of a disc to its rim that are enough to tell hair from a face."""
_EXPLAINS = 0.12
"""Share of the variance of brightness that a face at its likeliest place explains at least."""
_HAIR = 0.3
_FACE = (0.78, -0.63, 0.05)
"""Of a direction from the head's middle, ahead and up: it meets the face where the sum exceeds the last."""
