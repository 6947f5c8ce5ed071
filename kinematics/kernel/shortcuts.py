"""Compiled: a way through the free coordinates made shorter, by lines that are proven to be free."""

from __future__ import annotations

import math

import numpy as np

from kinematics.arrays import Array, Indices
from kinematics.compiled.compiler import compiled, inlined
from kinematics.kernel.judge import FREE, judge_edge, judge_point
from kinematics.kernel.memory import Memory, problem_at, work_at

# Most points at which an edge is asked first.
_MOST_POINTS = 16
# A corner is cut off by the line between its neighbours, or between points so far on the way to them.
_CUTS = (1.0, 0.6, 0.3)
# How often all corners are gone through; cutting one off makes two.
_ROUNDS = 3


@inlined
def distance_of(a: Array, b: Array, weights: Array) -> float:
    """Weighted Euclidean distance of two points."""
    square = 0.0
    for k in range(a.shape[0]):
        step = (a[k] - b[k]) * weights[k]
        square += step * step
    return math.sqrt(square)


@compiled
def blocked(memory: Memory, a: Array, b: Array) -> bool:
    """Whether an edge is refused at one of a few points, the middle first; a point is cheap."""
    work, step = work_at(memory), problem_at(memory).tuning.point_step_rad
    widest = 0.0
    for k in range(a.shape[0]):
        widest = max(widest, abs(b[k] - a[k]))
    count = 1
    while count < _MOST_POINTS and widest > step * (count + 1):
        for i in range(count):
            t = (i + 0.5) / count
            for k in range(a.shape[0]):
                work.x[k] = a[k] + (b[k] - a[k]) * t
            if judge_point(memory, work.x)[0] != FREE:
                return True
        count *= 2
    return False


@inlined
def shortcut_is_proven(memory: Memory, a: Array, b: Array) -> bool:
    """Whether a line is proven without much effort."""
    tuning = problem_at(memory).tuning
    return judge_edge(memory, a, b, tuning.shortcut_effort, tuning.shortcut_m)[0] == FREE


@compiled
def shorten(memory: Memory, points: Array, iterations: int, found: Array) -> int:
    """Cut the corners of a free way off, as much of each as is free.

    Args:
        memory: Robot and scene.
        points: Weights, then the way, shape (1 + rows, size).
        iterations: Most lines that are tried.
        found: Result: the way, row behind row, never longer than it was.

    Returns:
        Number of its rows; 0 when it does not fit.
    """
    size = points.shape[1]
    weights = points[0]
    most = found.shape[0] // size
    count: int = points.shape[0] - 1
    if count > most:
        return 0
    way = np.empty((most, size))
    # corners that nothing can be cut off while their neighbours stay
    settled = np.zeros(most, np.int64)
    a = np.empty(size)
    b = np.empty(size)
    length = 0.0
    for row in range(count):
        way[row, :] = points[row + 1]
        if row > 0:
            length += distance_of(way[row - 1], way[row], weights)
    least = problem_at(memory).tuning.shortcut_gain * length
    left = iterations
    for _ in range(_ROUNDS):
        changed = False
        row = 1
        while row < count - 1:
            if settled[row] == 1 or left == 0 or count == most:
                row += 1
                continue
            settled[row] = 1
            before = distance_of(way[row - 1], way[row], weights)
            after = distance_of(way[row], way[row + 1], weights)
            saved = before + after - distance_of(way[row - 1], way[row + 1], weights)
            for part in _CUTS:
                if part * saved < least or left == 0:
                    break
                left -= 1
                for k in range(size):
                    a[k] = way[row, k] + (way[row - 1, k] - way[row, k]) * part
                    b[k] = way[row, k] + (way[row + 1, k] - way[row, k]) * part
                if blocked(memory, a, b) or not shortcut_is_proven(memory, a, b):
                    continue
                changed = True
                settled[row - 1] = 0
                settled[row + 1] = 0
                if part == 1.0:
                    _remove(way, settled, count, row)
                    count -= 1
                    row -= 1
                else:
                    _insert(way, settled, count, row)
                    way[row, :] = a
                    way[row + 1, :] = b
                    settled[row] = 0
                    settled[row + 1] = 0
                    count += 1
                    row += 1
                break
            row += 1
        if not changed:
            break
    for row in range(count):
        found[row * size : (row + 1) * size] = way[row]
    return count


@inlined
def _remove(way: Array, settled: Indices, count: int, row: int) -> None:
    for at in range(row, count - 1):
        way[at, :] = way[at + 1]
        settled[at] = settled[at + 1]


@inlined
def _insert(way: Array, settled: Indices, count: int, row: int) -> None:
    """Make room behind a row."""
    for at in range(count, row + 1, -1):
        way[at, :] = way[at - 1]
        settled[at] = settled[at - 1]
