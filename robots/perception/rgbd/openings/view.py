"""What of a picture may belong to one piece of furniture."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from kinematics.arrays import Array, InFloat64
from robots.perception.rgbd.cloud import Cloud
from robots.perception.rgbd.picture import Mask
from robots.scenes.articulated import DOOR_OPENS_RAD
from robots.scenes.scene_description import Furniture

EVERY = 4
"""Of the rows and columns so many are looked at as one."""
_MOST_POINTS = 1000
_MOST_EDGES = 300
_ROOM_M = 0.15
_FLOOR_M = 0.05
_JUMP_M = 0.05


@dataclass(frozen=True, slots=True)
class View(InFloat64):
    """Points around where a piece should be, in the odometry frame.

    Attributes:
        points: Shape (n, 3).
        normals: Of the surface at each, towards the camera, shape (n, 3); 0 where it could not be told.
        sigma_m: Of each, along the line of sight, shape (n,).
        edges: Points of outlines at the sides of which the picture goes on farther away, shape (m, 3).
        level_edges: The same above or below which it does.
        eye: Where the camera is, shape (3,).
        cloud: The whole picture.
    """

    points: Array
    normals: Array
    sigma_m: Array
    edges: Array
    level_edges: Array
    eye: Array
    cloud: Cloud

    def thinned(self, most: int) -> View:
        """The same of at most so many points, about."""
        points, edges = slice(None, None, max(1, len(self.points) // most)), slice(None, None, 4)
        return View(
            self.points[points],
            self.normals[points],
            self.sigma_m[points],
            self.edges[edges],
            self.level_edges[edges],
            self.eye,
            self.cloud,
        )

    def depth_at(self, points: Array) -> tuple[Array, Array]:
        """What the picture shows in the direction of points, 0 where nothing or outside; and their depth."""
        cloud = self.cloud
        seen = (points - self.eye) @ cloud.odom_T_camera[:3, :3]
        pixels = np.round(cloud.picture.pixels_of(seen)).astype(np.int64)
        rows, columns = cloud.depth_m.shape
        within = (
            (seen[:, 2] > 0.2) & (pixels >= 0).all(axis=1) & (pixels[:, 0] < columns) & (pixels[:, 1] < rows)
        )
        u, v = np.clip(pixels[:, 0], 0, columns - 1), np.clip(pixels[:, 1], 0, rows - 1)
        shown = np.where(within & cloud.there[v, u], cloud.depth_m[v, u], 0.0)
        return shown, seen[:, 2]


@dataclass(frozen=True, slots=True)
class Thinned(InFloat64):
    """A picture of fewer points with their normals, for all pieces alike.

    Attributes:
        points, normals: Shape (rows, columns, 3).
        sigma_m, there: Shape (rows, columns).
        edges, level_edges: As of ``View``, of the whole picture.
    """

    points: Array
    normals: Array
    sigma_m: Array
    there: Mask
    edges: Array
    level_edges: Array


def thinned(cloud: Cloud) -> Thinned:
    """Every so manyth point of a cloud."""
    part = (slice(None, None, EVERY), slice(None, None, EVERY))
    points = np.stack([cloud.x[part], cloud.y[part], cloud.z[part]], axis=-1).astype(np.float64)
    there = cloud.there[part]
    right, below = np.zeros_like(points), np.zeros_like(points)
    right[:, 1:-1] = points[:, 2:] - points[:, :-2]
    below[1:-1] = points[2:] - points[:-2]
    normals = np.cross(right, below)
    length = np.linalg.norm(normals, axis=-1, keepdims=True)
    smooth = np.zeros(there.shape, np.bool_)
    smooth[1:-1, 1:-1] = there[1:-1, 2:] & there[1:-1, :-2] & there[2:, 1:-1] & there[:-2, 1:-1]
    normals = np.where(smooth[..., None] & (length > 0.0), normals / np.maximum(length, 1e-12), 0.0)
    eye = cloud.odom_T_camera[:3, 3]
    away = ((points - eye) * normals).sum(axis=-1) > 0.0
    normals = np.where(away[..., None], -normals, normals)
    return Thinned(
        points,
        np.asarray(normals, dtype=np.float64),
        cloud.sigma_m[part].astype(np.float64),
        there,
        _edges(cloud, 1),
        _edges(cloud, 0),
    )


def _edges(cloud: Cloud, axis: int) -> Array:
    """The nearer points at jumps of depth along rows (axis 1) or columns (axis 0), every second of these.

    Lost pixels between both sides are bridged.
    """
    part = (slice(None, None, 2), slice(None)) if axis == 1 else (slice(None), slice(None, None, 2))
    depth, there = cloud.depth_m[part], cloud.there[part]
    found = []
    for way in (1, -1):
        beyond, seen = np.roll(depth, -5 * way, axis=axis), np.roll(there, -5 * way, axis=axis)
        jump = there & seen & (beyond > depth + np.float32(_JUMP_M))
        # the last pixel that came back before the jump
        next_there, following = np.roll(there, -way, axis=axis), np.roll(depth, -way, axis=axis)
        ends = jump & (~next_there | (following > depth + np.float32(_JUMP_M)))
        ends[:8] = ends[-8:] = False
        ends[:, :8] = ends[:, -8:] = False
        v, u = np.nonzero(ends)
        found.append(np.column_stack([cloud.x[part][v, u], cloud.y[part][v, u], cloud.z[part][v, u]]))
    return np.asarray(np.concatenate(found), dtype=np.float64)


def view_of(cloud: Cloud, whole: Thinned, piece: Furniture) -> View:
    """The points that may show a piece, as far as its door or drawer reaches."""
    depth, width, height = piece.size_m
    reach = width if piece.opens is not None and piece.opens.hinge is not None else 0.85 * depth
    c, s = np.cos(piece.yaw_rad), np.sin(piece.yaw_rad)

    def near(points: Array) -> Mask:
        x, y = points[..., 0] - piece.position_m[0], points[..., 1] - piece.position_m[1]
        local_x, local_y = c * x + s * y, c * y - s * x
        swing = _ROOM_M + (reach * np.sin(max(DOOR_OPENS_RAD - 0.5 * np.pi, 0.0)))
        return np.asarray(
            (local_x > -0.5 * depth - reach - _ROOM_M)
            & (local_x < 0.5 * depth + _ROOM_M)
            & (np.abs(local_y) < 0.5 * width + swing)
            & (points[..., 2] > _FLOOR_M)
            & (points[..., 2] < height + _ROOM_M)
        )

    rows, columns = np.nonzero(whole.there & near(whole.points))
    step = max(1, len(rows) // _MOST_POINTS)
    rows, columns = rows[::step], columns[::step]
    edges, level_edges = (_few(some[near(some)]) for some in (whole.edges, whole.level_edges))
    return View(
        whole.points[rows, columns],
        whole.normals[rows, columns],
        whole.sigma_m[rows, columns],
        edges,
        level_edges,
        cloud.odom_T_camera[:3, 3],
        cloud,
    )


def _few(points: Array) -> Array:
    """At most so many of them as edges need."""
    return points[:: max(1, len(points) // _MOST_EDGES)]
