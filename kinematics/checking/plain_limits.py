"""Compiled: whether a motion keeps all joint limits well within what ``check_limits`` asks.

Cubics stay within their control points, so that most motions need no closer look. What is not plainly
within is looked at there.
"""

from __future__ import annotations

from kinematics.arrays import Array
from kinematics.compiled.compiler import compiled


@compiled
def plainly_within(
    t_s: Array,
    q: Array,
    v: Array,
    lower: Array,
    upper: Array,
    velocity: Array,
    acceleration: Array,
    jerk: Array,
    jerk_window_s: float,
) -> bool:
    """Tell whether nothing can be found; a number that is none is not within.

    Args:
        t_s: Sample times, shape (n,).
        q, v: Joints at the samples, shape (n, k).
        lower, upper, velocity, acceleration, jerk: What they may do, tolerances included, shape (k,).
        jerk_window_s: A step of the acceleration is spread over no more than this.
    """
    for j in range(q.shape[1]):
        low, high, fastest, hardest, sharpest = lower[j], upper[j], velocity[j], acceleration[j], jerk[j]
        h_before, late_before, middle_before = 0.0, 0.0, 0.0
        for i in range(q.shape[0] - 1):
            h = t_s[i + 1] - t_s[i]
            q0, q1, v0, v1 = q[i, j], q[i + 1, j], v[i, j], v[i + 1, j]
            after, before = q0 + v0 * h / 3.0, q1 - v1 * h / 3.0
            if not (
                low <= min(min(q0, q1), min(after, before)) and max(max(q0, q1), max(after, before)) <= high
            ):
                return False
            slope = (q1 - q0) / h
            early = (6.0 * slope - 4.0 * v0 - 2.0 * v1) / h
            late = (-6.0 * slope + 2.0 * v0 + 4.0 * v1) / h
            if not max(max(abs(v0), abs(v1)), abs(v0 + 0.5 * h * early)) <= fastest:
                return False
            if not max(abs(early), abs(late)) <= hardest:
                return False
            if not abs(late - early) <= sharpest * h:
                return False
            middle = 0.5 * (early + late)
            if i > 0:
                between = 0.5 * (h_before + h)
                if not abs(early - late_before) <= sharpest * min(between, jerk_window_s):
                    return False
                if not abs(middle - middle_before) <= sharpest * between:
                    return False
            h_before, late_before, middle_before = h, late, middle
    return True
