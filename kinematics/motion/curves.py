"""Smooth curves through free coordinates, over a parameter from 0 to 1."""

from __future__ import annotations

import itertools
import math
from typing import Protocol

import numpy as np

from kinematics.arrays import Array

# How far lines stray from a rounded corner, by the distance of control points: three lines between two
# knots at a right angle, whose second difference is the square root of 2 of that distance.
_STRAY = 2.0**0.5 / (8.0 * 3**2)
# A blend takes at most this share of a straight piece from each of its two ends.
LONGEST_BLEND = 0.5


# Coefficients of the polynomial through points at equally spaced parameters, by their number.
_INTERPOLATION = {k: np.linalg.inv(np.vander(np.linspace(0.0, 1.0, k), increasing=True)) for k in range(2, 6)}


class Curve(Protocol):
    """A curve without corners: its derivative is continuous, and bends smoothly between knots."""

    @property
    def knots(self) -> Array:
        """Rising parameters from 0 to 1 between which the curve is one polynomial, shape (m,), m >= 2."""
        ...

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
        self._coefficients = _INTERPOLATION[k] @ points
        self.knots = np.array([0.0, 1.0])

    def __call__(self, s: Array) -> Array:
        """Points at parameters ``s``."""
        return np.asarray(np.vander(s, len(self._coefficients), increasing=True) @ self._coefficients)


class BlendedPolyline:
    """A polyline whose corners are blended by parabolas that stay within a stated deviation.

    The parameter is the way along the straight pieces, so that a blend takes over with the direction
    and leaves with the direction of its neighbours. Method: Kunz and Stilman, "Time-optimal trajectory
    generation for path following with bounded acceleration and velocity", Robotics: Science and
    Systems 2012, with parabolas for arcs: their second derivative is constant.

    Args:
        points: Corners, shape (k, size), k >= 2.
        weights: Of the coordinates in lengths and in the deviation, shape (size,).
        deviation: No coordinate of the curve is farther from the polyline than this, weighted.
    """

    def __init__(self, points: Array, weights: Array, deviation: float) -> None:
        points, steps = _without_repeats(points, weights)
        if len(points) < 2:
            points, steps = np.stack([points[0], points[0]]), np.array([1.0])
        way = np.diff(points, axis=0) / steps[:, None]
        turn = np.max(np.abs(way[1:] - way[:-1]) * weights, axis=1, initial=0.0)
        room = LONGEST_BLEND * np.minimum(steps[1:], steps[:-1])
        reach = np.minimum(room, 4.0 * deviation / np.maximum(turn, 1e-12))
        self._length = float(steps.sum())
        corners = np.cumsum(steps)[:-1]
        reach = np.concatenate([[0.0], reach, [0.0]])
        corners = np.concatenate([[0.0], corners, [self._length]])
        # pieces in turn: straight, blend, straight, ..., straight
        starts = np.sort(np.concatenate([corners[:-1] + reach[:-1], corners[1:-1] - reach[1:-1]]))
        self._starts = starts
        size = points.shape[1]
        self._place = np.empty((len(starts), size))
        self._slope = np.repeat(way, 2, axis=0)[: len(starts)]
        self._bend = np.zeros((len(starts), size))
        self._place[0::2] = points[:-1] + way * reach[:-1, None]
        self._place[1::2] = points[1:-1] - way[:-1] * reach[1:-1, None]
        self._bend[1::2] = (way[1:] - way[:-1]) / (4.0 * np.maximum(reach[1:-1], 1e-12)[:, None])
        self._last = points[-1]
        knots = np.concatenate([starts, [self._length]]) / self._length
        self.knots = knots[np.concatenate([[True], np.diff(knots) > 1e-12])]
        self.knots[-1] = 1.0

    def __call__(self, s: Array) -> Array:
        """Points at parameters ``s``."""
        at = np.clip(s, 0.0, 1.0) * self._length
        k = np.searchsorted(self._starts, at, side="right") - 1
        u = (at - self._starts[k])[:, None]
        points = self._place[k] + u * (self._slope[k] + u * self._bend[k])
        points[s >= 1.0] = self._last
        return np.asarray(points)


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
        points, steps = _without_repeats(points, weights)
        along = np.concatenate([[0.0], np.cumsum(steps)])
        count = max(4, int(np.ceil(along[-1] / spacing)) + 1)
        self._segments = count - 1
        self.knots = np.arange(count) / self._segments
        self._weights, self._step = weights, along[-1] / self._segments
        self._corners = along[1:-1]
        if len(points) < 2:
            control = np.repeat(points, count, axis=0)
        else:
            at = self.knots * along[-1]
            row = np.searchsorted(along[1:-1], at, side="right")
            part = ((at - along[row]) / steps[row])[:, None]
            control = points[row] + part * (points[row + 1] - points[row])
            control[-1] = points[-1]
        # phantom ends: the spline passes through the first and the last control point
        first, last = 2.0 * control[:1] - control[1:2], 2.0 * control[-1:] - control[-2:-1]
        self._control = np.concatenate([first, control, last])

    def bends(self) -> list[Array]:
        """Points, shape (n, size) each, along the stretches where the curve leaves its polyline.

        Everywhere else it lies on it. Lines between neighbouring points stray from the curve no farther
        than three of them between two knots do at a right angle.
        """
        if len(self._corners) == 0:
            return []
        control = self._control
        turns = (control[2:] - 2.0 * control[1:-1] + control[:-2]) * self._weights
        # a cubic's second derivative is greatest at a knot, and there it is this difference
        bending = np.sqrt(np.sum(turns * turns, axis=1)) / (8.0 * _STRAY * self._step)
        places, ends = [], [0]
        for first, last in self._bent_segments():
            lines = max(1, math.ceil(math.sqrt(bending[first : last + 2].max())))
            count = lines * (last + 1 - first)
            places.append(first + np.arange(count + 1) / lines)
            ends.append(ends[-1] + count + 1)
        points = self._at(np.concatenate(places))
        return [points[begin:end] for begin, end in itertools.pairwise(ends)]

    def _bent_segments(self) -> list[tuple[int, int]]:
        """First and last segment of each stretch whose control points are not all on one straight part."""
        bent: list[tuple[int, int]] = []
        for corner in self._corners:
            before = int(corner / self._step)
            first, last = max(0, before - 1), min(self._segments - 1, before + 1)
            if bent and first <= bent[-1][1] + 1:
                first = bent.pop()[0]
            bent.append((first, last))
        return bent

    def __call__(self, s: Array) -> Array:
        """Points at parameters ``s``."""
        return self._at(np.clip(s, 0.0, 1.0) * self._segments)

    def _at(self, position: Array) -> Array:
        """Points by the number of the segment and the part of it that is behind them."""
        k = np.minimum(position.astype(int), self._segments - 1)
        u = (position - k)[:, None]
        v = 1.0 - u
        c, uu, vv = self._control, u * u, v * v
        first, last = vv * v / 6.0, uu * u / 6.0
        second, third = (4.0 - 3.0 * uu * (1.0 + v)) / 6.0, (4.0 - 3.0 * vv * (1.0 + u)) / 6.0
        return np.asarray(first * c[k] + second * c[k + 1] + third * c[k + 2] + last * c[k + 3])


def _without_repeats(points: Array, weights: Array) -> tuple[Array, Array]:
    """Corners that differ from the one before, and the weighted lengths between them."""
    steps = np.sqrt(np.sum((np.diff(points, axis=0) * weights) ** 2, axis=1))
    keep = np.concatenate([[True], steps > 1e-9])
    return points[keep], steps[keep[1:]]
