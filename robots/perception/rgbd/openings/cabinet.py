"""A piece of furniture that opens, as boxes that depend on where it stands and how far it is open."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from kinematics.arrays import Array, InFloat64
from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Box
from robots.scenes.articulated import (
    DOOR,
    MovingSolid,
    fixed_boxes,
    furniture_T_part,
    hinge_side,
    moving_solids,
    opened,
    opens_to,
)
from robots.scenes.scene_description import Furniture

X, Y, YAW, Z, OPENING = range(5)
"""Of a configuration: where the piece stands, its heading, how much higher than on the map it is, and how far
it is open (rad or m)."""


@dataclass(frozen=True)
class Cabinet:
    """The boxes of a piece that opens, for comparison with points.

    Attributes:
        piece: From the map; where it stands there is the zero of a configuration's first four parts.
    """

    piece: Furniture

    @cached_property
    def fixed(self) -> tuple[Array, Array]:
        """Middles and half edges of what does not move, in the piece's frame, shape (k, 3) each."""
        boxes = fixed_boxes(self.piece)
        return np.array([place for _, _, place in boxes]), 0.5 * np.array([size for _, size, _ in boxes])

    @cached_property
    def moving(self) -> tuple[MovingSolid, ...]:
        """The front first, then what goes with it; without the handle, which is measured."""
        return tuple(solid for solid in moving_solids(self.piece) if not solid.grasped)

    @cached_property
    def moving_boxes(self) -> tuple[Array, Array]:
        """Middles and half edges of the moving boxes in the moving part's frame, shape (k, 3) each."""
        boxes = [(solid.part_T_solid[:3, 3], solid.shape) for solid in self.moving]
        sizes = [shape.size_m for _, shape in boxes if isinstance(shape, Box)]
        return np.array([place for place, _ in boxes]), 0.5 * np.array(sizes)

    @property
    def is_door(self) -> bool:
        """Whether it turns; else it slides."""
        return self.moving[0].kind == DOOR

    @property
    def widest(self) -> float:
        """How far it can open, rad or m."""
        return opens_to(self.piece)

    def odom_T_piece(self, config: Array) -> Transform:
        """The piece's own frame, shape (4, 4)."""
        x, y = self.piece.position_m
        turn = poses.rotation_z(self.piece.yaw_rad + float(config[YAW]))
        return poses.transform(turn, (x + float(config[X]), y + float(config[Y]), float(config[Z])))

    def piece_T_part(self, opening: float) -> Transform:
        """The moving part's frame in the piece's, shape (4, 4)."""
        return np.asarray(furniture_T_part(self.piece) @ opened(self.piece, opening))

    def odom_T_front(self, config: Array) -> Transform:
        """The front's solid, x inwards, shape (4, 4)."""
        part = self.odom_T_piece(config) @ self.piece_T_part(float(config[OPENING]))
        return np.asarray(part @ self.moving[0].part_T_solid)

    def motion_at(self, points: Array, opening: float) -> Array:
        """How places on the moving part, in the piece's frame, move when it opens, shape (n, 3)."""
        moved = np.zeros_like(points)
        if not self.is_door:
            moved[:, 0] = -1.0
            return moved
        arm = points - self.piece_T_part(opening)[:3, 3]
        turn = -hinge_side(self.piece)
        moved[:, 0], moved[:, 1] = -turn * arm[:, 1], turn * arm[:, 0]
        return moved


def local_in(points: Array, pose: Transform) -> Array:
    """Points in the frame of a pose, both in one frame, shape (n, 3)."""
    return np.asarray((points - pose[:3, 3]) @ pose[:3, :3])


@dataclass(frozen=True, slots=True)
class Nearest(InFloat64):
    """For some points the nearest face of some boxes that looks where they do.

    Attributes:
        off_m: Signed distance from that face along its normal, shape (n,).
        normal: Outward, in the boxes' frame, shape (n, 3).
        away_m: Distance from the face, shape (n,).
    """

    off_m: Array
    normal: Array
    away_m: Array


def nearest_face(points: Array, normals: Array, middles: Array, halves: Array) -> Nearest:
    """The face of many boxes that a point of a surface belongs to.

    Args:
        points: In the boxes' frame, shape (n, 3).
        normals: Of the surface there, shape (n, 3).
        middles, halves: Of the boxes, shape (k, 3) each.
    """
    rows = np.arange(len(points))
    axis = np.abs(normals).argmax(axis=1)
    side = np.where(normals[rows, axis] < 0.0, -1.0, 1.0)
    local = points[:, None] - middles[None]
    off = side[:, None] * local[rows, :, axis] - halves[:, axis].T
    beside = np.maximum(np.abs(local) - halves[None], 0.0)
    beside[rows, :, axis] = 0.0
    away = np.sqrt(off**2 + (beside**2).sum(axis=2))
    box = away.argmin(axis=1)
    outward = np.zeros_like(points)
    outward[rows, axis] = side
    return Nearest(off[rows, box], outward, away[rows, box])


def surface_m(points: Array, middles: Array, halves: Array) -> Array:
    """Distance of points from the surface of the nearest of many boxes, shape (n,).

    Args:
        points: In the boxes' frame, shape (n, 3).
        middles, halves: As for ``nearest_face``.
    """
    columns = points.astype(np.float32).T
    nearest = np.full(len(points), np.inf, dtype=np.float32)
    for middle, half in zip(middles.astype(np.float32), halves.astype(np.float32), strict=True):
        x, y, z = (np.abs(columns[k] - middle[k]) - half[k] for k in range(3))
        inside = np.maximum(np.maximum(x, y), z)
        squared = np.maximum(x, 0.0) ** 2 + np.maximum(y, 0.0) ** 2 + np.maximum(z, 0.0) ** 2
        nearest = np.minimum(nearest, np.where(inside > 0.0, np.sqrt(squared), -inside))
    return nearest.astype(np.float64)
