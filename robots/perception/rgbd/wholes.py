"""Puts together what colour alone has cut apart: a lid and its can, the bands of a printed box."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from robots.perception.rgbd.cloud import Cloud
from robots.perception.rgbd.picture import window_of
from robots.perception.rgbd.segments import JUMP_M, Segments

_FLOATS_M = 0.02
"""A piece whose lowest point is higher than this above the ground stands on another, or is a part of it."""
_ROOM_M = 0.006
_WITHIN = 0.85
_MOST_POINTS = 250


def with_wholes(cloud: Cloud, segments: Segments, ground_m: float) -> Segments:
    """Join each piece that does not reach the ground to the one below, where that is no wider.

    What stands on something wider leaves a ledge free, and stays a thing of its own.

    Args:
        cloud: The points.
        segments: Pieces on one surface.
        ground_m: Height of the surface.
    """
    pairs = _neighbours(cloud, segments)
    if not pairs:
        return segments
    pieces = sorted({k for pair in pairs for k in pair})
    grounds, lows, tops = {}, {}, {}
    for k in pieces:
        rows, columns = np.nonzero(segments.labels == k)
        step = max(1, len(rows) // _MOST_POINTS)
        z = cloud.z[rows, columns]
        lows[k], tops[k] = (float(value) - ground_m for value in np.quantile(z, (0.02, 0.98)))
        rows, columns = rows[::step], columns[::step]
        grounds[k] = np.column_stack([cloud.x[rows, columns], cloud.y[rows, columns]])
    parent = np.arange(segments.count + 1)
    for a, b in sorted(pairs):
        upper, lower = (a, b) if lows[a] + tops[a] >= lows[b] + tops[b] else (b, a)
        if lows[upper] < _FLOATS_M or lows[lower] > lows[upper]:
            continue
        if _within(grounds[lower], grounds[upper]) > _WITHIN:
            first, second = sorted((_root(parent, a), _root(parent, b)))
            parent[second] = first
    roots = np.array([_root(parent, k) for k in range(segments.count + 1)])
    kept, renamed = np.unique(roots, return_inverse=True)
    return Segments(renamed.astype(np.int32)[segments.labels], len(kept) - 1)


def _neighbours(cloud: Cloud, segments: Segments) -> set[tuple[int, int]]:
    """Pieces that lie side by side in the picture, with no jump of depth between them."""
    window = window_of(segments.labels > 0, 0)
    labels, depth = segments.labels[window], cloud.depth_m[window]
    found: set[tuple[int, int]] = set()
    for axis, beyond in ((0, 1), (0, 3), (1, 1), (1, 3)):
        here = (slice(None, -beyond), slice(None)) if axis == 0 else (slice(None), slice(None, -beyond))
        there = (slice(beyond, None), slice(None)) if axis == 0 else (slice(None), slice(beyond, None))
        a, b = labels[here], labels[there]
        apart = (a != b) & (a > 0) & (b > 0)
        if not apart.any():
            continue
        step = np.abs(depth[here][apart] - depth[there][apart])
        close = step < np.float32(JUMP_M)
        both = np.sort(np.column_stack([a[apart][close], b[apart][close]]), axis=1)
        pairs, counts = np.unique(both, axis=0, return_counts=True)
        found |= {(int(i), int(k)) for (i, k), count in zip(pairs, counts, strict=True) if count >= 4}
    return found


def _within(points: NDArray[np.float32], around: NDArray[np.float32]) -> float:
    """The share of some places that lie over the ground of others."""
    hull = cv2.convexHull(around)
    inside = [cv2.pointPolygonTest(hull, (float(x), float(y)), True) > -_ROOM_M for x, y in points[::3]]
    return float(np.mean(inside))


def _root(parent: NDArray[np.int64], k: int) -> int:
    while parent[k] != k:
        k = int(parent[k])
    return k
