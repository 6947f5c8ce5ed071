"""The box, cylinder or ball that holds a thing, and how well it fits."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from kinematics.arrays import Array, Sealed
from kinematics.geometry.shapes import Ball, Box, Cylinder, Shape
from robots.scenes.importing.extra import library

WORTH_A_TURN = 0.9
"""A thing is turned about the vertical where its rectangle from above is then smaller than this share."""
_NEARLY_ALL = 98.0
"""Percentile of the distances that is the error of a fit: a rim or a seam is no misfit."""
_BALL_ERROR_M = 0.006
"""What fits a ball worse is none."""
_SAMPLES = 3000


@dataclass(frozen=True, slots=True)
class Fit(Sealed):
    """An outline, where its centre is, and how far the hull's surface is from its own.

    Attributes:
        outline: The solid, upright.
        centre: Of it, in the thing's frame, shape (3,), m.
        error_m: Of nearly all points of the hull's surface, at most.
    """

    outline: Shape
    centre: Array
    error_m: float


def turn_of(corners: Array) -> float:
    """By how much to turn a standing thing about the vertical so that its sides are along x and y, rad."""
    hull = corners[library("scipy.spatial").ConvexHull(corners[:, :2]).vertices, :2]
    edges = np.roll(hull, -1, axis=0) - hull
    angles = np.unique(np.round(np.mod(np.arctan2(edges[:, 1], edges[:, 0]), 0.5 * np.pi), 4))
    areas = [_area(hull, angle) for angle in angles]
    best = float(angles[int(np.argmin(areas))])
    if min(areas) > WORTH_A_TURN * _area(hull, 0.0):
        return 0.0
    return -best if best <= 0.25 * np.pi else 0.5 * np.pi - best


def _area(points: Array, angle: float) -> float:
    c, s = np.cos(angle), np.sin(angle)
    return float(np.prod(np.ptp(points @ np.array([[c, -s], [s, c]]), axis=0)))


def fitted(corners: Array, seed: int = 0) -> Fit:
    """The best of the three outlines; each holds all corners, shape (n, 3), m."""
    trimesh = library("trimesh")
    hull = trimesh.convex.convex_hull(corners)
    planes = library("scipy.spatial").ConvexHull(corners).equations
    low, high = corners.min(axis=0), corners.max(axis=0)
    x, y, z = (high - low).tolist()
    middle, radius = _enclosing(corners[:, :2])
    ball_middle, ball_radius = _enclosing(corners)
    upright_middle = np.array([*middle, 0.5 * (low[2] + high[2])])
    found = []
    for outline, centre, solid in (
        (Box((x, y, z)), 0.5 * (low + high), trimesh.creation.box((x, y, z))),
        (Cylinder(radius, z), upright_middle, trimesh.creation.cylinder(radius, z, sections=64)),
        (Ball(ball_radius), ball_middle, trimesh.creation.icosphere(subdivisions=3, radius=ball_radius)),
    ):
        ours, outer = (
            np.asarray(trimesh.sample.sample_surface(each, _SAMPLES, seed=np.random.default_rng(seed))[0])
            for each in (hull, solid)
        )
        # from the hull to the outline, and back: of what is flat the first alone says nothing
        gap = np.abs(_outside(outline, ours - centre))
        back = ((outer + centre) @ planes[:, :3].T + planes[:, 3]).max(axis=1)
        found.append(Fit(outline, centre, max(_nearly_all(gap), _nearly_all(back))))
    # a ball is no higher than wide, and stands on its lowest point: what is none, as a mug, stands on a foot
    return min(
        (fit for fit in found if not isinstance(fit.outline, Ball) or fit.error_m <= _BALL_ERROR_M),
        key=lambda fit: fit.error_m,
    )


def _outside(outline: Shape, points: Array) -> Array:
    """How far points in an outline are from its surface, shape (n,), negative inside."""
    match outline:
        case Box(size_m=size):
            return np.asarray((np.abs(points) - 0.5 * np.array(size)).max(axis=1))
        case Cylinder(radius_m=radius, height_m=height):
            side = np.hypot(points[:, 0], points[:, 1]) - radius
            return np.asarray(np.maximum(side, np.abs(points[:, 2]) - 0.5 * height))
        case Ball(radius_m=radius):
            return np.asarray(np.linalg.norm(points, axis=1) - radius)


def _nearly_all(distances: Array) -> float:
    return float(np.percentile(distances, _NEARLY_ALL))


def _enclosing(points: Array) -> tuple[Array, float]:
    """Middle and radius of a nearly smallest ball about points (Badoiu and Clarkson, 2003)."""
    centre = points.mean(axis=0)
    for i in range(1, 2000):
        off = points - centre
        centre = centre + off[np.argmax(np.einsum("ni,ni->n", off, off))] / (i + 1)
    return centre, float(np.linalg.norm(points - centre, axis=1).max())
