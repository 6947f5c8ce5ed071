"""Level surfaces that could carry things: tops of tables, boards, worktops."""

from __future__ import annotations

import math
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import InFloat64
from robots.perception.rgbd.cloud import Cloud, levelling

STEP_M = 0.005
"""Of the histogram of heights."""
LOWEST_M, HIGHEST_M = 0.15, 1.6
"""Between these the surfaces are on which a standing robot takes things."""
LEAST_AREA_M2 = 0.03
_APART_M = 0.04
_MOST = 5
_TOLERANCES_M = (0.020, 0.008, 0.006)
MOST_TILT_RAD = 0.07
"""A camera that was knocked out of its place is turned by less: a surface that leans more is no level one
that was seen askew."""
_EVERY = 2
"""Only every second pixel of every second row is looked at."""
_CELL_M = 0.01
_FITTED = 6000
"""Pixels that are enough for a plane."""
HULL_ROOM_M = 0.03
_ROWS_ON, _STEEPEST = 4, 0.5
"""From row to row so far on, a level surface rises by less than this share of the way."""


@dataclass(frozen=True, slots=True)
class Surface(InFloat64):
    """A level surface.

    Attributes:
        height_m: Above the floor.
        hull: Corners of its visible part, counter-clockwise, shape (n, 2).
        pixels: Which pixels show it, of every second row and column.
        area_m2: Of what is visible.
        slopes: How it seemed to lean along x and y before the camera's tilt was corrected.
    """

    height_m: float
    hull: NDArray[np.float32]
    pixels: NDArray[np.bool_]
    area_m2: float
    slopes: tuple[float, float]


def find_surfaces(cloud: Cloud) -> tuple[Cloud, tuple[Surface, ...], float]:
    """The cloud with the camera's tilt corrected, its level surfaces, the largest first, and that tilt, rad.

    The largest surface is taken to be level: what an IMU and a calibration leave of tilt is seen in it.
    """
    found = _surfaces(cloud)
    if not found:
        return cloud, (), 0.0
    slope_x, slope_y = found[0].slopes
    tilt = math.hypot(slope_x, slope_y)
    if tilt > MOST_TILT_RAD:
        return cloud, tuple(found), tilt
    cloud = cloud.turned(levelling(slope_x, slope_y))
    return cloud, tuple(_surfaces(cloud, tuple(surface.pixels for surface in found))), tilt


def inside(
    surface: Surface, x: NDArray[np.float32], y: NDArray[np.float32], room_m: float = HULL_ROOM_M
) -> NDArray[np.bool_]:
    """Which places are over a surface, or a little beside what is visible of it; any shape."""
    low = surface.hull.min(axis=0) - 2.0 * room_m
    size = np.ceil((surface.hull.max(axis=0) + 2.0 * room_m - low) / _CELL_M).astype(int) + 1
    grid = np.zeros((size[1], size[0]), np.uint8)
    corners = np.round((surface.hull - low) / _CELL_M).astype(np.int32)
    cv2.fillConvexPoly(grid, corners, 1)
    wide = 2 * round(room_m / _CELL_M) + 1
    grid = cv2.dilate(grid, np.ones((wide, wide), np.uint8))
    column = np.clip(((x - np.float32(low[0])) / np.float32(_CELL_M)).astype(np.int32), -1, size[0])
    row = np.clip(((y - np.float32(low[1])) / np.float32(_CELL_M)).astype(np.int32), -1, size[1])
    padded = np.zeros((size[1] + 2, size[0] + 2), np.bool_)
    padded[1:-1, 1:-1] = grid > 0
    return np.asarray(padded[row + 1, column + 1])


def _surfaces(cloud: Cloud, known: tuple[NDArray[np.bool_], ...] = ()) -> list[Surface]:
    part = (slice(None, None, _EVERY), slice(None, None, _EVERY))
    x, y, z = cloud.x[part], cloud.y[part], cloud.z[part]
    there, depth = cloud.there[part], cloud.depth_m[part]
    masks = known or _masks(z, there, depth, cloud.picture.camera.focal_px)
    found = []
    for mask in masks:
        if not known and not _is_flat(x, y, z, mask):
            continue
        surface = _fitted(x, y, z, depth, mask, cloud.picture.camera.focal_px)
        if surface is not None:
            found.append(surface)
    return sorted(found, key=lambda surface: -surface.area_m2)


def _masks(
    z: NDArray[np.float32], there: NDArray[np.bool_], depth: NDArray[np.float32], focal_px: float
) -> list[NDArray[np.bool_]]:
    """Connected patches of pixels at one height, the heights being peaks of a histogram by area."""
    between = there & (z > LOWEST_M) & (z < HIGHEST_M)
    area = (_EVERY * depth[between] / np.float32(focal_px)) ** 2
    bins = ((z[between] - np.float32(LOWEST_M)) / np.float32(STEP_M)).astype(np.int32)
    count = int((HIGHEST_M - LOWEST_M) / STEP_M) + 2
    histogram = np.convolve(np.bincount(bins, area, minlength=count), np.ones(5), "same")
    masks: list[NDArray[np.bool_]] = []
    left = histogram.copy()
    for _ in range(_MOST):
        peak = int(np.argmax(left))
        if left[peak] < LEAST_AREA_M2:
            break
        near = round(_APART_M / STEP_M)
        left[max(0, peak - near) : peak + near + 1] = 0.0
        height = LOWEST_M + (peak + 0.5) * STEP_M
        level = (there & (np.abs(z - np.float32(height)) < np.float32(_TOLERANCES_M[0]))).astype(np.uint8)
        level = cv2.morphologyEx(level, cv2.MORPH_OPEN, np.ones((3, 3), np.uint8))
        number, labels, stats, _ = cv2.connectedComponentsWithStats(level, connectivity=4)
        large = [i for i in range(1, number) if stats[i, cv2.CC_STAT_AREA] > 400]
        masks += [labels == i for i in large]
    return masks


def _is_flat(
    x: NDArray[np.float32], y: NDArray[np.float32], z: NDArray[np.float32], mask: NDArray[np.bool_]
) -> bool:
    """Whether a patch at one height goes on along the ground; a strip of walls goes up."""
    both = mask[:-_ROWS_ON] & mask[_ROWS_ON:]
    rise, run = (
        np.abs(z[_ROWS_ON:][both] - z[:-_ROWS_ON][both]),
        np.hypot(x[_ROWS_ON:][both] - x[:-_ROWS_ON][both], y[_ROWS_ON:][both] - y[:-_ROWS_ON][both]),
    )
    return bool(len(rise) == 0 or float((rise < _STEEPEST * run).mean()) > 0.5)


def _fitted(
    x: NDArray[np.float32],
    y: NDArray[np.float32],
    z: NDArray[np.float32],
    depth: NDArray[np.float32],
    mask: NDArray[np.bool_],
    focal_px: float,
) -> Surface | None:
    """A plane through a patch by least squares, from all near it to those nearest."""
    pixels = np.flatnonzero(mask)
    if len(pixels) < 300:
        return None
    every = max(1, len(pixels) // _FITTED)
    pixels = pixels[::every]
    px, py, pz, away = (value.ravel()[pixels].astype(np.float64) for value in (x, y, z, depth))
    middle = float(px.mean()), float(py.mean())
    design = np.column_stack([px - middle[0], py - middle[1], np.ones(len(px))])
    # far points are less sure, and there are fewer of them
    weight = 1.0 / (0.001 + 0.002 * away**2)
    plane = np.array([0.0, 0.0, float(np.median(pz))])
    for tolerance in _TOLERANCES_M:
        near = np.abs(pz - design @ plane) < tolerance
        if near.sum() < 150:
            return None
        w = weight[near]
        plane = np.linalg.lstsq(design[near] * w[:, None], pz[near] * w, rcond=None)[0]
    near = np.abs(pz - design @ plane) < 2.0 * _TOLERANCES_M[-1]
    area = every * float(((_EVERY * away[near] / focal_px) ** 2).sum())
    hull = cv2.convexHull(np.column_stack([px[near], py[near]]).astype(np.float32))[:, 0]
    # seen from above, an area is that of its pixels over the cosine; the hull bounds what holes leave out
    shown = max(area, 0.3 * float(cv2.contourArea(hull)))
    if shown < LEAST_AREA_M2:
        return None
    return Surface(float(plane[2]), hull, mask, shown, (float(plane[0]), float(plane[1])))
