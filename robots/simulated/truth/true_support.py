"""The support polygon of the simulated robot, for judging its balance; not the robot's own idea of it."""

from __future__ import annotations

import math

import numpy as np

from kinematics.arrays import Array

MOVED_M = 0.0005
"""Corners that moved less than this keep the polygon that was made of them."""


class SupportPolygon:
    """Convex hull of sole corners, kept from call to call while the soles stay."""

    def __init__(self) -> None:
        self._corners = np.zeros((0, 2))
        self._points = np.zeros((0, 2))
        self._inward = np.zeros((0, 2))

    def margin_m(self, point: Array, corners: Array) -> float:
        """Distance of a point, shape (2,), to the nearest edge of the hull of corners, shape (n, 2).

        Positive inside; ``-inf`` when there are no corners.
        """
        if corners.shape[0] < 3:
            return -math.inf
        if corners.shape != self._corners.shape or np.abs(corners - self._corners).max() > MOVED_M:
            self._corners = corners
            self._points = convex_hull(corners)
            edges = np.roll(self._points, -1, axis=0) - self._points
            normals = np.stack([-edges[:, 1], edges[:, 0]], axis=1)
            self._inward = normals / np.linalg.norm(normals, axis=1, keepdims=True)
        distance = np.einsum("ij,ij->i", point - self._points, self._inward)
        return float(distance.min())


def convex_hull(points: Array) -> Array:
    """Corners of the convex hull of points, shape (n, 2), counter-clockwise (Andrew's monotone chain)."""
    ordered = sorted((float(x), float(y)) for x, y in points)

    def half(items: list[tuple[float, float]]) -> list[tuple[float, float]]:
        chain: list[tuple[float, float]] = []
        for x, y in items:
            while len(chain) > 1:
                (ax, ay), (bx, by) = chain[-2], chain[-1]
                if (bx - ax) * (y - ay) - (by - ay) * (x - ax) > 1e-12:
                    break
                chain.pop()
            chain.append((x, y))
        return chain[:-1]

    return np.array(half(ordered) + half(ordered[::-1]))
