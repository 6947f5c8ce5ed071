"""Smooth curves through free coordinates, over a parameter from 0 to 1."""

from __future__ import annotations

from typing import Protocol

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


class Curve(Protocol):
    """A smooth curve."""

    def __call__(self, s: Array) -> Array:
        """Points at parameters ``s``, shape (n,), each in [0, 1]; result shape (n, size)."""
        ...


class PolynomialCurve:
    """The polynomial of least degree through a few points at equally spaced parameters.

    Args:
        points: Shape (k, size), k from 2 to 5; more would ring.
    """

    def __init__(self, points: Array) -> None:
        k = len(points)
        if not 2 <= k <= 5:
            raise ValueError(f"a polynomial curve takes 2 to 5 points, got {k}")
        powers = np.vander(np.linspace(0.0, 1.0, k), increasing=True)
        self._coefficients = np.linalg.solve(powers, points)

    def __call__(self, s: Array) -> Array:
        """Points at parameters ``s``."""
        return np.asarray(np.vander(s, len(self._coefficients), increasing=True) @ self._coefficients)


class RoundedPolyline:
    """A polyline whose corners are rounded: a uniform cubic B-spline over points along it.

    It starts and ends at the polyline's ends, runs along its straight parts, and leaves it near a
    corner by less than ``spacing``.

    Args:
        points: Corners, shape (k, size), k >= 2.
        weights: Of the coordinates in the length, shape (size,).
        spacing: Distance of control points along the polyline.
    """

    def __init__(self, points: Array, weights: Array, spacing: float) -> None:
        steps = np.sqrt(np.sum((np.diff(points, axis=0) * weights) ** 2, axis=1))
        keep = np.concatenate([[True], steps > 1e-9])
        points, steps = points[keep], steps[keep[1:]]
        along = np.concatenate([[0.0], np.cumsum(steps)])
        count = max(4, int(np.ceil(along[-1] / spacing)) + 1)
        at = np.linspace(0.0, along[-1], count)
        control = np.stack([np.interp(at, along, column) for column in points.T], axis=1)
        # phantom ends: the spline passes through the first and the last control point
        first, last = 2.0 * control[0] - control[1], 2.0 * control[-1] - control[-2]
        self._control = np.concatenate([[first], control, [last]])
        self._segments = count - 1

    def __call__(self, s: Array) -> Array:
        """Points at parameters ``s``."""
        position = np.clip(s, 0.0, 1.0) * self._segments
        k = np.minimum(position.astype(int), self._segments - 1)
        u = (position - k)[:, None]
        c = self._control
        return np.asarray(
            ((1.0 - u) ** 3) / 6.0 * c[k]
            + (3.0 * u**3 - 6.0 * u**2 + 4.0) / 6.0 * c[k + 1]
            + (-3.0 * u**3 + 3.0 * u**2 + 3.0 * u + 1.0) / 6.0 * c[k + 2]
            + u**3 / 6.0 * c[k + 3]
        )
