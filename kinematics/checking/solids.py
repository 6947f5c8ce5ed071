"""The solids that the trajectory checker judges, each with bounds that are cheap to evaluate.

A solid is fixed to one body of the robot, or to the world. Exact distances come from Coal; the
bounding ball and the support function prove most pairs apart without it.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import coal
import numpy as np

from kinematics.arrays import Array
from kinematics.checking.kinematics import WORLD, BatchedKinematics
from kinematics.distance.link_solids import coal_parts, coal_shape, convex_hull
from kinematics.errors import ModelError
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Ball, Box, Cylinder, Shape
from kinematics.model.robot_model import RobotModel

Support = Callable[[Array], Array]
"""Directions in the solid's frame, shape (n, 3), to the largest ``direction . point``, shape (n,)."""


@dataclass(frozen=True, slots=True)
class Solid:
    """A convex solid that moves with a body.

    Attributes:
        name: Link or scene object that it stands for.
        body: Body that carries it.
        body_T_solid: Its pose in that body's frame, shape (4, 4).
        geometry: Coal's shape, in the solid's frame.
        support: Its support function.
        shape: The plain shape, where it is one; hulls have none.
        centre_m: Centre of the bounding ball in the body's frame, shape (3,).
        radius_m: Radius of that ball.
        reach_m: Largest distance of a point from the body's origin.
        axis_reach_m: Largest distance of a point from the body's joint axis.
        detail: How many points its support function looks at; 0 for a formula.
    """

    name: str
    body: int
    body_T_solid: Transform
    geometry: Any
    support: Support
    shape: Shape | None
    centre_m: Array
    radius_m: float
    reach_m: float
    axis_reach_m: float
    detail: int


def robot_solids(model: RobotModel, kinematics: BatchedKinematics) -> list[Solid]:
    """One solid for each collision geometry of the robot, in the model's order.

    Raises:
        ModelError: A geometry is of a kind that has no support function here.
    """
    solids = []
    for item in model.geometry().geometryObjects:
        body_T_solid = np.array(item.placement.homogeneous)
        geometry = item.geometry
        if isinstance(geometry, coal.ConvexBase):
            hull = convex_hull(geometry.points())
            solids.append(_hull(model.link_of(item), int(item.parentJoint), body_T_solid, hull, kinematics))
            continue
        shape = _plain(geometry)
        if shape is None:
            raise ModelError(f"{item.name!r}: no support function for a {type(geometry).__name__}")
        solids.append(
            plain_solid(model.link_of(item), int(item.parentJoint), body_T_solid, shape, kinematics)
        )
    return solids


def plain_solid(
    name: str, body: int, body_T_solid: Transform, shape: Shape, kinematics: BatchedKinematics
) -> Solid:
    """A box, cylinder or ball on a body, or in the world (``body`` 0)."""
    centre = np.array(body_T_solid[:3, 3])
    radius = _circumradius(shape)
    reach_m = axis_reach_m = 0.0
    if body != WORLD:
        axis = kinematics.axis[body]
        reach_m = math.hypot(*centre) + radius
        axis_reach_m = math.hypot(*(centre - axis * (axis @ centre))) + radius
    return Solid(
        name=name,
        body=body,
        body_T_solid=body_T_solid,
        geometry=coal_shape(shape),
        support=_plain_support(shape),
        shape=shape,
        centre_m=centre,
        radius_m=radius,
        reach_m=reach_m,
        axis_reach_m=axis_reach_m,
        detail=0,
    )


def shape_solids(
    name: str, body: int, body_T_solid: Transform, shape: Shape, kinematics: BatchedKinematics
) -> list[Solid]:
    """What has a shape on a body, or in the world: its parts, where it has some."""
    if shape.parts is None:
        return [plain_solid(name, body, body_T_solid, shape, kinematics)]
    return [_hull(name, body, body_T_solid, hull, kinematics) for hull in coal_parts(shape.parts)]


def distance_to_shape(shape: Shape, points: Array) -> Array:
    """Distance of points, shape (..., 3) in the shape's frame, to its surface; 0 inside."""
    match shape:
        case Box(size_m=size):
            return np.asarray(np.linalg.norm(np.maximum(np.abs(points) - 0.5 * np.array(size), 0.0), axis=-1))
        case Cylinder(radius_m=radius, height_m=height):
            outside = np.maximum(np.hypot(points[..., 0], points[..., 1]) - radius, 0.0)
            return np.asarray(np.hypot(outside, np.maximum(np.abs(points[..., 2]) - 0.5 * height, 0.0)))
        case Ball(radius_m=radius):
            return np.asarray(np.maximum(np.linalg.norm(points, axis=-1) - radius, 0.0))


def _hull(
    name: str, body: int, body_T_solid: Transform, geometry: Any, kinematics: BatchedKinematics
) -> Solid:
    # imported here: it brings the compiler
    from kinematics.distance.enclosing_ball import ball_centre

    points = np.ascontiguousarray(geometry.points())
    in_body = points @ body_T_solid[:3, :3].T + body_T_solid[:3, 3]
    centre = ball_centre(in_body)
    axis = np.zeros(3) if body == WORLD else kinematics.axis[body]
    across = in_body - np.outer(in_body @ axis, axis)
    columns = np.ascontiguousarray(points.T)
    return Solid(
        name=name,
        body=body,
        body_T_solid=body_T_solid,
        geometry=geometry,
        support=lambda directions: np.asarray((directions @ columns).max(axis=1)),
        shape=None,
        centre_m=centre,
        radius_m=float(np.linalg.norm(in_body - centre, axis=1).max()),
        reach_m=float(np.linalg.norm(in_body, axis=1).max()),
        axis_reach_m=float(np.linalg.norm(across, axis=1).max()),
        detail=len(points),
    )


def _plain(geometry: Any) -> Shape | None:
    if isinstance(geometry, coal.Box):
        x, y, z = 2.0 * np.array(geometry.halfSide)
        return Box((float(x), float(y), float(z)))
    if isinstance(geometry, coal.Cylinder):
        return Cylinder(float(geometry.radius), 2.0 * float(geometry.halfLength))
    if isinstance(geometry, coal.Sphere):
        return Ball(float(geometry.radius))
    return None


def _circumradius(shape: Shape) -> float:
    match shape:
        case Box(size_m=size):
            return 0.5 * math.hypot(*size)
        case Cylinder(radius_m=radius, height_m=height):
            return math.hypot(radius, 0.5 * height)
        case Ball(radius_m=radius):
            return radius


def _plain_support(shape: Shape) -> Support:
    match shape:
        case Box(size_m=size):
            half = 0.5 * np.array(size)
            return lambda directions: np.asarray(np.abs(directions) @ half)
        case Cylinder(radius_m=radius, height_m=height):
            return lambda directions: np.asarray(
                radius * np.hypot(directions[:, 0], directions[:, 1])
                + 0.5 * height * np.abs(directions[:, 2])
            )
        case Ball(radius_m=radius):
            return lambda directions: np.asarray(radius * np.linalg.norm(directions, axis=1))
