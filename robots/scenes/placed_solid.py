"""Solids where they stand in the world: what one takes up, what is under it, and whether two share room."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array, Sealed
from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Ball, Box, Cylinder, Shape
from robots.scenes.hull_overlap import hulls_overlap

TOUCH_TOLERANCE_M = 0.0005
"""Deeper than this two things overlap; shallower they touch."""


@dataclass(frozen=True, slots=True)
class PlacedSolid(Sealed):
    """A solid of a scene's thing.

    Attributes:
        label: What it belongs to, for messages.
        shape: Its shape.
        world_T_solid: Its pose, shape (4, 4).
    """

    label: str
    shape: Shape
    world_T_solid: Transform


def _extents(solid: PlacedSolid) -> NDArray[np.float64]:
    """Half of what a solid takes along each axis of the world, shape (3,)."""
    axes = solid.world_T_solid[:3, :3]
    match solid.shape:
        case Box(size_m=size):
            return np.asarray(0.5 * np.abs(axes) @ np.asarray(size))
        case Cylinder(radius_m=radius, height_m=height):
            return np.asarray(0.5 * height * np.abs(axes[:, 2]) + radius * np.hypot(axes[:, 0], axes[:, 1]))
        case Ball(radius_m=radius):
            return np.full(3, radius)


def lowest_m(solid: PlacedSolid) -> float:
    """Height of its lowest point over the floor."""
    return float(solid.world_T_solid[2, 3] - _extents(solid)[2])


def top_m(solid: PlacedSolid) -> float:
    """Height of its highest point over the floor."""
    return float(solid.world_T_solid[2, 3] + _extents(solid)[2])


def fall_m(solid: PlacedSolid, others: Sequence[PlacedSolid]) -> float:
    """How far a solid is above what is under its centre: floor, furniture or another object."""
    low_m = lowest_m(solid)
    gap_m = low_m
    for other in others:
        other_top_m = top_m(other)
        if other_top_m <= low_m + TOUCH_TOLERANCE_M and _above(solid.world_T_solid[:3, 3], other):
            gap_m = min(gap_m, low_m - other_top_m)
    return gap_m


def _above(point: NDArray[np.float64], solid: PlacedSolid) -> bool:
    """Tell whether a point is straight above an (upright) solid."""
    local = poses.inverse(solid.world_T_solid) @ np.array(
        [point[0], point[1], solid.world_T_solid[2, 3], 1.0]
    )
    match solid.shape:
        case Box(size_m=size):
            return bool(abs(local[0]) <= 0.5 * size[0] and abs(local[1]) <= 0.5 * size[1])
        case Cylinder(radius_m=radius) | Ball(radius_m=radius):
            return math.hypot(local[0], local[1]) <= radius


def overlap(a: PlacedSolid, b: PlacedSolid) -> bool:
    """Tell whether two solids share room deeper than the tolerance."""
    apart = np.abs(a.world_T_solid[:3, 3] - b.world_T_solid[:3, 3])
    if np.any(apart > _extents(a) + _extents(b)):
        return False
    if not (_some_point_inside(a, b) or _some_point_inside(b, a)):
        return False
    if a.shape.parts is None and b.shape.parts is None:
        return True
    return hulls_overlap(_hulls(a), _hulls(b), TOUCH_TOLERANCE_M)


def _hulls(solid: PlacedSolid) -> list[Array]:
    """What it is made of, as corners in the world; of what has no parts a few of its own surface."""
    parts = solid.shape.parts
    own = [_samples(solid.shape)] if parts is None else parts.hulls
    return [hull @ solid.world_T_solid[:3, :3].T + solid.world_T_solid[:3, 3] for hull in own]


def _some_point_inside(probe: PlacedSolid, target: PlacedSolid) -> bool:
    points = _samples(probe.shape) @ probe.world_T_solid[:3, :3].T + probe.world_T_solid[:3, 3]
    local = (points - target.world_T_solid[:3, 3]) @ target.world_T_solid[:3, :3]
    match target.shape:
        case Box(size_m=size):
            depth = np.min(0.5 * np.asarray(size) - np.abs(local), axis=1)
        case Cylinder(radius_m=radius, height_m=height):
            depth = np.minimum(
                radius - np.hypot(local[:, 0], local[:, 1]), 0.5 * height - np.abs(local[:, 2])
            )
        case Ball(radius_m=radius):
            depth = radius - np.linalg.norm(local, axis=1)
    return bool(np.max(depth) > TOUCH_TOLERANCE_M)


def _samples(shape: Shape) -> NDArray[np.float64]:
    """Points that fill a solid and its surface densely enough to meet anything that overlaps it."""
    steps = np.linspace(-1.0, 1.0, 25)
    match shape:
        case Box(size_m=size):
            grid = np.stack(np.meshgrid(steps, steps, steps, indexing="ij"), axis=-1).reshape(-1, 3)
            return np.asarray(grid * (0.5 * np.asarray(size)), dtype=np.float64)
        case Cylinder(radius_m=radius, height_m=height):
            angles = np.linspace(0.0, 2.0 * math.pi, 180, endpoint=False)
            rings = np.linspace(0.0, radius, 7)
            r, angle, z = (axis.ravel() for axis in np.meshgrid(rings, angles, 0.5 * height * steps))
            return np.stack([r * np.cos(angle), r * np.sin(angle), z], axis=-1)
        case Ball(radius_m=radius):
            angles = np.linspace(0.0, 2.0 * math.pi, 90, endpoint=False)
            polar = np.linspace(0.0, math.pi, 46)
            shells = np.linspace(0.0, radius, 5)
            r, a, p = (axis.ravel() for axis in np.meshgrid(shells, angles, polar))
            return np.stack([r * np.sin(p) * np.cos(a), r * np.sin(p) * np.sin(a), r * np.cos(p)], axis=-1)
