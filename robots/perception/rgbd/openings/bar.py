"""A handle: a bar before a front, measured from the points between the front and the camera."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np

from kinematics.arrays import Array, InFloat64
from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Box, Cylinder
from robots.perception.rgbd.cloud import Cloud

BEFORE_M = (0.02, 0.11)
"""A bar is so far before its front."""
_BESIDE_M = 0.02
_LEAST_PIXELS = 40
_LENGTH_M = (0.08, 0.8)
_MOST_RADIUS_M = 0.03
_LEAST_RADIUS_M = 0.004
_SLENDER = 2.5
_STEPS = 12
_SAME_M, _ALONG_COS = 0.04, 0.95
"""Two sightings that are so near to each other, and as much along each other, are of one bar."""
_GROW_PX = 3
"""Pieces of a bar that lost pixels have cut apart are nearer than this."""


@dataclass(frozen=True, slots=True)
class Bar(InFloat64):
    """A bar.

    Attributes:
        shape: Its radius and length; both are measured.
        frame_T_bar: Its middle, z along it, x towards the front, shape (4, 4), in the frame in which the bar
            is told: that of the odometry, or of its front.
        pixels: How many show it.
    """

    shape: Cylinder
    frame_T_bar: Transform
    pixels: int


def completed(bar: Bar, before: Bar) -> Bar:
    """A bar as long and thick as it was seen before, where this sighting may be of a part of it.

    Args:
        bar: As it is seen now.
        before: As it was seen; both in the frame of their front, which a bar never leaves.
    """
    along = before.frame_T_bar[:3, 2]
    lacks_m = before.shape.height_m - bar.shape.height_m
    off = bar.frame_T_bar[:3, 3] - before.frame_T_bar[:3, 3]
    further_m = float(off @ along)
    beside_m = float(np.linalg.norm(off - further_m * along))
    same = abs(float(bar.frame_T_bar[:3, 2] @ along)) > _ALONG_COS and beside_m < _SAME_M
    if lacks_m <= 0.0 or not same or abs(further_m) > 0.5 * lacks_m + _SAME_M:
        return bar
    shape = Cylinder(max(bar.shape.radius_m, before.shape.radius_m), before.shape.height_m)
    front_T_bar = bar.frame_T_bar.copy()
    front_T_bar[:3, 3] -= further_m * along
    return Bar(shape, front_T_bar, bar.pixels)


def find_bar(cloud: Cloud, odom_T_front: Transform, front: Box) -> Bar | None:
    """The longest bar before a front; None when none is seen.

    Args:
        cloud: The points.
        odom_T_front: Pose of the front, x away from whoever stands before it, shape (4, 4).
        front: Its solid.
    """
    depth, width, height = front.size_m
    c, s = odom_T_front[:2, 0]
    x, y = cloud.x - np.float32(odom_T_front[0, 3]), cloud.y - np.float32(odom_T_front[1, 3])
    before = -(np.float32(c) * x + np.float32(s) * y) - np.float32(0.5 * depth)
    across = np.float32(c) * y - np.float32(s) * x
    up = cloud.z - np.float32(odom_T_front[2, 3])
    mask = (
        cloud.there
        & (before > np.maximum(np.float32(BEFORE_M[0]), np.float32(4.0) * cloud.sigma_m))
        & (before < BEFORE_M[1])
        & (np.abs(across) < 0.5 * width + _BESIDE_M)
        & (np.abs(up) < 0.5 * height + _BESIDE_M)
    )
    if int(mask.sum()) < _LEAST_PIXELS:
        return None
    grown = cv2.morphologyEx(mask.astype(np.uint8), cv2.MORPH_CLOSE, np.ones((_GROW_PX, _GROW_PX), np.uint8))
    number, labels, stats, _ = cv2.connectedComponentsWithStats(grown, connectivity=8)
    found: list[Bar] = []
    for k in range(1, number):
        if stats[k, cv2.CC_STAT_AREA] < _LEAST_PIXELS:
            continue
        pixels = mask & (labels == k)
        points = np.column_stack([before[pixels], across[pixels], up[pixels]]).astype(np.float64)
        bar = _bar(cloud, points, odom_T_front, depth)
        if bar is not None:
            found.append(bar)
    return max(found, key=lambda bar: bar.shape.height_m, default=None)


def _bar(cloud: Cloud, points: Array, odom_T_front: Transform, depth: float) -> Bar | None:
    """A bar from its points: before the front, across it, and up."""
    if len(points) < _LEAST_PIXELS:
        return None
    low, high = np.quantile(points, (0.01, 0.99), axis=0)
    upright = high[2] - low[2] > high[1] - low[1]
    along, aside = (2, 1) if upright else (1, 2)
    # the posts that carry a bar are behind it
    nearest = float(np.quantile(points[:, 0], 0.97))
    points = points[points[:, 0] > nearest - 2.0 * _MOST_RADIUS_M]
    low, high = np.quantile(points, (0.01, 0.99), axis=0)
    pixel_m = float(np.linalg.norm(cloud.odom_T_camera[:3, 3] - odom_T_front[:3, 3])) / (
        cloud.picture.camera.focal_px
    )
    length = float(high[along] - low[along]) + pixel_m
    wide = float(np.quantile(points[:, aside], 0.97) - np.quantile(points[:, aside], 0.03))
    if not _LENGTH_M[0] < length < _LENGTH_M[1] or length < _SLENDER * wide:
        return None
    middle, radius = _circle(points[:, 0], points[:, aside], nearest, 0.5 * (wide + pixel_m))
    place = np.array([-(middle[0] + 0.5 * depth), 0.0, 0.0])
    place[aside] = middle[1]
    place[along] = 0.5 * (low[along] + high[along])
    local = poses.transform(np.eye(3) if upright else poses.rotation_x(0.5 * np.pi), place)
    return Bar(Cylinder(radius, length), odom_T_front @ local, len(points))


def _circle(ahead: Array, aside: Array, nearest: float, half_width: float) -> tuple[Array, float]:
    """Middle and radius of the round section, of which one side is seen; its width is a prior."""
    radius = min(max(half_width, _LEAST_RADIUS_M), _MOST_RADIUS_M)
    state = np.array([nearest - radius, float(np.median(aside)), radius])
    wanted, sigma = radius, 0.002
    for _ in range(_STEPS):
        off = np.stack([ahead - state[0], aside - state[1]], axis=1)
        away = np.maximum(np.linalg.norm(off, axis=1), 1e-6)
        residual = away - state[2]
        weight = 1.0 / (1.0 + (residual / 0.006) ** 2) / 0.002**2 * min(1.0, 60.0 / len(ahead))
        jacobian = np.column_stack([-off / away[:, None], -np.ones(len(away))])
        normal = (jacobian * weight[:, None]).T @ jacobian
        right = -(jacobian * weight[:, None]).T @ residual
        normal[2, 2] += 1.0 / sigma**2
        right[2] -= (state[2] - wanted) / sigma**2
        normal += 1e-3 * np.eye(3)
        state = state + np.linalg.solve(normal, right)
        state[2] = min(max(float(state[2]), _LEAST_RADIUS_M), _MOST_RADIUS_M)
    return state[:2], float(state[2])
