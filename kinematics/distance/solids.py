"""Convex solids as flat arrays: the robot's links, what it holds and what is around."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from kinematics.arrays import Array, Indices
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Ball, Box, Cylinder, Shape

HULL, BOX, CYLINDER, POINT, SEGMENT = 0, 1, 2, 3, 4
# Vertices are left out of a hull as long as none of them is farther from the rest than this.
REDUCTION_M = 0.002
# The same for the rough hull that is asked first.
ROUGH_M = 0.01


class Solids(NamedTuple):
    """Each solid is a core, rounded by a ball.

    Attributes:
        kind: HULL, BOX, CYLINDER, POINT (a ball) or SEGMENT (a capsule), shape (s,).
        body: Body that carries it; 0 is the world, shape (s,).
        R, p: Pose in that body's frame, shapes (s, 3, 3) and (s, 3), m; hulls are already there.
        size: Half-sizes of a box; radius and half the height of a cylinder; 0 and half the length of
            a segment; of a hull in the world, half-sizes of a box about its centre, along the world's axes,
            that holds it, shape (s, 3), m.
        round: Radius of the rounding ball, shape (s,), m.
        few: First and last row in ``points`` of the hull's chosen vertices, shape (s, 2).
        pad: With this rounding the chosen vertices enclose the whole hull, shape (s,), m.
        all: First and last row of all its vertices, shape (s, 2).
        points: Vertices in the body's frame, shape (n, 3), m.
        centre, radius: Bounding ball in the body's frame, shapes (s, 3) and (s,), m.
        rough: The chosen vertices up to this row are a rough hull, shape (s,).
        rough_pad: With this rounding it encloses the whole hull, shape (s,), m.
    """

    kind: Indices
    body: Indices
    R: Array
    p: Array
    size: Array
    round: Array
    few: Indices
    pad: Array
    all: Indices
    points: Array
    centre: Array
    radius: Array
    rough: Indices
    rough_pad: Array


@dataclass(frozen=True, slots=True)
class Solid:
    """One solid before it is flattened; see ``Solids``."""

    kind: int
    body: int
    pose: Transform
    size: tuple[float, float, float]
    round_m: float
    centre: Array
    radius_m: float
    few: Array
    all: Array
    pad_m: float = 0.0
    rough: int = 0
    rough_pad_m: float = 0.0


_NO_POINTS = np.zeros((0, 3))


def plain_solid(body: int, pose: Transform, shape: Shape) -> Solid:
    """A box, cylinder or ball on a body."""
    match shape:
        case Box(size_m=(x, y, z)):
            return _primitive(BOX, body, pose, (0.5 * x, 0.5 * y, 0.5 * z), 0.0)
        case Cylinder(radius_m=radius, height_m=height):
            return _primitive(CYLINDER, body, pose, (radius, 0.5 * height, 0.0), 0.0)
        case Ball(radius_m=radius):
            return _primitive(POINT, body, pose, (0.0, 0.0, 0.0), radius)


def shape_solids(body: int, pose: Transform, shape: Shape) -> list[Solid]:
    """What has a shape as solids on a body: its parts, where it has some."""
    if shape.parts is None:
        return [plain_solid(body, pose, shape)]
    return [hull_of_few(body, corners @ pose[:3, :3].T + pose[:3, 3]) for corners in shape.parts.hulls]


def plain_solids(body: int, poses: Array, shapes: Sequence[Shape]) -> Solids:
    """Boxes, cylinders and balls on one body, as arrays: ``flatten`` of ``plain_solid``, faster.

    Args:
        body: What carries them.
        poses: In its frame, shape (n, 4, 4).
        shapes: What they are.
    """
    n = len(shapes)
    kind, size, rounding = np.empty(n, np.int64), np.zeros((n, 3)), np.zeros(n)
    for k, shape in enumerate(shapes):
        match shape:
            case Box(size_m=(x, y, z)):
                kind[k] = BOX
                size[k] = 0.5 * x, 0.5 * y, 0.5 * z
            case Cylinder(radius_m=radius, height_m=height):
                kind[k] = CYLINDER
                size[k, :2] = radius, 0.5 * height
            case Ball(radius_m=radius):
                kind[k] = POINT
                rounding[k] = radius
    rows = np.zeros((n, 2), np.int64)
    none, place = np.zeros(n), np.ascontiguousarray(poses[:, :3, 3])
    return Solids(
        kind=kind,
        body=np.full(n, body, np.int64),
        R=np.ascontiguousarray(poses[:, :3, :3]),
        p=place,
        size=size,
        round=rounding,
        few=rows,
        pad=none,
        all=rows,
        points=_NO_POINTS,
        centre=place,
        radius=np.sqrt(np.sum(size * size, axis=1)) + rounding,
        rough=rows[:, 0],
        rough_pad=none,
    )


def half_extents_m(solids: Solids) -> Array:
    """Half-sizes of the boxes about their centres, along their body's axes, that just hold solids, (n, 3).

    Of hulls, only of those in the world.
    """
    plain = solids
    R, size = np.abs(plain.R), plain.size[:, None]
    box = np.sum(R * size, axis=2)
    around = size[..., 0] * np.sqrt(R[..., 0] ** 2 + R[..., 1] ** 2) + size[..., 1] * R[..., 2]
    return np.asarray(np.where(np.isin(plain.kind, (BOX, HULL))[:, None], box, around) + plain.round[:, None])


def hull_of_few(body: int, corners: Array) -> Solid:
    """A hull of few corners, shape (n, 3), in the body's frame, all of which are chosen: none is left out."""
    corners = np.ascontiguousarray(corners)
    low, high = corners.min(axis=0), corners.max(axis=0)
    centre = 0.5 * (low + high)
    x, y, z = (0.5 * (high - low)).tolist()
    radius = float(np.sqrt(np.max(np.sum((corners - centre) ** 2, axis=1))))
    return Solid(
        HULL, body, np.eye(4), (x, y, z), 0.0, centre, radius, corners, corners, 0.0, len(corners), 0.0
    )


def _primitive(
    kind: int, body: int, pose: Transform, size: tuple[float, float, float], round_m: float
) -> Solid:
    # the size of every kind spans its circumscribed ball as if it were a vector
    radius = float(np.linalg.norm(size)) + round_m
    return Solid(kind, body, pose, size, round_m, np.array(pose[:3, 3]), radius, _NO_POINTS, _NO_POINTS)


def flatten(solids: Sequence[Solid]) -> Solids:
    """Put solids into arrays, in order; points of zero solids are an empty array."""
    clouds = [cloud for solid in solids for cloud in (solid.few, solid.all)]
    ends = np.cumsum([0, *map(len, clouds)]).astype(np.int64)
    return Solids(
        kind=np.array([solid.kind for solid in solids], np.int64),
        body=np.array([solid.body for solid in solids], np.int64),
        R=np.array([solid.pose[:3, :3] for solid in solids], np.float64).reshape(-1, 3, 3),
        p=np.array([solid.pose[:3, 3] for solid in solids], np.float64).reshape(-1, 3),
        size=np.array([solid.size for solid in solids], np.float64).reshape(-1, 3),
        round=np.array([solid.round_m for solid in solids], np.float64),
        few=np.ascontiguousarray(np.stack([ends[:-1:2], ends[1::2]], axis=1)),
        pad=np.array([solid.pad_m for solid in solids], np.float64),
        all=np.ascontiguousarray(np.stack([ends[1:-1:2], ends[2::2]], axis=1)),
        points=np.concatenate([_NO_POINTS, *clouds]),
        centre=np.array([solid.centre for solid in solids], np.float64).reshape(-1, 3),
        radius=np.array([solid.radius_m for solid in solids], np.float64),
        rough=ends[:-1:2] + np.array([solid.rough for solid in solids], np.int64),
        rough_pad=np.array([solid.rough_pad_m for solid in solids], np.float64),
    )


def with_more(solids: Solids, *more: Solids) -> Solids:
    """The same with others behind them, whose vertices come behind theirs."""
    moved, first_row = [], 0
    for each in (solids, *more):
        moved.append(in_rows_from(each, first_row) if first_row and len(each.points) else each)
        first_row += len(each.points)
    return Solids(*(np.concatenate(parts) for parts in zip(*moved, strict=True)))


def in_rows_from(solids: Solids, first_row: int) -> Solids:
    """The same whose vertices come behind so many others."""
    hull = solids.kind == HULL
    rows = np.where(hull, first_row, 0)
    return solids._replace(
        few=solids.few + rows[:, None], all=solids.all + rows[:, None], rough=solids.rough + rows
    )
