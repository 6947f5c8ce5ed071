"""Fits upright solids to what is measured of many things at once.

Each kind of solid is a signed distance with its derivatives. Points on a surface have distance 0, and so
has the nearest point of each ray that grazes the outline; what makes both so is found by damped Gauss-Newton
steps with weights that leave outliers out.
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array, InFloat64
from robots.perception.rgbd.samples import Samples

STEPS = 8
_ALONG = 12
"""Places along each grazing ray among which its nearest is looked for."""
_FIRST_M, _AGAIN_M = 0.16, 0.019
"""So far to either side of where it is thought to be the nearest is looked for: while the solid still moves
far, and then about what the step before found."""
_FAR_STEPS = 2
LEAST_M, MOST_M = 0.008, 0.45
_ALIKE_M = 0.02
_WORST = 4.0
_PER_PARAMETER = 0.06


class Distance(Protocol):
    """The signed distance of points from solids of one kind."""

    def __call__(self, points: Array, parameters: Array, slopes: bool = True) -> tuple[Array, Array]:
        """Distances, shape (k, n), and their derivatives by the parameters, shape (k, n, p).

        Args:
            points: Shape (k, n, 3).
            parameters: Of the solids, shape (k, p).
            slopes: Whether the derivatives are wanted; else they are empty.
        """
        ...


_NO_SLOPES = np.zeros((0, 0, 0))


@dataclass(frozen=True, slots=True)
class Fit(InFloat64):
    """One kind of solid, fitted to k things.

    Attributes:
        parameters: Shape (k, p).
        covariance: Of the parameters, from the residuals, shape (k, p, p).
        score: How badly it fits; 1 is what noise alone makes, shape (k,).
        points_m: Distances of the points from the solid, shape (k, n).
    """

    parameters: Array
    covariance: Array
    score: Array
    points_m: Array

    def with_some(self, which: NDArray[np.bool_], anew: Fit) -> Fit:
        """With some things, ``which`` has shape (k,), as they were fitted anew."""
        made = []
        for part in fields(self):
            values = getattr(self, part.name).copy()
            values[which] = getattr(anew, part.name)
            made.append(values)
        return Fit(*made)


def cylinder_distance(points: Array, parameters: Array, slopes: bool = True) -> tuple[Array, Array]:
    """Of an upright cylinder on the ground: centre x, y, radius, height."""
    cx, cy, radius, height = (parameters[:, i, None] for i in range(4))
    dx, dy = points[..., 0] - cx, points[..., 1] - cy
    away = np.sqrt(dx * dx + dy * dy) + 1e-9
    side = away - radius
    up = np.abs(points[..., 2] - 0.5 * height) - 0.5 * height
    if not slopes:
        return _outer(np.maximum(side, 0.0) ** 2 + np.maximum(up, 0.0) ** 2, np.maximum(side, up)), _NO_SLOPES
    top = -0.5 * (np.sign(points[..., 2] - 0.5 * height) + 1.0)
    distance, by_side, by_up = _outside(side, up)
    zero = np.zeros_like(side)
    gradient = np.stack([-by_side * dx / away, -by_side * dy / away, -by_side + zero, by_up * top], axis=-1)
    return distance, gradient


def box_distance(points: Array, parameters: Array, slopes: bool = True) -> tuple[Array, Array]:
    """Of an upright box on the ground: centre x, y, heading, half its edges, height."""
    cx, cy, yaw, a, b, height = (parameters[:, i, None] for i in range(6))
    c, s = np.cos(yaw), np.sin(yaw)
    dx, dy = points[..., 0] - cx, points[..., 1] - cy
    qx, qy = c * dx + s * dy, c * dy - s * dx
    ex, ey = np.abs(qx) - a, np.abs(qy) - b
    up = np.abs(points[..., 2] - 0.5 * height) - 0.5 * height
    nearest = np.maximum(np.maximum(ex, ey), up)
    px, py, pz = np.maximum(ex, 0.0), np.maximum(ey, 0.0), np.maximum(up, 0.0)
    squares = px * px + py * py + pz * pz
    if not slopes:
        return _outer(squares, nearest), _NO_SLOPES
    top = -0.5 * (np.sign(points[..., 2] - 0.5 * height) + 1.0)
    norm = np.sqrt(squares)
    out = nearest > 0.0
    safe = np.where(norm > 1e-12, norm, 1.0)
    wx = np.where(out, px / safe, (ex >= nearest).astype(np.float64))
    wy = np.where(out, py / safe, ((ey >= nearest) & (ex < nearest)).astype(np.float64))
    wz = np.where(out, pz / safe, ((up >= nearest) & (ex < nearest) & (ey < nearest)).astype(np.float64))
    distance = np.where(out, norm, nearest)
    sx, sy = np.sign(qx) * wx, np.sign(qy) * wy
    gradient = np.stack([-c * sx + s * sy, -s * sx - c * sy, sx * qy - sy * qx, -wx, -wy, wz * top], axis=-1)
    return distance, gradient


def ball_distance(points: Array, parameters: Array, slopes: bool = True) -> tuple[Array, Array]:
    """Of a ball on the ground: centre x, y, radius."""
    cx, cy, radius = (parameters[:, i, None] for i in range(3))
    dx, dy, dz = points[..., 0] - cx, points[..., 1] - cy, points[..., 2] - radius
    away = np.sqrt(dx * dx + dy * dy + dz * dz) + 1e-9
    if not slopes:
        return away - radius, _NO_SLOPES
    gradient = np.stack([-dx / away, -dy / away, -dz / away - 1.0], axis=-1)
    return away - radius, gradient


def _outer(squares: Array, nearest: Array) -> Array:
    """The distance outside a solid, and that to its nearest face inside."""
    return np.asarray(np.where(nearest > 0.0, np.sqrt(squares), nearest))


def _outside(side: Array, up: Array) -> tuple[Array, Array, Array]:
    """The distance of a solid whose section is a rectangle, and its derivatives by both excesses."""
    ps, pu = np.maximum(side, 0.0), np.maximum(up, 0.0)
    norm = np.sqrt(ps * ps + pu * pu)
    nearest = np.maximum(side, up)
    out = nearest > 0.0
    safe = np.where(norm > 1e-12, norm, 1.0)
    by_side = np.where(out, ps / safe, (side >= up).astype(np.float64))
    by_up = np.where(out, pu / safe, (up > side).astype(np.float64))
    return np.where(out, norm, nearest), by_side, by_up


def fit(
    samples: Samples, start: Array, distance: Distance, sizes: slice, alike: tuple[int, int] | None = None
) -> Fit:
    """Fit one kind of solid to every thing.

    Args:
        samples: What is measured.
        start: First guess, shape (k, p).
        distance: Of the solid.
        sizes: Which parameters are lengths that stay within reason.
        alike: Two parameters that are taken to be alike as far as nothing that is measured tells them: the
            edges of a box of which one face is seen.
    """
    parameters = start.copy()
    count = parameters.shape[1]
    damping = np.full(len(parameters), 1e-3)
    eye = np.eye(count)[None]
    reach = samples.reach_m
    for step in range(STEPS):
        # first with wide tolerance, so that a bad guess is not taken for outliers
        wide = 3.0 if step < 2 else 1.5 if step < 4 else 1.0
        if step < _FAR_STEPS:
            reach = _nearest(samples, samples.reach_m, parameters, distance, _FIRST_M)
        reach = _nearest(samples, reach, parameters, distance, _AGAIN_M)
        residual, gradient, weight, _ = _measured(samples, reach, parameters, distance, wide)
        weighted = gradient * weight[..., None]
        normal = weighted.transpose(0, 2, 1) @ gradient
        right = (weighted.transpose(0, 2, 1) @ residual[..., None])[..., 0]
        if alike is not None:
            _assume_alike(normal, right, parameters, alike)
        scale = np.maximum(np.einsum("kpp->kp", normal), 1e2)
        change = np.linalg.solve(normal + damping[:, None, None] * eye * scale[:, None], -right[..., None])[
            ..., 0
        ]
        parameters += np.clip(change, -0.03, 0.03)
        parameters[:, sizes] = np.clip(parameters[:, sizes], LEAST_M, MOST_M)
    reach = _nearest(samples, reach, parameters, distance, _AGAIN_M)
    residual, gradient, weight, points_m = _measured(samples, reach, parameters, distance, 1.0)
    weighted = gradient * weight[..., None]
    information: Array = weighted.transpose(0, 2, 1) @ gradient + eye
    if alike is not None:
        _assume_alike(information, np.zeros_like(parameters), parameters, alike)
    sigma = np.concatenate([samples.sigma_m, samples.ray_sigma_m], axis=1)
    valid = np.concatenate([samples.weight, samples.ray_weight], axis=1)
    scaled = np.minimum(np.abs(residual) / sigma, _WORST)
    score = (scaled**2 * valid).sum(axis=1) / np.maximum(valid.sum(axis=1), 1.0) + _PER_PARAMETER * count
    covariance = np.asarray(np.linalg.inv(information), dtype=np.float64)
    return Fit(parameters, covariance, score, points_m)


def _assume_alike(normal: Array, right: Array, parameters: Array, pair: tuple[int, int]) -> None:
    """Add to the equations that two parameters differ by no more than usual."""
    i, j = pair
    weight = 1.0 / _ALIKE_M**2
    normal[:, [i, j], [i, j]] += weight
    normal[:, [i, j], [j, i]] -= weight
    off = parameters[:, i] - parameters[:, j]
    right[:, i] += weight * off
    right[:, j] -= weight * off


def _measured(
    samples: Samples, reach_m: Array, parameters: Array, distance: Distance, wide: float
) -> tuple[Array, Array, Array, Array]:
    """Residuals, their derivatives and weights of points and rays together, and those of the points."""
    nearest = samples.eye[:, None] + reach_m[..., None] * samples.rays
    residual, gradient = distance(np.concatenate([samples.points, nearest], axis=1), parameters)
    sigma = wide * np.concatenate([samples.sigma_m, samples.ray_sigma_m], axis=1)
    valid = np.concatenate([samples.weight, samples.ray_weight], axis=1)
    off = (residual / (2.0 * sigma)) ** 2
    weight = valid / (sigma * sigma * (1.0 + off) ** 2)
    return residual, gradient, weight, residual[:, : samples.points.shape[1]]


def _nearest(
    samples: Samples, about_m: Array, parameters: Array, distance: Distance, around_m: float
) -> Array:
    """How far along each ray its nearest place to a solid is, shape (k, m).

    Args:
        samples: With the rays.
        about_m: Where it is about, shape (k, m).
        parameters: Of the solids.
        distance: From them.
        around_m: So far to either side it is looked for.
    """
    k, m = about_m.shape
    spread = np.linspace(-around_m, around_m, _ALONG)
    along = about_m[..., None] + spread
    places = samples.eye[:, None, None] + along[..., None] * samples.rays[:, :, None]
    near = distance(places.reshape(k, m * _ALONG, 3), parameters, False)[0].reshape(k * m, _ALONG)
    best = np.clip(near.argmin(axis=1), 1, _ALONG - 2)
    rows = np.arange(k * m)
    low, mid, high = near[rows, best - 1], near[rows, best], near[rows, best + 1]
    bend = np.maximum(low - 2.0 * mid + high, 1e-12)
    shift = np.clip(0.5 * (low - high) / bend, -1.0, 1.0)
    return np.asarray(about_m + (spread[best] + shift * (spread[1] - spread[0])).reshape(k, m))


def visible_side(samples: Samples, middle: Array, height: Array) -> NDArray[np.bool_]:
    """Which points can be on the outside of an upright round thing: its back is out of sight.

    Args:
        samples: What is measured.
        middle: Of each thing, shape (k, 2).
        height: Of each, shape (k,).
    """
    towards = samples.eye[:, :2] - middle
    towards /= np.linalg.norm(towards, axis=1, keepdims=True)
    side = ((samples.points[..., :2] - middle[:, None]) * towards[:, None]).sum(axis=2)
    top = samples.points[..., 2] > height[:, None] - np.maximum(0.008, 3.0 * samples.sigma_m)
    return np.asarray((side > -0.15 * np.maximum(height, 0.05)[:, None]) | top)
