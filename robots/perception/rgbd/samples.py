"""What is measured of each piece of a picture: points on its surface, and rays that graze its outline."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array, InFloat64
from robots.perception.rgbd.cloud import Cloud, rays_through
from robots.perception.rgbd.picture import Mask, Window, window_of
from robots.perception.rgbd.segments import Segments

POINTS = 260
RAYS = 90
_GROUND_M = 0.015
"""Rays to an outline lower than this may graze the ground beside the thing instead."""
_BEYOND_PX = 4
"""So far outside an outline the background has come back again."""
_BEHIND_M = 0.010
_UP = (-1, 0)
"""Of a step from row to row and from column to column, in a picture that is upright."""


@dataclass(frozen=True, slots=True)
class Samples(InFloat64):
    """Measurements of k pieces, each in a frame with its origin on the surface below its middle.

    Attributes:
        points: On surfaces, shape (k, n, 3); ``weight`` is 0 for those that only fill up.
        sigma_m: Of the points, shape (k, n).
        weight: Shape (k, n).
        rays: Unit directions of rays that graze an outline, shape (k, m, 3).
        reach_m: How far along a ray the piece is, about, shape (k, m).
        ray_sigma_m: How far a ray may miss the outline, shape (k, m); ``ray_weight`` as for points.
        ray_weight: Shape (k, m).
        eye: Where the rays begin, shape (k, 3).
        origin: The frame's origin in the odometry frame, shape (k, 3).
        pixels: How many each piece has, shape (k,).
        boxes: First column and row, and those after the last, shape (k, 4).
        cut: Share of a piece's outline that ends behind something nearer.
        border: Share of it that ends where nothing is measured: at the edge of the picture, or where it is
            too near for the camera.
        topless: Share of its upper ends that end so: its top is out of sight where that is most of them.
    """

    points: Array
    sigma_m: Array
    weight: Array
    rays: Array
    reach_m: Array
    ray_sigma_m: Array
    ray_weight: Array
    eye: Array
    origin: Array
    pixels: NDArray[np.int64]
    boxes: NDArray[np.int64]
    cut: Array
    border: Array
    topless: Array

    def only(self, which: NDArray[np.bool_]) -> Samples:
        """Of some pieces alone; ``which`` has shape (k,)."""
        return Samples(*(getattr(self, part.name)[which] for part in fields(self)))


def sample(cloud: Cloud, segments: Segments, ground_m: Array) -> Samples:
    """Gather what is measured of each piece.

    Args:
        cloud: The points.
        segments: The pieces.
        ground_m: Height of what each stands on, shape (k,).
    """
    count = segments.count
    window = window_of(segments.labels > 0, 1)
    rows, columns = _shown(segments.labels[window] > 0, window)
    which = (segments.labels[rows, columns] - 1).astype(np.uint16)
    order = np.argsort(which, kind="stable")
    rows, columns, which = rows[order], columns[order], which[order]
    first, pixels, pick, weight = _picked(which, count, POINTS)
    r, c = rows[pick], columns[pick]
    points = np.stack([cloud.x[r, c], cloud.y[r, c], cloud.z[r, c]], axis=-1).astype(np.float64)
    origin = _origins(points, weight, ground_m)
    boxes = np.stack(
        [
            np.minimum.reduceat(columns, first),
            np.minimum.reduceat(rows, first),
            np.maximum.reduceat(columns, first) + 1,
            np.maximum.reduceat(rows, first) + 1,
        ],
        axis=-1,
    ).astype(np.int64)
    u, v, owner, cut, border, topless = _outline(cloud, segments, ground_m, window)
    eye = cloud.odom_T_camera[:3, 3]
    _, _, ray_pick, ray_weight = _picked(owner, count, RAYS)
    if not len(u):  # no outline is in sight
        u = v = np.zeros(1, np.float32)
    ray_u, ray_v = u[ray_pick], v[ray_pick]
    rays = rays_through(cloud.picture, cloud.odom_T_camera, ray_u.ravel(), ray_v.ravel()).reshape(
        count, RAYS, 3
    )
    length = np.linalg.norm(rays, axis=2, keepdims=True)
    away = np.linalg.norm(origin - eye, axis=1)[:, None]
    return Samples(
        points=points - origin[:, None],
        sigma_m=cloud.sigma_m[r, c].astype(np.float64),
        weight=weight,
        rays=rays / length,
        reach_m=np.broadcast_to(away, ray_weight.shape).copy(),
        ray_sigma_m=np.broadcast_to(
            0.0005 + 0.7 * away / cloud.picture.camera.focal_px, ray_weight.shape
        ).copy(),
        ray_weight=ray_weight,
        eye=eye[None] - origin,
        origin=origin,
        pixels=pixels,
        boxes=boxes,
        cut=cut,
        border=border,
        topless=topless,
    )


def _picked(
    which: NDArray[np.integer[Any]], count: int, most: int
) -> tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.int64], Array]:
    """Of sorted owners: where each begins, how many it has, evenly spread ones of each, and their weights."""
    numbers = np.arange(count)
    first = np.searchsorted(which, numbers)
    pixels = np.searchsorted(which, numbers, side="right") - first
    steps = (np.arange(most) + 0.5) / most
    within = np.where(
        pixels[:, None] >= most, np.floor(steps[None] * pixels[:, None]), np.arange(most)[None]
    ).astype(np.int64)
    weight = (within < pixels[:, None]).astype(np.float64)
    within = np.minimum(within, np.maximum(pixels[:, None] - 1, 0))
    pick = np.clip(first[:, None] + within, 0, max(len(which) - 1, 0))
    return first, pixels, pick, weight


def _origins(points: Array, weight: Array, ground_m: Array) -> Array:
    total = np.maximum(weight.sum(axis=1), 1.0)
    middle: Array = (points * weight[..., None]).sum(axis=1) / total[:, None]
    middle[:, 2] = ground_m
    return middle


def _shown(mask: Mask, window: Window) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Rows and columns of a picture that a mask of a part of it shows."""
    rows, columns = np.nonzero(mask)
    return rows + window[0].start, columns + window[1].start


def _outline(
    cloud: Cloud, segments: Segments, ground_m: Array, window: Window
) -> tuple[NDArray[np.float32], NDArray[np.float32], NDArray[np.int64], Array, Array, Array]:
    """Between which pixels an outline runs that is a thing's own, with its owner, sorted by owner.

    Where a thing meets the ground it has none.
    And the shares of each one's outline that end behind something, and at the border, and of its upper ends.
    """
    labels, depth = segments.labels, cloud.depth_m
    lost = (depth <= 0.0).astype(np.int32)
    us, vs, owners, own, hidden, outside, heights = [], [], [], [], [], [], []
    rows, columns = labels.shape
    part = labels[window]
    for dy, dx in ((0, 1), (0, -1), (1, 0), _UP):
        here_y, here_x = _shown((part > 0) & (_shifted(part, dy, dx) != part), window)
        out_y, out_x = here_y + _BEYOND_PX * dy, here_x + _BEYOND_PX * dx
        within = (out_y >= 0) & (out_y < rows) & (out_x >= 0) & (out_x < columns)
        oy, ox = np.clip(out_y, 0, rows - 1), np.clip(out_x, 0, columns - 1)
        whose, shown, beyond = labels[here_y, here_x], depth[here_y, here_x], depth[oy, ox]
        apart = within & (labels[oy, ox] != whose)
        own.append(apart & (beyond > shown + np.float32(_BEHIND_M)))
        hidden.append(apart & (beyond > 0.0) & (beyond < shown - np.float32(_BEHIND_M)))
        # returns are missing on both sides of an edge: it is in the middle of the gap
        gap, still = np.zeros(len(here_y), np.float32), np.ones(len(here_y), np.int32)
        for step in range(1, _BEYOND_PX):
            gy, gx = np.clip(here_y + step * dy, 0, rows - 1), np.clip(here_x + step * dx, 0, columns - 1)
            still = still * lost[gy, gx]
            gap += still
        far_y, far_x = (
            np.clip(out_y + _BEYOND_PX * dy, 0, rows - 1),
            np.clip(out_x + _BEYOND_PX * dx, 0, columns - 1),
        )
        outside.append(~within | ((still > 0) & (beyond <= 0.0) & (depth[far_y, far_x] <= 0.0)))
        us.append(here_x + dx * (np.float32(0.5) + np.float32(0.5) * gap))
        vs.append(here_y + dy * (np.float32(0.5) + np.float32(0.5) * gap))
        heights.append(cloud.z[here_y, here_x])
        owners.append(whose - 1)
    u, v = np.concatenate(us).astype(np.float32), np.concatenate(vs).astype(np.float32)
    owner = np.concatenate(owners).astype(np.int64)
    low = np.concatenate(heights)
    count = segments.count
    total = np.maximum(np.bincount(owner, minlength=count), 1)
    cut, border = (
        np.bincount(owner, np.concatenate(some).astype(np.float64), minlength=count)[:count] / total[:count]
        for some in (hidden, outside)
    )
    upper = np.maximum(np.bincount(owners[-1], minlength=count), 1)
    topless = np.bincount(owners[-1], outside[-1].astype(np.float64), minlength=count)[:count] / upper[:count]
    keep = np.concatenate(own) & (low > ground_m[owner] + _GROUND_M)
    u, v, owner = u[keep], v[keep], owner[keep]
    order = np.argsort(owner, kind="stable")
    return u[order], v[order], owner[order], cut, border, topless


def _shifted(image: NDArray[np.int32], dy: int, dx: int) -> NDArray[np.int32]:
    """The image as seen from pixels that are a step further; what is at its edges stays."""
    padded = np.pad(image, 1, mode="constant")
    rows, columns = image.shape
    return padded[1 + dy : 1 + dy + rows, 1 + dx : 1 + dx + columns]
