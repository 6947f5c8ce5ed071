"""What stands between an eye and many points."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array
from kinematics.geometry import poses
from kinematics.geometry.shapes import Box, Cylinder
from kinematics.scene.planning_scene import SceneObject

Mask = NDArray[np.bool_]

# A line that only touches the point itself is not blocked by what the point lies on.
_SHORT = 0.999


def hidden(eye: Array, points: Array, items: Iterable[SceneObject]) -> Mask:
    """Tell which points cannot be seen for solids in between, shape (n,).

    Args:
        eye: World, shape (3,).
        points: World, shape (n, 3).
        items: The solids.
    """
    found: Mask = np.zeros(len(points), dtype=bool)
    for item in items:
        if found.all():  # of no points as well
            break
        found |= _blocked(eye, points, item)
    return found


def near_line(eye: Array, points: Array, parts: Array, within_m: float) -> Mask:
    """Tell which lines of sight pass one of some places nearer than that, shape (n,).

    Args:
        eye: World, shape (3,).
        points: World, shape (n, 3).
        parts: World, shape (m, 3).
        within_m: Their radius.
    """
    rays = points - eye
    found: Mask = np.zeros(len(points), dtype=bool)
    for part in parts:
        along = np.clip(rays @ (part - eye) / np.einsum("ij,ij->i", rays, rays), 0.0, 1.0)
        found |= np.linalg.norm(eye + along[:, None] * rays - part, axis=1) < within_m
    return found


def _blocked(eye: Array, points: Array, item: SceneObject) -> Mask:
    local = poses.inverse(item.world_T_object)
    start = local[:3, :3] @ eye + local[:3, 3]
    ways = points @ local[:3, :3].T + local[:3, 3] - start
    if isinstance(item.shape, Box):
        half = 0.5 * np.array(item.shape.size_m)
        entry, leave = _through_slabs(start, ways, half)
    elif isinstance(item.shape, Cylinder):
        entry, leave = _through_slabs(start[2:], ways[:, 2:], np.array([0.5 * item.shape.height_m]))
        round_entry, round_leave = _through_round(start[:2], ways[:, :2], item.shape.radius_m)
        entry, leave = np.maximum(entry, round_entry), np.minimum(leave, round_leave)
    else:
        entry, leave = _through_round(start, ways, item.shape.radius_m)
    return np.asarray((entry <= leave) & (leave >= 0.0) & (entry <= _SHORT), dtype=np.bool_)


def _through_slabs(start: Array, ways: Array, half: Array) -> tuple[Array, Array]:
    """Where lines enter and leave a box, as shares of their length."""
    steep = np.where(np.abs(ways) < 1e-12, 1e-12, ways)
    one, other = (-half - start) / steep, (half - start) / steep
    return np.minimum(one, other).max(axis=1), np.maximum(one, other).min(axis=1)


def _through_round(start: Array, ways: Array, radius_m: float) -> tuple[Array, Array]:
    """The same for a ball, or for a cylinder without ends: |start + t way| = r."""
    a = np.maximum(np.einsum("ij,ij->i", ways, ways), 1e-12)
    b, c = ways @ start, float(start @ start) - radius_m**2
    root = np.sqrt(np.maximum(b * b - a * c, 0.0))
    missed = b * b < a * c
    entry, leave = (-b - root) / a, (-b + root) / a
    return np.where(missed, np.inf, entry), np.where(missed, -np.inf, leave)
