"""Cuts what stands on a surface into pieces that are one thing each."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import InFloat64
from robots.perception.rgbd.cloud import Cloud, depth_jumps
from robots.perception.rgbd.picture import Mask, Window, window_of
from robots.perception.rgbd.surfaces import Surface, inside

LEAST_ABOVE_M = 0.006
LEAST_SIGMAS = 2.5
TALLEST_M = 0.45
UNSEEN_M = 0.15
"""So far a surface may go on beyond the picture, where the top of what stands there is still in it."""
JUMP_M = 0.012
JUMP_SIGMAS = 6.0
LEAST_PIXELS = 60
TINT_CHANGE = 0.045
"""Of chromaticity, over four pixels of a smoothed picture: between two things that touch."""
_OVERLAP = 0.2
_ROUND_M = 0.05
_WITHIN = 0.8
_DISC_ROOM_M = 0.006
_MOST = 60
_ROOM_PX = 4
"""So much of a picture around what stands on something shows where it ends."""


@dataclass(frozen=True, slots=True)
class Segments(InFloat64):
    """Pieces of a picture.

    Attributes:
        labels: Number of the piece that each pixel belongs to, from 1 on; 0 is none; shape (height, width).
        count: How many there are.
    """

    labels: NDArray[np.int32]
    count: int


def above(cloud: Cloud, surface: Surface) -> Mask:
    """Pixels that show something on a surface."""
    height = cloud.z - np.float32(surface.height_m)
    least = np.maximum(np.float32(LEAST_ABOVE_M), np.float32(LEAST_SIGMAS) * cloud.sigma_m)
    candidates: Mask = cloud.there & (height > least) & (height < np.float32(TALLEST_M))
    x, y = cloud.x[candidates], cloud.y[candidates]
    over = inside(surface, x, y)
    beside = ~over
    beside[beside] = inside(surface, x[beside], y[beside], UNSEEN_M)
    over[beside] = _beyond_the_picture(cloud, x[beside], y[beside], surface.height_m)
    candidates[candidates] = over
    return candidates


def _beyond_the_picture(
    cloud: Cloud, x: NDArray[np.float32], y: NDArray[np.float32], z_m: float
) -> NDArray[np.bool_]:
    """Which places are not in the picture: who stands there hides no more of a surface than the edge does."""
    places = np.column_stack([x, y, np.full(len(x), z_m, np.float32)])
    camera = cloud.odom_T_camera
    pixels = cloud.picture.pixels_of((places - camera[:3, 3]) @ camera[:3, :3])
    rows, columns = cloud.depth_m.shape
    return np.asarray(
        (pixels[:, 0] < 0) | (pixels[:, 0] >= columns) | (pixels[:, 1] < 0) | (pixels[:, 1] >= rows)
    )


def segment(cloud: Cloud, mask: Mask, tint: NDArray[np.float32]) -> Segments:
    """Cut where depth jumps, and where the colour changes; join what stands on the same ground.

    Args:
        cloud: The points.
        mask: Which of them stand on something.
        tint: Smoothed chromaticity, shape (2, height / 2, width / 2).
    """
    window = window_of(mask, _ROOM_PX)
    cut = mask[window] & ~depth_jumps(cloud.depth_m[window], cloud.sigma_m[window], JUMP_M, JUMP_SIGMAS)
    number, labels, stats, _ = cv2.connectedComponentsWithStats(cut.astype(np.uint8), connectivity=4)
    changes = cut & _tint_changes(tint)[window]
    if changes.any():
        number, labels, stats = _split(cut, changes, labels, stats)
    large = [i for i in range(1, number) if stats[i, cv2.CC_STAT_AREA] >= LEAST_PIXELS]
    large = sorted(large, key=lambda i: -int(stats[i, cv2.CC_STAT_AREA]))[:_MOST]
    renamed = np.zeros(number, dtype=np.int32)
    for new, old in enumerate(large, start=1):
        renamed[old] = new
    joined = _joined(cloud, renamed[labels], len(large), tint, window)
    whole = np.zeros(mask.shape, dtype=np.int32)
    whole[window] = joined.labels
    return Segments(whole, joined.count)


def _tint_changes(tint: NDArray[np.float32]) -> Mask:
    changes = np.zeros(tint.shape[1:], np.bool_)
    least = np.float32(TINT_CHANGE)
    for shares in tint:
        changes[:, 1:-1] |= np.abs(shares[:, 2:] - shares[:, :-2]) > least
        changes[1:-1] |= np.abs(shares[2:] - shares[:-2]) > least
    return changes.repeat(2, axis=0).repeat(2, axis=1)


def _split(
    cut: Mask, changes: Mask, labels: NDArray[np.int32], stats: NDArray[np.int32]
) -> tuple[int, NDArray[np.int32], NDArray[np.int32]]:
    """Cut pieces along changes of colour, where both parts are large enough to be things of their own."""
    apart = (cut & ~changes).astype(np.uint8)
    number, finer, finer_stats, _ = cv2.connectedComponentsWithStats(apart, connectivity=4)
    whole = np.zeros(number, dtype=np.int32)
    inside_piece = finer > 0
    whole[finer[inside_piece]] = labels[inside_piece]
    share = finer_stats[:, cv2.CC_STAT_AREA] / np.maximum(stats[whole, cv2.CC_STAT_AREA], 1)
    counts = (finer_stats[:, cv2.CC_STAT_AREA] >= LEAST_PIXELS) & (share > 0.12)
    counts[0] = False
    several = np.bincount(whole[counts], minlength=len(stats)) > 1
    split = several[labels] & (labels > 0)
    if not split.any():
        return len(stats), labels, stats
    # what lies between two parts goes to the nearer one
    seeds = np.where(split & counts[finer], finer, 0)
    nearest = np.where(seeds > 0, np.uint8(0), np.uint8(1))
    _, index = cv2.distanceTransformWithLabels(nearest, cv2.DIST_L2, 3, labelType=cv2.DIST_LABEL_PIXEL)
    of_pixel = np.zeros(int(index.max()) + 1, dtype=np.int32)
    of_pixel[index[seeds > 0]] = seeds[seeds > 0]
    told = of_pixel[index]
    result = labels.copy()
    # a part never leaves the piece that it was cut from
    same = split & (whole[told] == labels)
    result[same] = len(stats) + told[same]
    result[split & ~same] = 0
    areas = np.bincount(result.ravel())
    names = np.flatnonzero(areas)
    renumbered = np.zeros(len(areas), dtype=np.int32)
    renumbered[names] = np.arange(len(names))
    made = np.zeros((len(names), 5), dtype=np.int32)
    made[:, cv2.CC_STAT_AREA] = areas[names]
    return len(names), renumbered[result], made


def _joined(
    cloud: Cloud, pieces: NDArray[np.int32], count: int, tint: NDArray[np.float32], window: Window
) -> Segments:
    """Join pieces over the same ground and of the same colour: the inside of a cup and its outside.

    Args:
        cloud: Of the whole picture.
        pieces: In a window of it.
        count: Of pieces.
        tint: Of the whole picture.
        window: Which part of it that is.
    """
    if count < 2:
        return Segments(pieces, count)
    rows, columns = np.nonzero(pieces > 0)
    which = pieces[rows, columns].astype(np.uint8)
    order = np.argsort(which, kind="stable")
    rows, columns, which = rows[order] + window[0].start, columns[order] + window[1].start, which[order]
    bounds = np.searchsorted(which, np.arange(1, count + 2))
    x, y = cloud.x[rows, columns], cloud.y[rows, columns]
    tints = tint[:, rows // 2, columns // 2].T
    hulls, middles, discs = [], [], []
    for k in range(count):
        part = slice(bounds[k], bounds[k + 1])
        step = max(1, (bounds[k + 1] - bounds[k]) // 300)
        ground = np.column_stack([x[part][::step], y[part][::step]])
        hulls.append(cv2.convexHull(ground))
        discs.append(_disc(ground, cloud.odom_T_camera[:2, 3]))
        middles.append(np.median(tints[part][::step], axis=0))
    areas = [max(float(cv2.contourArea(hull)), 1e-6) for hull in hulls]
    boxes = np.array([[*hull[:, 0].min(axis=0), *hull[:, 0].max(axis=0)] for hull in hulls])
    boxes[:, :2] -= _ROUND_M
    boxes[:, 2:] += _ROUND_M
    parent = list(range(count))

    def root(i: int) -> int:
        while parent[i] != i:
            i = parent[i]
        return i

    near = (boxes[:, None, :2] <= boxes[None, :, 2:]).all(axis=2)
    near &= near.T
    for i, j in np.argwhere(np.triu(near, 1)):
        if np.abs(middles[i] - middles[j]).max() > 2.0 * TINT_CHANGE:
            continue
        common, _ = cv2.intersectConvexConvex(hulls[i], hulls[j])
        if common > _OVERLAP * min(areas[i], areas[j]) or _one_within_the_other(hulls, discs, i, j):
            a, b = sorted((root(int(i)), root(int(j))))
            parent[b] = a
    roots = [root(i) for i in range(count)]
    kept = sorted(set(roots))
    renamed = np.zeros(count + 1, dtype=np.int32)
    for i, one in enumerate(roots):
        renamed[i + 1] = kept.index(one) + 1
    return Segments(renamed[pieces], len(kept))


def _disc(ground: NDArray[np.float32], eye: NDArray[np.float64]) -> tuple[NDArray[np.float64], float]:
    """The round ground, middle and radius, of which the visible side would be seen so."""
    ahead = ground.mean(axis=0) - eye
    ahead /= np.linalg.norm(ahead)
    across = np.array([-ahead[1], ahead[0]])
    left, right = np.quantile(ground @ across, (0.01, 0.99))
    near = float(np.quantile(ground @ ahead, 0.05))
    radius = 0.5 * float(right - left)
    middle = 0.5 * float(right + left) * across + (near + radius) * ahead
    return middle, radius


def _one_within_the_other(
    hulls: list[NDArray[np.float32]], discs: list[tuple[NDArray[np.float64], float]], i: int, j: int
) -> bool:
    """Whether the ground of one piece is nearly all of it within the round ground of a wider one."""
    wide, narrow = (i, j) if discs[i][1] >= discs[j][1] else (j, i)
    middle, radius = discs[wide]
    away = np.linalg.norm(hulls[narrow][:, 0] - middle, axis=1)
    return radius < _ROUND_M and float((away < radius + _DISC_ROOM_M).mean()) > _WITHIN
