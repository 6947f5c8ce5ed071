"""Compiled: both legs by Newton's method, over feet that move, where they have no closed form.

The search begins at the joints of the period before, which are a few milliradians away: two or three
iterations. ``kinematics.standing.numeric_leg`` solves the same over feet that stand, from the home posture.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array
from kinematics.compiled.compiler import compiled

SOLVED = 1e-11
"""Of position (m) and turn (rad): what is left of it is no motion that a setpoint shows."""
ITERATIONS = 12
LONGEST_STEP = 0.2
"""No joint turns farther in one iteration, rad: a longer step may come down behind a stretched knee."""
_SMALLEST_PIVOT = 1e-9


@compiled
def _turned(axis: Array, angle: float, R: Array) -> None:
    """Turn a rotation, shape (3, 3), about an axis of its own, by Rodrigues' formula."""
    c, s = math.cos(angle), math.sin(angle)
    v = 1.0 - c
    x, y, z = axis[0], axis[1], axis[2]
    for r in range(3):
        a, b, d = R[r, 0], R[r, 1], R[r, 2]
        R[r, 0] = a * (c + x * x * v) + b * (z * s + y * x * v) + d * (z * x * v - y * s)
        R[r, 1] = a * (x * y * v - z * s) + b * (c + y * y * v) + d * (z * y * v + x * s)
        R[r, 2] = a * (x * z * v + y * s) + b * (y * z * v - x * s) + d * (c + z * z * v)


@compiled
def _solve(A: Array, b: Array) -> bool:
    """Solve six linear equations in place, by elimination with pivots; false where they depend."""
    n = b.shape[0]
    for k in range(n):
        best = k
        for r in range(k + 1, n):
            if abs(A[r, k]) > abs(A[best, k]):
                best = r
        if abs(A[best, k]) < _SMALLEST_PIVOT:
            return False
        if best != k:
            for c in range(k, n):
                A[k, c], A[best, c] = A[best, c], A[k, c]
            b[k], b[best] = b[best], b[k]
        for r in range(k + 1, n):
            f = A[r, k] / A[k, k]
            if f != 0.0:
                for c in range(k, n):
                    A[r, c] -= f * A[k, c]
                b[r] -= f * b[k]
    for k in range(n - 1, -1, -1):
        for c in range(k + 1, n):
            b[k] -= A[k, c] * b[c]
        b[k] /= A[k, k]
    return True


@compiled
def fill_hinged_legs(
    q: Array,
    base_R: Array,
    feet: Array,
    turns: Array,
    offsets: Array,
    axes: Array,
    foot_R_sole: Array,
    foot_p_sole: Array,
    columns: NDArray[np.intp],
) -> bool:
    """Write the leg joints of one configuration; tell whether every foot is reached.

    Args:
        q: Configuration, shape (nq,): its base position is read, ``columns`` are read as a start and written.
        base_R: Orientation of the base, shape (3, 3).
        feet: x, y, height and heading of each sole, shape (legs, 4).
        turns, offsets, axes: Of each joint against the one before, shapes (legs, 6, 3, 3), (legs, 6, 3) and
            (legs, 6, 3).
        foot_R_sole, foot_p_sole: The sole on the last link, shapes (legs, 3, 3) and (legs, 3).
        columns: Where each leg's joints are in ``q``, hip to ankle, shape (legs, 6).
    """
    R, p, T = np.empty((3, 3)), np.empty(3), np.empty((3, 3))
    origins, around = np.empty((6, 3)), np.empty((6, 3))
    A, step = np.empty((6, 6)), np.empty(6)
    for leg in range(feet.shape[0]):
        c, s = math.cos(feet[leg, 3]), math.sin(feet[leg, 3])
        reached = False
        for _ in range(ITERATIONS):
            for r in range(3):
                p[r] = q[r]
                for k in range(3):
                    R[r, k] = base_R[r, k]
            for joint in range(6):
                for r in range(3):
                    for k in range(3):
                        p[r] += R[r, k] * offsets[leg, joint, k]
                for r in range(3):
                    for k in range(3):
                        T[r, k] = 0.0
                        for i in range(3):
                            T[r, k] += R[r, i] * turns[leg, joint, i, k]
                for r in range(3):
                    origins[joint, r] = p[r]
                    around[joint, r] = 0.0
                    for k in range(3):
                        R[r, k] = T[r, k]
                        around[joint, r] += T[r, k] * axes[leg, joint, k]
                _turned(axes[leg, joint], q[columns[leg, joint]], R)
            for r in range(3):
                for k in range(3):
                    p[r] += R[r, k] * foot_p_sole[leg, k]
                    T[r, k] = 0.0
                    for i in range(3):
                        T[r, k] += R[r, i] * foot_R_sole[leg, i, k]
            # the turn from where the sole is to where it shall be, Z T^T with Z about the vertical
            e00 = c * T[0, 0] - s * T[0, 1]
            e10 = s * T[0, 0] + c * T[0, 1]
            e20 = T[0, 2]
            e01 = c * T[1, 0] - s * T[1, 1]
            e11 = s * T[1, 0] + c * T[1, 1]
            e21 = T[1, 2]
            e02 = c * T[2, 0] - s * T[2, 1]
            e12 = s * T[2, 0] + c * T[2, 1]
            e22 = T[2, 2]
            x, y, z = 0.5 * (e21 - e12), 0.5 * (e02 - e20), 0.5 * (e10 - e01)
            sine = math.sqrt(x * x + y * y + z * z)
            angle = math.atan2(sine, 0.5 * (e00 + e11 + e22 - 1.0))
            scale = 1.0 if sine < 1e-9 else angle / sine
            step[0], step[1], step[2] = feet[leg, 0] - p[0], feet[leg, 1] - p[1], feet[leg, 2] - p[2]
            step[3], step[4], step[5] = x * scale, y * scale, z * scale
            largest = 0.0
            for r in range(6):
                largest = max(largest, abs(step[r]))
            if largest <= SOLVED:
                reached = True
                break
            for joint in range(6):
                dx, dy, dz = p[0] - origins[joint, 0], p[1] - origins[joint, 1], p[2] - origins[joint, 2]
                ax, ay, az = around[joint, 0], around[joint, 1], around[joint, 2]
                A[0, joint] = ay * dz - az * dy
                A[1, joint] = az * dx - ax * dz
                A[2, joint] = ax * dy - ay * dx
                A[3, joint], A[4, joint], A[5, joint] = ax, ay, az
            if not _solve(A, step):
                return False
            longest = 0.0
            for joint in range(6):
                longest = max(longest, abs(step[joint]))
            share = min(1.0, LONGEST_STEP / longest) if longest > 0.0 else 1.0
            for joint in range(6):
                q[columns[leg, joint]] += share * step[joint]
        if not reached:
            return False
    return True
