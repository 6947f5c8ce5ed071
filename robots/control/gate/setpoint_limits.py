"""Compiled judgements of the control loop: arrays of thirty are too small for array calls."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array
from kinematics.compiled.compiler import compiled

Indices = NDArray[np.intp]


@compiled
def within_limits(
    q: Array,
    v: Array,
    tau: Array,
    last_q: Array,
    last_v: Array,
    dt_s: float,
    least: Array,
    most: Array,
    judged: Array,
) -> bool:
    """Whether a setpoint keeps all its limits; a value that is not a number keeps none.

    Args:
        q, v, tau: The setpoint, shape (n,) each.
        last_q, last_v: The one before, shape (n,) each.
        dt_s: Time between the two.
        least, most: Bounds of position, velocity, effort, acceleration and jump, shape (5, n).
        judged: Result: the values that were judged, shape (5, n). The jump is how far the position is
            from where the last one and the mean of both velocities lead.
    """
    inside = True
    for j in range(q.shape[0]):
        judged[0, j] = q[j]
        judged[1, j] = v[j]
        judged[2, j] = tau[j]
        judged[3, j] = (v[j] - last_v[j]) / dt_s
        judged[4, j] = (q[j] - last_q[j]) - 0.5 * dt_s * (v[j] + last_v[j])
        for k in range(5):
            # Written so that a value that is not a number counts as outside.
            inside &= judged[k, j] <= most[k, j] and judged[k, j] >= least[k, j]
    return inside


@compiled
def moves_any(q: Array, v: Array, last_q: Array, joints: NDArray[np.bool_]) -> bool:
    """Whether a setpoint moves one of the marked joints, shape (n,)."""
    moved = False
    for j in range(q.shape[0]):
        moved |= joints[j] and (q[j] != last_q[j] or v[j] != 0.0)
    return moved


@compiled
def largest_excess(effort: Array, expected: Array, joints: Indices, bound: Array, outside: Array) -> float:
    """How far efforts from outside go beyond their bounds, Nm; negative while they do not.

    Args:
        effort, expected: Measured, and what the motion needs, shape (n,), Nm.
        joints: Which of them are watched, shape (k,).
        bound: For the watched ones, shape (k,), Nm.
        outside: Result: size of the difference for the watched ones, shape (k,), Nm.
    """
    most = -math.inf
    for k in range(joints.shape[0]):
        outside[k] = abs(effort[joints[k]] - expected[joints[k]])
        most = max(most, outside[k] - bound[k])
    return most
