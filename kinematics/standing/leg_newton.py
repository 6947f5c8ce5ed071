"""Compiled: the joints of a leg for many poses of its sole, by Newton's method from its home posture."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array
from kinematics.compiled.compiler import compiled

# Solved to this distance (m) and angle (rad); a double leaves some 1e-16.
SOLVED = 1e-12
# Of 2,000 poses about a standing one, all that are reached at all were within 10.
ITERATIONS = 16
# No joint turns farther in one iteration: a longer step may come down behind a singularity.
LONGEST_STEP = 0.4
# Damping, of the squared error: none is left where Newton's method converges.
DAMPING, LEAST_DAMPING = 1e-2, 1e-15
_JOINTS = 6
_SMALL = 1e-8


@compiled
def solve_poses(
    home: Array,
    hinges: Array,
    axes: Array,
    foot_T_sole: Array,
    position: Array,
    rotation: Array,
    joints: Array,
    reached: NDArray[np.bool_],
) -> None:
    """Solve one pose after the other; all arrays are contiguous.

    Args:
        home: Where each search begins, shape (6,).
        hinges: What each hinge's pose is made of, shape (3, 6, 4, 4): still, by its sine, by its versine.
        axes: Of the hinges, each in its own frame, shape (6, 3).
        foot_T_sole: The sole on the last link, shape (4, 4).
        position, rotation: Of the soles, in the base's frame, shape (n, 3) and (n, 3, 3).
        joints: Result, shape (n, 6).
        reached: Result: whether the foot is there, shape (n,).
    """
    origins, turned = np.empty((_JOINTS, 3)), np.empty((_JOINTS, 3))
    R, at = np.empty((3, 3)), np.empty(3)
    error, jacobian = np.empty(6), np.empty((6, _JOINTS))
    square, step = np.empty((6, 6)), np.empty(_JOINTS)
    for n in range(position.shape[0]):
        for k in range(_JOINTS):
            joints[n, k] = home[k]
        reached[n] = False
        for iteration in range(ITERATIONS + 1):
            _forward(hinges, axes, foot_T_sole, joints[n], origins, turned, R, at)
            size = _errors(position[n], rotation[n], origins, turned, R, at, error, jacobian)
            if size <= SOLVED:
                reached[n] = True
                break
            if iteration == ITERATIONS:
                break
            _step(jacobian, error, DAMPING * size * size + LEAST_DAMPING, square, step)
            longest = 1e-12
            for k in range(_JOINTS):
                longest = max(longest, abs(step[k]))
            share = min(1.0, LONGEST_STEP / longest)
            for k in range(_JOINTS):
                joints[n, k] += share * step[k]


@compiled
def _forward(
    hinges: Array,
    axes: Array,
    foot_T_sole: Array,
    joints: Array,
    origins: Array,
    turned: Array,
    R: Array,
    at: Array,
) -> None:
    """Origins and axes of the hinges, and pose of the sole, all in the base's frame."""
    for r in range(3):
        at[r] = 0.0
        for c in range(3):
            R[r, c] = 1.0 if r == c else 0.0
    for k in range(_JOINTS + 1):
        sine, versine = 0.0, 0.0
        if k < _JOINTS:
            sine, versine = math.sin(joints[k]), 1.0 - math.cos(joints[k])
        for r in range(3):
            a, b, c = R[r, 0], R[r, 1], R[r, 2]
            if k == _JOINTS:
                M = foot_T_sole
                at[r] += a * M[0, 3] + b * M[1, 3] + c * M[2, 3]
                for s in range(3):
                    R[r, s] = a * M[0, s] + b * M[1, s] + c * M[2, s]
                continue
            still, by_sine, by_versine = hinges[0, k], hinges[1, k], hinges[2, k]
            at[r] += a * still[0, 3] + b * still[1, 3] + c * still[2, 3]
            for s in range(3):
                R[r, s] = (
                    a * (still[0, s] + sine * by_sine[0, s] + versine * by_versine[0, s])
                    + b * (still[1, s] + sine * by_sine[1, s] + versine * by_versine[1, s])
                    + c * (still[2, s] + sine * by_sine[2, s] + versine * by_versine[2, s])
                )
        if k < _JOINTS:
            for r in range(3):
                origins[k, r] = at[r]
                turned[k, r] = R[r, 0] * axes[k, 0] + R[r, 1] * axes[k, 1] + R[r, 2] * axes[k, 2]


@compiled
def _errors(
    position: Array,
    rotation: Array,
    origins: Array,
    turned: Array,
    R: Array,
    at: Array,
    error: Array,
    jacobian: Array,
) -> float:
    """Distance and turn to the wanted pose, shape (6,), and the Jacobian, shape (6, 6); the largest error."""
    x = y = z = trace = 0.0
    for k in range(3):
        x += rotation[2, k] * R[1, k] - rotation[1, k] * R[2, k]
        y += rotation[0, k] * R[2, k] - rotation[2, k] * R[0, k]
        z += rotation[1, k] * R[0, k] - rotation[0, k] * R[1, k]
        for r in range(3):
            trace += rotation[r, k] * R[r, k]
    sine, cosine = 0.5 * math.sqrt(x * x + y * y + z * z), 0.5 * (trace - 1.0)
    share = 0.5 if sine < _SMALL else 0.5 * math.atan2(sine, cosine) / sine
    for r in range(3):
        error[r] = position[r] - at[r]
    error[3], error[4], error[5] = share * x, share * y, share * z
    if sine < _SMALL and cosine < 0.0:  # half a turn, whose axis is lost
        error[3], error[4], error[5] = math.pi, 0.0, 0.0
    for k in range(_JOINTS):
        a0, a1, a2 = turned[k, 0], turned[k, 1], turned[k, 2]
        d0, d1, d2 = at[0] - origins[k, 0], at[1] - origins[k, 1], at[2] - origins[k, 2]
        jacobian[0, k] = a1 * d2 - a2 * d1
        jacobian[1, k] = a2 * d0 - a0 * d2
        jacobian[2, k] = a0 * d1 - a1 * d0
        jacobian[3, k], jacobian[4, k], jacobian[5, k] = a0, a1, a2
    largest = 0.0
    for r in range(6):
        largest = max(largest, abs(error[r]))
    return largest


@compiled
def _step(jacobian: Array, error: Array, damping: float, square: Array, step: Array) -> None:
    """The damped step, shape (6,): by Cholesky's factors of the Jacobian's square."""
    for r in range(6):
        for c in range(r + 1):
            total = damping if r == c else 0.0
            for k in range(_JOINTS):
                total += jacobian[r, k] * jacobian[c, k]
            for k in range(c):
                total -= square[r, k] * square[c, k]
            square[r, c] = math.sqrt(total) if r == c else total / square[c, c]
    solved = np.empty(6)
    for r in range(6):
        total = error[r]
        for k in range(r):
            total -= square[r, k] * solved[k]
        solved[r] = total / square[r, r]
    for back in range(6):
        r = 5 - back
        total = solved[r]
        for k in range(r + 1, 6):
            total -= square[k, r] * solved[k]
        solved[r] = total / square[r, r]
    for k in range(_JOINTS):
        total = 0.0
        for r in range(6):
            total += jacobian[r, k] * solved[r]
        step[k] = total
