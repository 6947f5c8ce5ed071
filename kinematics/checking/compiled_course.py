"""Compiled: a motion between its samples, and how long the paths of its parts are."""

from __future__ import annotations

import math
from typing import NamedTuple

from kinematics.arrays import Array
from kinematics.compiled.compiler import compiled, inlined
from kinematics.compiled.loose_arrays import loose1, loose2

# Sums of path lengths are differences of running sums: their rounding, in m and rad.
ROUNDING = 1e-12


class Course(NamedTuple):
    """A trajectory as arrays; see ``Timeline``.

    Attributes:
        t_s: Sample times, shape (n,).
        values, rates: Base position and joints, and their rates, shape (n, 3 + k).
        quaternions: Of the base, shape (n, 4).
        so_far: Path lengths (base, turn, joints) from the start to each sample, shape (n, 2 + k).
    """

    t_s: Array
    values: Array
    rates: Array
    quaternions: Array
    so_far: Array


@inlined
def loose_course(course: Course) -> Course:
    """Every array of a course, see ``check_loose_arrays``."""
    return Course(
        loose1(course.t_s),
        loose2(course.values),
        loose2(course.rates),
        loose2(course.quaternions),
        loose2(course.so_far),
    )


@inlined
def segment_of(t_s: Array, time: float) -> int:
    """The segment between two samples that holds a time."""
    low = 0
    high = t_s.shape[0] - 1
    while high - low > 1:
        middle = (low + high) // 2
        if t_s[middle] <= time:
            low = middle
        else:
            high = middle
    return low


@compiled
def state_at(course: Course, i: int, time: float, value: Array, rate: Array, quaternion: Array) -> None:
    """Values, rates and base orientation at a time in segment ``i``."""
    h = course.t_s[i + 1] - course.t_s[i]
    u = (time - course.t_s[i]) / h
    for r in range(value.shape[0]):
        change = course.values[i + 1, r] - course.values[i, r]
        bow = course.rates[i, r] * h - change
        lean = change - course.rates[i + 1, r] * h
        value[r] = course.values[i, r] + u * change + u * (1.0 - u) * ((1.0 - u) * bow + u * lean)
        rate[r] = (change + (1.0 - u) * (1.0 - 3.0 * u) * bow + u * (2.0 - 3.0 * u) * lean) / h
    square = 0.0
    for r in range(4):
        c = (1.0 - u) * course.quaternions[i, r] + u * course.quaternions[i + 1, r]
        quaternion[r] = c
        square += c * c
    length = math.sqrt(square)
    for r in range(4):
        quaternion[r] /= length


@inlined
def _add_piece(
    value_a: Array,
    rate_a: Array,
    quaternion_a: Array,
    value_b: Array,
    rate_b: Array,
    quaternion_b: Array,
    duration: float,
    out: Array,
) -> None:
    """Add the lengths of the control polygons of one cubic piece: no path is longer."""
    third = duration / 3.0
    first = 0.0
    middle = 0.0
    last = 0.0
    for r in range(3):
        a = rate_a[r] * third
        c = rate_b[r] * third
        b = value_b[r] - value_a[r] - a - c
        first += a * a
        middle += b * b
        last += c * c
    out[0] += math.sqrt(first) + math.sqrt(middle) + math.sqrt(last)
    chord = 0.0
    for r in range(4):
        d = quaternion_b[r] - quaternion_a[r]
        chord += d * d
    out[1] += 4.0 * math.asin(min(0.5 * math.sqrt(chord), 1.0))
    for r in range(3, value_a.shape[0]):
        a = rate_a[r] * third
        c = rate_b[r] * third
        out[r - 1] += abs(a) + abs(value_b[r] - value_a[r] - a - c) + abs(c)


@compiled
def running_lengths(t_s: Array, values: Array, rates: Array, quaternions: Array, so_far: Array) -> None:
    """Lengths of all paths from the start to each sample; arguments as of ``Course``."""
    so_far[0] = 0.0
    for i in range(t_s.shape[0] - 1):
        for r in range(so_far.shape[1]):
            so_far[i + 1, r] = so_far[i, r]
        _add_piece(
            values[i], rates[i], quaternions[i], values[i + 1], rates[i + 1], quaternions[i + 1],
            t_s[i + 1] - t_s[i], so_far[i + 1],
        )  # fmt: skip


@compiled
def add_path(
    course: Course,
    begin: float,
    i: int,
    value_a: Array,
    rate_a: Array,
    quaternion_a: Array,
    end: float,
    j: int,
    value_b: Array,
    rate_b: Array,
    quaternion_b: Array,
    out: Array,
) -> None:
    """Lengths of all paths between two instants, in the segments ``i`` and ``j``."""
    out[:] = ROUNDING
    t_s, values, rates, quaternions = course.t_s, course.values, course.rates, course.quaternions
    if i == j:
        _add_piece(value_a, rate_a, quaternion_a, value_b, rate_b, quaternion_b, end - begin, out)
        return
    n = i + 1
    _add_piece(value_a, rate_a, quaternion_a, values[n], rates[n], quaternions[n], t_s[n] - begin, out)
    for r in range(out.shape[0]):
        out[r] += course.so_far[j, r] - course.so_far[n, r]
    _add_piece(values[j], rates[j], quaternions[j], value_b, rate_b, quaternion_b, end - t_s[j], out)
