"""Compiled loops of path timing: the fastest rates along a curve, their running mean, the judgement.

A curve comes as intervals on each of which every coordinate is a quadratic of the parameter, and the
parameter's acceleration is constant there: then joint accelerations are linear inside an interval,
so limits that hold at both of its ends hold in between, and all integrals are closed forms.

Method of ``fastest_rates``: Pham and Pham, "A new approach to time-optimal path parameterization based
on reachability analysis", IEEE Transactions on Robotics 34(3), 2018; its small linear programs are
solved by Newton's method, which on a concave function with corners ends after a few exact steps.
Compiled without fast-math, so that the same input gives the same bits.
"""

from __future__ import annotations

import numpy as np

from kinematics.arrays import Array
from kinematics.compiled.compiler import compiled

# A slope below this, with limits scaled to 1, does not tell how the parameter may accelerate.
FLAT = 1e-9
# The squared rate is at least this share of what it may be at the next grid point, and of what it was at the
# last one. Where limits leave the parameter hardly any acceleration, the greatest rate may be one from which
# it can only fall to 0: a motion that takes it stops there.
LEAST_KEPT = 0.25
# Newton steps; each leaves a corner of the concave function behind, three are usual.
STEPS = 100


@compiled
def fastest_rates(first: Array, last: Array, bend: Array, share: Array, top: Array, step: Array) -> Array:
    """Squared rates of the parameter that run a curve in the least time, from rest to rest.

    Args:
        first, last: Slope of each joint at the start and at the end of each interval, over its
            acceleration limit, shape (n, k).
        bend: Second derivative there, over the same, shape (n, k).
        share: Share of the acceleration limits that may be used in each interval, shape (n,).
        top: Largest squared rate at each grid point, shape (n + 1,).
        step: Length of each interval, shape (n,).

    Returns:
        Squared rates at the grid points, shape (n + 1,).
    """
    n, k = bend.shape
    most = np.empty(n + 1)
    most[n] = 0.0
    for i in range(n - 1, -1, -1):
        twice, c = 2.0 * step[i], share[i]
        b = top[i]
        for j in range(k):
            r = abs(bend[i, j])
            flat = abs(first[i, j]) < FLAT or abs(last[i, j] + twice * bend[i, j]) < FLAT
            if flat and r * b > c:
                b = c / r
        for _ in range(STEPS):
            # accelerations that keep the limits: from low to high, both linear in b around here
            low, low_slope = (LEAST_KEPT * most[i + 1] - b) / twice, -1.0 / twice
            if b < most[i + 1]:
                low, low_slope = (LEAST_KEPT - 1.0) * b / twice, (LEAST_KEPT - 1.0) / twice
            high, high_slope = (most[i + 1] - b) / twice, -1.0 / twice
            for j in range(k):
                r = bend[i, j]
                for end in range(2):
                    p = first[i, j] if end == 0 else last[i, j] + twice * r
                    if abs(p) < FLAT:
                        continue
                    slope = -r / p
                    middle, reach = slope * b, c / abs(p)
                    if middle + reach < high:
                        high, high_slope = middle + reach, slope
                    if middle - reach > low:
                        low, low_slope = middle - reach, slope
            if high >= low or high_slope >= low_slope:
                break
            b = max(0.0, b - (high - low) / (high_slope - low_slope))
        most[i] = b
    rates = np.empty(n + 1)
    rates[0] = 0.0
    for i in range(n):
        twice, c, b = 2.0 * step[i], share[i], rates[i]
        high = (most[i + 1] - b) / twice
        for j in range(k):
            r = bend[i, j]
            for end in range(2):
                p = first[i, j] if end == 0 else last[i, j] + twice * r
                if abs(p) >= FLAT:
                    high = min(high, c / abs(p) - r / p * b)
        rates[i + 1] = min(max(b + twice * high, 0.0), most[i + 1])
    return rates


@compiled
def grid_times(rates: Array, step: Array) -> Array:
    """When each grid point is passed, from 0, shape (n + 1,)."""
    times = np.zeros(len(rates))
    for i in range(len(step)):
        times[i + 1] = times[i] + 2.0 * step[i] / (np.sqrt(rates[i]) + np.sqrt(rates[i + 1]))
    return times


@compiled
def _locate(times: Array, i: int, t: float) -> int:
    """Interval of a time that is not before interval ``i``."""
    while i < len(times) - 2 and times[i + 1] <= t:
        i += 1
    return i


@compiled
def running_mean(
    points: Array,
    step: Array,
    rates: Array,
    times: Array,
    window_s: float,
    count: int,
    weights: Array,
    near: float,
) -> tuple[Array, Array, Array]:
    """The motion along a curve, averaged over a window of time around each instant.

    Args:
        points: Coordinates at the grid points and in the middles between them, shape (2 n + 1, size).
        step, rates, times: Of the intervals and the grid points.
        window_s: Length of the window. Before its start and after its end the motion rests.
        count: Instants, evenly spaced from half a window before the start to half a window after the end.
        weights: Of the coordinates in distances, shape (size,).
        near: Distances below this need not be measured well.

    Returns:
        Averaged coordinates and their velocities, shape (count, size) each, and a bound of how far any
        coordinate is from the curve, shape (count,): by the distance to the tangent at the same instant,
        or where that is not near, to the part of the curve that was averaged.
    """
    n, size = len(step), points.shape[1]
    # what the coordinates sum up to over the time, at the grid points
    sums = np.zeros((n + 1, size))
    powers = np.empty(3)
    for i in range(n):
        _powers(step[i], rates[i], rates[i + 1], times[i + 1] - times[i], powers)
        for c in range(size):
            x0, middle, x1 = points[2 * i, c], points[2 * i + 1, c], points[2 * i + 2, c]
            linear, square = 4.0 * middle - 3.0 * x0 - x1, 2.0 * (x0 - 2.0 * middle + x1)
            sums[i + 1, c] = (
                sums[i, c] + x0 * (times[i + 1] - times[i]) + linear * powers[1] + square * powers[2]
            )
    x, v, stray = np.empty((count, size)), np.empty((count, size)), np.empty(count)
    end_s = times[n]
    early, centre, late = 0, 0, 0
    for sample in range(count):
        t = (end_s + window_s) * sample / (count - 1) - 0.5 * window_s
        for side in range(2):
            at = t - 0.5 * window_s if side == 0 else t + 0.5 * window_s
            inside = min(max(at, 0.0), end_s)
            if side == 0:
                early = _locate(times, early, inside)
            else:
                late = _locate(times, late, inside)
            i = early if side == 0 else late
            z = _powers(step[i], rates[i], rates[i + 1], inside - times[i], powers)
            for c in range(size):
                x0, middle, x1 = points[2 * i, c], points[2 * i + 1, c], points[2 * i + 2, c]
                linear, square = 4.0 * middle - 3.0 * x0 - x1, 2.0 * (x0 - 2.0 * middle + x1)
                here = x0 + z * (linear + z * square)
                total = sums[i, c] + x0 * (inside - times[i]) + linear * powers[1] + square * powers[2]
                total += here * (at - inside)
                if side == 0:
                    x[sample, c], v[sample, c] = -total / window_s, -here / window_s
                else:
                    x[sample, c] += total / window_s
                    v[sample, c] += here / window_s
        inside = min(max(t, 0.0), end_s)
        centre = _locate(times, centre, inside)
        i = centre
        z = _powers(step[i], rates[i], rates[i + 1], inside - times[i], powers)
        off, along, length = 0.0, 0.0, 1e-30
        for c in range(size):
            x0, middle, x1 = points[2 * i, c], points[2 * i + 1, c], points[2 * i + 2, c]
            linear, square = 4.0 * middle - 3.0 * x0 - x1, 2.0 * (x0 - 2.0 * middle + x1)
            gap = weights[c] * (x[sample, c] - x0 - z * (linear + z * square))
            direction = weights[c] * (linear + 2.0 * z * square)
            off += gap * gap
            along += gap * direction
            length += direction * direction
        stray[sample] = np.sqrt(max(0.0, off - along * along / length))
        if stray[sample] > near:
            for i in range(early, late + 1):
                stray[sample] = min(stray[sample], _distance(x[sample], points, i, weights))
    return x, v, stray


@compiled
def _distance(place: Array, points: Array, i: int, weights: Array) -> float:
    """Largest weighted distance in one coordinate to the nearest point of an interval's two chords."""
    least = np.inf
    for k in range(2 * i, 2 * i + 2):
        along, length = 0.0, 1e-30
        for c in range(len(place)):
            chord = weights[c] * (points[k + 1, c] - points[k, c])
            along += weights[c] * (place[c] - points[k, c]) * chord
            length += chord * chord
        share = min(1.0, max(0.0, along / length))
        largest = 0.0
        for c in range(len(place)):
            nearest = points[k, c] + share * (points[k + 1, c] - points[k, c])
            largest = max(largest, weights[c] * abs(place[c] - nearest))
        least = min(least, largest)
    return least


@compiled
def _powers(step: float, start: float, end: float, t: float, powers: Array) -> float:
    """Share of an interval passed after a time in it; integrals of its powers 1 and 2 over that time."""
    rate = np.sqrt(start) / step
    half = 0.25 * (end - start) / (step * step)
    powers[1] = t * t * (0.5 * rate + half * t / 3.0)
    powers[2] = t * t * t * (rate * rate / 3.0 + t * (0.5 * rate * half + 0.2 * half * half * t))
    share: float = t * (rate + half * t)
    return min(1.0, share)


@compiled
def excess(q: Array, v: Array, spacing_s: float, velocity: Array, acceleration: Array, jerk: Array) -> Array:
    """By which factor the time of each segment is too short for the limits: 1 or less is within.

    Judged on the cubics between evenly spaced samples: speed and acceleration at their extremes, jerk
    inside the segments, and the step of the acceleration from one to the next over their spacing.

    Args:
        q, v: Positions and velocities of the joints at the samples, shape (n, k).
        spacing_s: Between the samples.
        velocity, acceleration, jerk: Limits, shape (k,).

    Returns:
        Shape (n - 1,).
    """
    n, k = q.shape
    h = spacing_s
    worst = np.zeros((n - 1, 3))
    for j in range(k):
        before, middle_before = 0.0, 0.0
        for i in range(n - 1):
            v0, v1 = v[i, j], v[i + 1, j]
            slope = (q[i + 1, j] - q[i, j]) / h
            early = (6.0 * slope - 4.0 * v0 - 2.0 * v1) / h
            late = (4.0 * v1 + 2.0 * v0 - 6.0 * slope) / h
            speed = max(abs(v0), abs(v1))
            if early * late < 0.0:
                u = early / (early - late)
                speed = max(speed, abs(v0 + 0.5 * h * u * early))
            change = abs(late - early)
            middle = 0.5 * (early + late)
            if i > 0:
                change = max(change, abs(early - before), abs(middle - middle_before))
            before, middle_before = late, middle
            worst[i, 0] = max(worst[i, 0], speed / velocity[j])
            worst[i, 1] = max(worst[i, 1], max(abs(early), abs(late)) / acceleration[j])
            worst[i, 2] = max(worst[i, 2], change / (h * jerk[j]))
    factor = np.empty(n - 1)
    for i in range(n - 1):
        factor[i] = max(worst[i, 0], np.sqrt(worst[i, 1]), worst[i, 2] ** (1.0 / 3.0))
    return factor
