"""Outlines in a picture, and the edges of boxes that they may be."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array, InFloat64
from robots.perception.rgbd.openings.cabinet import OPENING, Cabinet, local_in
from robots.perception.rgbd.openings.view import View

_BESIDE_EDGE_M = 0.015


@dataclass(frozen=True, slots=True)
class NearestEdge(InFloat64):
    """For some points of an outline the nearest edge of a box.

    Attributes:
        points: In the odometry frame, shape (n, 3).
        away_m: Distance from the edge, infinite where none is near, shape (n,).
        beyond_m: How far beyond the face that ends there, shape (n,).
        outward: Of that face, in the odometry frame, shape (n, 3).
        moves: Whether the box does, shape (n,).
    """

    points: Array
    away_m: Array
    beyond_m: Array
    outward: Array
    moves: NDArray[np.bool_]


def nearest_edges(cabinet: Cabinet, view: View, config: Array, near_m: float) -> list[NearestEdge]:
    """Of the outlines at the sides the nearest upright edges, of those above and below level ones."""
    body, part = cabinet.odom_T_piece(config), cabinet.piece_T_part(float(config[OPENING]))
    found = []
    for edges, axis in ((view.edges, 1), (view.level_edges, 0)):
        if not len(edges):
            continue
        local = local_in(edges, body)
        best = np.full(len(edges), np.inf)
        off, side, moves = np.zeros(len(edges)), np.ones(len(edges)), np.zeros(len(edges), np.bool_)
        for points, (middles, halves), moving in (
            (local, cabinet.fixed, False),
            (local_in(local, part), cabinet.moving_boxes, True),
        ):
            inner = points[:, None] - middles[None]
            away, beyond = _from_edge(inner, halves, axis)
            box, rows = away.argmin(axis=1), np.arange(len(edges))
            nearer = away[rows, box] < np.minimum(best, near_m)
            best = np.where(nearer, away[rows, box], best)
            off = np.where(nearer, beyond[rows, box], off)
            side = np.where(nearer, np.sign(inner[rows, box, axis]), side)
            moves = np.where(nearer, moving, moves)
        axes = np.where(moves[:, None], (body[:3, :3] @ part[:3, axis])[None], body[None, :3, axis])
        found.append(NearestEdge(edges, best, off, side[:, None] * axes, moves))
    return found


def _from_edge(inner: Array, halves: Array, axis: int) -> tuple[Array, Array]:
    """How far places are from the upright (axis 1) or upper level (axis 0) edges of boxes; shape (n, k).

    Infinite where they are beside these. With it how far they are beyond the face along that axis.

    Args:
        inner: Places from the middles of boxes, in their frame, shape (n, k, 3).
        halves: Half edges of the boxes, shape (k, 3).
        axis: 1 or 0.
    """
    beyond = np.abs(inner[..., axis]) - halves[:, axis]
    if axis == 1:
        across = np.abs(np.abs(inner[..., 0]) - halves[:, 0])
        along = np.abs(inner[..., 2]) - halves[:, 2]
    else:
        across = np.abs(inner[..., 2] - halves[:, 2])
        along = np.abs(inner[..., 1]) - halves[:, 1]
    beside = (across > _BESIDE_EDGE_M) | (along > -0.02)
    return np.where(beside, np.inf, np.abs(beyond)), beyond
