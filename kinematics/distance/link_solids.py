"""A robot's link as a convex solid, and shapes of things as Coal's solids."""

from __future__ import annotations

import functools
from dataclasses import replace
from typing import Any

import coal
import numpy as np

from kinematics.arrays import Array
from kinematics.distance.solids import (
    BOX,
    CYLINDER,
    HULL,
    POINT,
    REDUCTION_M,
    ROUGH_M,
    SEGMENT,
    Solid,
    _primitive,
)
from kinematics.errors import ModelError
from kinematics.geometry.convex_parts import ConvexParts
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Ball, Box, Shape


def link_solid(body: int, pose: Transform, geometry: Any) -> Solid:
    """A solid of one of the robot's collision geometries.

    Raises:
        ModelError: It is of a kind that has no support function here.
    """
    if isinstance(geometry, coal.ConvexBase):
        return _hull(body, np.array(geometry.points()) @ pose[:3, :3].T + pose[:3, 3])
    if isinstance(geometry, coal.Box):
        x, y, z = np.array(geometry.halfSide)
        return _primitive(BOX, body, pose, (float(x), float(y), float(z)), 0.0)
    if isinstance(geometry, coal.Cylinder):
        return _primitive(
            CYLINDER, body, pose, (float(geometry.radius), float(geometry.halfLength), 0.0), 0.0
        )
    if isinstance(geometry, coal.Sphere):
        return _primitive(POINT, body, pose, (0.0, 0.0, 0.0), float(geometry.radius))
    if isinstance(geometry, coal.Capsule):
        return _primitive(SEGMENT, body, pose, (0.0, float(geometry.halfLength), 0.0), float(geometry.radius))
    raise ModelError(f"no support function for a {type(geometry).__name__}")


def _hull(body: int, points: Array) -> Solid:
    return replace(_alike(np.ascontiguousarray(points).tobytes()), body=body)


@functools.lru_cache(maxsize=512)
def _alike(points_of_hull: bytes) -> Solid:
    """The solid of the corners of a hull, shape (n, 3); robots of one kind have the same."""
    # imported here: they bring the compiler
    from kinematics.distance.enclosing_ball import ball_centre
    from kinematics.distance.separation import reduced_hull

    points = np.frombuffer(points_of_hull).reshape(-1, 3).copy()
    order = np.empty(len(points), np.int64)
    # vertices are chosen in one order, whatever the tolerance
    rough, rough_pad = reduced_hull(points, ROUGH_M, order)
    count, pad = reduced_hull(points, REDUCTION_M, order)
    few = points[order[:count]]
    centre = ball_centre(points)
    radius = float(np.linalg.norm(points - centre, axis=1).max())
    pose = np.eye(4)
    for kept in (pose, points, few, centre):
        kept.flags.writeable = False
    return Solid(HULL, 0, pose, (0.0, 0.0, 0.0), 0.0, centre, radius, few, points, pad, rough, rough_pad)


def convex_hull(points: Array) -> coal.ConvexBase:
    """Coal's convex hull of some points, shape (n, 3).

    Made anew of what is a hull already: Coal does not check, and on a mesh with hollows its search along the
    edges ends at a wrong support point.
    """
    corners = coal.StdVec_Vec3s()
    for point in points:
        corners.append(point)
    return coal.ConvexBase.convexHull(corners, True, "Qt")


@functools.lru_cache(maxsize=128)
def coal_parts(parts: ConvexParts) -> tuple[coal.ConvexBase, ...]:
    """Coal's solids of what a thing is made of."""
    return tuple(convex_hull(corners) for corners in parts.hulls)


def coal_solids(shape: Shape) -> tuple[coal.CollisionGeometry, ...]:
    """Coal's solids of what has a shape: of its parts, where it has some."""
    return (coal_shape(shape),) if shape.parts is None else coal_parts(shape.parts)


def coal_shape(shape: Shape) -> coal.CollisionGeometry:
    """Coal's solid of a shape; of what has parts, of its outline."""
    if isinstance(shape, Box):
        return coal.Box(*shape.size_m)
    if isinstance(shape, Ball):
        return coal.Sphere(shape.radius_m)
    return coal.Cylinder(shape.radius_m, shape.height_m)
