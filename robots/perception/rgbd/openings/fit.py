"""Where a piece that opens stands and how far it is open: what explains the points and what is seen past it.

Openings are tried one after the other; the best are refined together with the piece's place by damped
Gauss-Newton steps on the distances of points from the faces of its boxes, and of its upright edges from where
depth jumps. The map's error is the prior.
"""

from __future__ import annotations

import itertools
import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array, InFloat64
from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from robots.perception.rgbd.openings.cabinet import (
    OPENING,
    YAW,
    Cabinet,
    Nearest,
    X,
    Y,
    Z,
    local_in,
    nearest_face,
    surface_m,
)
from robots.perception.rgbd.openings.outline import nearest_edges
from robots.perception.rgbd.openings.view import View
from robots.perception.surface import surface_points

_AHEAD_M, _ASIDE_M = (-0.08, 0.0, 0.08), (-0.16, -0.08, 0.0, 0.08, 0.16)
"""From so far about where it is believed to be a piece is looked for; its front shows how far away it is."""
_ABOUT_M = tuple(0.016 * k for k in range(-5, 6))
_FOUND_WITHIN_M = 0.04
_SEARCH_M = 0.08
_SEARCHED = 400
"""Points that are enough to choose where to begin."""
_EDGES_COUNT = 0.3
_MEASUREMENTS = 150.0
"""The points count as so many that err each on its own, against the map."""
_OPEN_COSTS = 1.5
"""What is closed on the map is open only where that explains more."""
_STEP = {True: math.radians(6.0), False: 0.03}
"""Openings that are tried, of doors and of drawers."""
_REFINED, _REFINED_WIDE = 2, 5
_NEAR_M = (0.06, 0.05, 0.04, 0.03, 0.02, 0.015)
"""A point belongs to a face within this, from step to step."""
_UNEXPLAINED_M = 0.04
_FACES_ALIKE = 0.75
_BEHIND_M = 0.08
_SEEN_PAST = 3.0
"""A place that is seen past weighs as so many points that nothing explains."""
_EDGE_M = 0.006
_COUNTS_AS = 60.0
"""Neighbours err together: the points of a face count as so many."""
_CLOSED = {True: math.radians(1.2), False: 0.012}
"""Standard deviation of how far open what is closed seems."""
LEAST_POINTS = 60


@dataclass(frozen=True, slots=True)
class Fit(InFloat64):
    """A piece as it is seen.

    Attributes:
        config: Where it stands and how far it is open, shape (5,); see ``cabinet``.
        covariance: Of the same, shape (5, 5).
        cost: Mean of the squared distances in shares of what counts as unexplained, in [0, 1] and more.
        points: How many it explains.
        front_seen: Share of the front that is where it should be, of what is in view and not hidden.
        front_places: How many places of it that share was made of.
    """

    config: Array
    covariance: Array
    cost: float
    points: int
    front_seen: float
    front_places: int


@dataclass(frozen=True, slots=True)
class Prior(InFloat64):
    """How well is known where a piece stands: standard deviations of X, Y, YAW and Z, shape (4,)."""

    sigma: Array

    @property
    def is_wide(self) -> bool:
        """Whether it may be too far off to be found from where it is believed to be."""
        return bool(self.sigma[X] > _FOUND_WITHIN_M)


ON_MAP = Prior(np.array([0.06, 0.06, 0.02, 0.006]))
"""Of a piece on the map, as seen by a robot that believes it stands somewhere on that."""
ON_SIGHT = Prior(np.array([0.03, 0.03, 0.012, 0.004]))
"""Of a piece that an earlier picture has shown; the odometry may have drifted since."""


def fit(cabinet: Cabinet, view: View, prior: Prior = ON_MAP) -> Fit | None:
    """The best fit of a piece to a view; None when hardly anything of it is in view.

    Args:
        cabinet: The piece, where it is believed to be.
        view: What may show it.
        prior: How well that is known.
    """
    if len(view.points) < LEAST_POINTS:
        return None
    few = view.thinned(_SEARCHED)
    openings = np.arange(0.0, cabinet.widest + 1e-6, _STEP[cabinet.is_door])
    shifts = itertools.product(_AHEAD_M, _ASIDE_M) if prior.is_wide else [(0.0, 0.0)]
    starts: list[tuple[float, Array]] = []
    for ahead, aside in shifts:
        start = np.zeros(5)
        start[:2] = (poses.rotation_z(cabinet.piece.yaw_rad) @ [ahead, aside, 0.0])[:2]
        local = local_in(few.points, cabinet.odom_T_piece(start))
        fixed = surface_m(local, *cabinet.fixed)
        tried = [
            (_cost(cabinet, few, config, prior, local, fixed, _SEARCH_M), config)
            for config in (_with(start, float(value)) for value in openings)
        ]
        # from each place the best, from where it is believed to be some more, and closed
        best = sorted(tried, key=lambda one: one[0])
        starts += best[:1] if ahead or aside else [*best[:_REFINED], tried[0]]
    starts = sorted(starts, key=lambda one: one[0])[: _REFINED_WIDE if prior.is_wide else None]
    configs = [config for _, config in starts]
    if prior.is_wide:
        configs = [_shifted(cabinet, few, config, prior) for config in configs]
    found = min((_refined(cabinet, view, config, prior) for config in configs), key=lambda one: one.cost)
    return found if found.points >= LEAST_POINTS else None


def _shifted(cabinet: Cabinet, view: View, config: Array, prior: Prior) -> Array:
    """The best of some places about one, along the piece's depth, then along its width, then once more."""
    turn = poses.rotation_z(cabinet.piece.yaw_rad)[:2, :2]
    for axis in (0, 1, 0):
        places = [config.copy() for _ in _ABOUT_M]
        for place, by in zip(places, _ABOUT_M, strict=True):
            place[:2] += by * turn[:, axis]
        config = min(places, key=lambda one: _cost(cabinet, view, one, prior))
    return config


def _with(config: Array, opening: float) -> Array:
    changed = config.copy()
    changed[OPENING] = opening
    return changed


def _faces(cabinet: Cabinet, view: View, config: Array) -> tuple[Nearest, NDArray[np.bool_]]:
    """The face that each point belongs to, with its normal in the piece's frame, and whether it moves."""
    pose, part = cabinet.odom_T_piece(config), cabinet.piece_T_part(float(config[OPENING]))
    local, normals = local_in(view.points, pose), view.normals @ pose[:3, :3]
    fixed = nearest_face(local, normals, *cabinet.fixed)
    moving = nearest_face(local_in(local, part), normals @ part[:3, :3], *cabinet.moving_boxes)
    moves = moving.away_m < fixed.away_m
    return (
        Nearest(
            np.where(moves, moving.off_m, fixed.off_m),
            np.where(moves[:, None], moving.normal @ part[:3, :3].T, fixed.normal),
            np.where(moves, moving.away_m, fixed.away_m),
        ),
        moves,
    )


def _cost(
    cabinet: Cabinet,
    view: View,
    config: Array,
    prior: Prior,
    local: Array | None = None,
    fixed: Array | None = None,
    unexplained_m: float = _UNEXPLAINED_M,
) -> float:
    """How badly it explains the points, how much of it is seen past, and how far it is from the map.

    Args:
        cabinet, view: What is compared.
        config: Where and how far open.
        prior: How well its place is known.
        local, fixed: The points in the piece's frame, and their distances from what does not move, where
            those will do for a search; else points are compared with faces that look where they do.
        unexplained_m: What is farther than this from all of it is not explained.
    """
    if local is None or fixed is None:
        away = _from_faces(cabinet, view, config)
    else:
        part = cabinet.piece_T_part(float(config[OPENING]))
        away = np.minimum(fixed, surface_m(local_in(local, part), *cabinet.moving_boxes))
    unexplained = np.minimum(away / unexplained_m, 1.0) ** 2
    agree, past, _ = _front(cabinet, view, config)
    moved = float(((config[:4] / prior.sigma) ** 2).sum())
    opened = _OPEN_COSTS if config[OPENING] > _CLOSED[cabinet.is_door] else 0.0
    data = float((unexplained.sum() + _SEEN_PAST * past) / (len(away) + agree + past))
    edges = nearest_edges(cabinet, view, config, _UNEXPLAINED_M)
    if edges:  # a front that fills the picture shows none
        off = np.concatenate([near.away_m for near in edges])
        data += _EDGES_COUNT * float((np.minimum(off / _UNEXPLAINED_M, 1.0) ** 2).mean())
    return data + (moved + opened) / _MEASUREMENTS


def _from_faces(cabinet: Cabinet, view: View, config: Array) -> Array:
    """Distances of points from faces that look where they do, infinite where none does, shape (n,)."""
    face, _ = _faces(cabinet, view, config)
    alike = (face.normal @ cabinet.odom_T_piece(config)[:3, :3].T * view.normals).sum(axis=1) > _FACES_ALIKE
    return np.where(alike, face.away_m, np.inf)[view.normals.any(axis=1)]


def _front(cabinet: Cabinet, view: View, config: Array) -> tuple[float, float, int]:
    """Of places on the front how many are seen there and seen past, weighed as points are, and their sum."""
    shape = cabinet.moving[0].shape
    if not isinstance(shape, Box):
        return 0.0, 0.0, 0
    pose = cabinet.odom_T_front(config)
    points, normals = surface_points(shape)
    world = points @ pose[:3, :3].T + pose[:3, 3]
    facing = ((view.eye - world) * (normals @ pose[:3, :3].T)).sum(axis=1) > 0.0
    shown, z = view.depth_at(world[facing])
    there = shown > 0.0
    agree = int((there & (np.abs(shown - z) < _BEHIND_M)).sum())
    past = int((there & (shown > z + _BEHIND_M)).sum())
    weight = len(view.points) / 200.0
    return agree * weight, past * weight, agree + past


def _refined(cabinet: Cabinet, view: View, config: Array, prior: Prior) -> Fit:
    config = config.copy()
    closed = config[OPENING] == 0.0
    opening_sigma = _CLOSED[cabinet.is_door] if closed else 10.0 * _STEP[cabinet.is_door]
    believed = _with(np.zeros(5), float(config[OPENING]))
    known = np.diag(1.0 / np.array([*prior.sigma, opening_sigma]) ** 2)
    normal_matrix, used = known, 0
    for near_m in _NEAR_M:
        jacobian, residual, weight, used = _measured(cabinet, view, config, near_m)
        edges = _along_edges(cabinet, view, config, max(near_m, 0.03))
        jacobian = np.concatenate([jacobian, edges[0]])
        residual, weight = np.concatenate([residual, edges[1]]), np.concatenate([weight, edges[2]])
        normal_matrix = (jacobian * weight[:, None]).T @ jacobian + known
        right = -(jacobian * weight[:, None]).T @ residual - known @ (config - believed)
        config = _stepped(config, normal_matrix, right, cabinet.widest)
    covariance = np.linalg.inv(normal_matrix)
    agree, past, places = _front(cabinet, view, config)
    seen = agree / (agree + past) if agree + past > 0.0 else 0.0
    return Fit(
        config,
        np.asarray(covariance, dtype=np.float64),
        _cost(cabinet, view, config, prior),
        used,
        seen,
        places,
    )


def _stepped(config: Array, normal_matrix: Array, right: Array, widest: float) -> Array:
    """The next configuration; an opening that would leave its range stays at the end, the rest without it."""
    step = np.linalg.solve(normal_matrix, right)
    opening = float(config[OPENING] + step[OPENING])
    if not 0.0 <= opening <= widest:
        end = min(max(opening, 0.0), widest) - float(config[OPENING])
        rest = [X, Y, YAW, Z]
        step[OPENING] = end
        step[rest] = np.linalg.solve(
            normal_matrix[np.ix_(rest, rest)], right[rest] - normal_matrix[rest, OPENING] * end
        )
    return np.asarray(config + step)


def _measured(cabinet: Cabinet, view: View, config: Array, near_m: float) -> tuple[Array, Array, Array, int]:
    """Distances of points from their faces, with derivatives by the configuration and weights."""
    face, moves = _faces(cabinet, view, config)
    outward = face.normal @ cabinet.odom_T_piece(config)[:3, :3].T
    alike = (outward * view.normals).sum(axis=1) > _FACES_ALIKE
    near = (face.away_m < near_m) & alike
    points, outward, off, moves = view.points[near], outward[near], face.off_m[near], moves[near]
    jacobian = _derivatives(cabinet, points, outward, moves, config)
    sigma = view.sigma_m[near] + 0.002
    scale = np.maximum(3.0 * sigma, 0.5 * near_m)  # wide first: the start is no outlier
    weight = 1.0 / (1.0 + (off / scale) ** 2) ** 2 / sigma**2
    # the faces are told apart by where they look, and by whether they move
    looks = np.round(face.normal[near] * 2.0).astype(np.int64) @ np.array([1, 10, 100]) + 1000 * moves
    _, which, counts = np.unique(looks, return_inverse=True, return_counts=True)
    weight *= np.minimum(_COUNTS_AS / counts, 1.0)[which]
    return jacobian, off, weight, int(near.sum())


def _derivatives(
    cabinet: Cabinet, points: Array, outward: Array, moves: NDArray[np.bool_], config: Array
) -> Array:
    """Of distances along outward normals, by the configuration, shape (n, 5)."""
    pose = cabinet.odom_T_piece(config)
    arm = points[:, :2] - pose[:2, 3]
    jacobian = np.zeros((len(points), 5))
    jacobian[:, X], jacobian[:, Y], jacobian[:, Z] = -outward.T
    jacobian[:, YAW] = -(outward[:, 1] * arm[:, 0] - outward[:, 0] * arm[:, 1])
    local = (points - pose[:3, 3]) @ pose[:3, :3]
    motion = cabinet.motion_at(local, float(config[OPENING])) @ pose[:3, :3].T
    jacobian[:, OPENING] = np.where(moves, -(outward * motion).sum(axis=1), 0.0)
    return jacobian


def _along_edges(cabinet: Cabinet, view: View, config: Array, near_m: float) -> tuple[Array, Array, Array]:
    """Distances of the outline from edges, with derivatives by the configuration and weights."""
    jacobians, residuals = [np.zeros((0, 5))], [np.zeros(0)]
    for near in nearest_edges(cabinet, view, config, near_m):
        good = near.away_m < near_m
        jacobians.append(
            _derivatives(cabinet, near.points[good], near.outward[good], near.moves[good], config)
        )
        residuals.append(near.beyond_m[good])
    jacobian, residual = np.concatenate(jacobians), np.concatenate(residuals)
    weight = 1.0 / (1.0 + (residual / max(3.0 * _EDGE_M, 0.5 * near_m)) ** 2) ** 2 / _EDGE_M**2
    return jacobian, residual, weight * min(1.0, 40.0 / max(len(residual), 1))
