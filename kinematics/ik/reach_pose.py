"""Compiled: where a tool is, how far from its goal, and what moves it."""

from __future__ import annotations

import math

from kinematics.arrays import Array
from kinematics.compiled.compiler import inlined
from kinematics.ik.reach_problem import ReachGoal, ReachSpace, Scratch
from kinematics.model.tree import WORLD, Tree
from kinematics.standing.flat_coordinates import Coordinates

_FARTHEST_M, _FARTHEST_RAD = 0.2, 0.8
"""Errors beyond these are approached in steps: linearised farther they mislead."""


@inlined
def place_tool(goal: ReachGoal, memory: Scratch) -> None:
    """Pose of the tool, whose body is in place."""
    R, p = memory.R[goal.body], memory.p[goal.body]
    for r in range(3):
        memory.tool_p[r] = p[r]
        for k in range(3):
            memory.tool_p[r] += R[r, k] * goal.offset_p[k]
            t = 0.0
            for s in range(3):
                t += R[r, s] * goal.offset_R[s, k]
            memory.tool_R[r, k] = t


@inlined
def tool_errors(goal: ReachGoal, memory: Scratch) -> tuple[float, float]:
    """Distance and angle to the target; the step wanted in position and rotation is noted."""
    e = memory.wanted
    T, G = memory.tool_R, goal.target_R
    squared = 0.0
    for r in range(3):
        e[r] = goal.target_p[r] - memory.tool_p[r]
        squared += e[r] * e[r]
    far = math.sqrt(squared)
    # the rotation from the tool to the target, in the world's axes: M = G T^T
    trace = 0.0
    for r in range(3):
        for k in range(3):
            trace += G[r, k] * T[r, k]
    for r in range(3):
        i, j = (r + 1) % 3, (r + 2) % 3
        t = 0.0
        for k in range(3):
            t += G[j, k] * T[i, k] - G[i, k] * T[j, k]
        e[3 + r] = 0.5 * t
    sine = math.sqrt(e[3] * e[3] + e[4] * e[4] + e[5] * e[5])
    turned = math.atan2(sine, 0.5 * (trace - 1.0))
    if sine < 1e-9 and turned > 1.0:
        e[3] = 1.0  # half a turn: any axis leads away from it
        sine = 1.0
    scale = min(turned, _FARTHEST_RAD) / sine if sine > 1e-12 else 1.0
    for r in range(3, 6):
        e[r] *= scale
    if far > _FARTHEST_M:
        for r in range(3):
            e[r] *= _FARTHEST_M / far
    return far, turned


@inlined
def pose_rows(
    tree: Tree, space: Coordinates, goal: ReachGoal, where: ReachSpace, x: Array, memory: Scratch
) -> None:
    """Jacobian of the tool's pose, rows 0 to 5: position, rotation; world axes."""
    J, tip = memory.rows, memory.tool_p
    for r in range(6):
        for k in range(x.shape[0]):
            J[r, k] = 0.0
    body = goal.body
    while body != WORLD:
        k = where.column[body]
        if k >= 0:
            R, axis = memory.R[body], tree.axis[body]
            a0 = R[0, 0] * axis[0] + R[0, 1] * axis[1] + R[0, 2] * axis[2]
            a1 = R[1, 0] * axis[0] + R[1, 1] * axis[1] + R[1, 2] * axis[2]
            a2 = R[2, 0] * axis[0] + R[2, 1] * axis[1] + R[2, 2] * axis[2]
            _turn_column(J, k, a0, a1, a2, memory.p[body], tip)
        body = tree.parent[body]
    if space.floating == 1:
        for r in range(3):
            J[r, r] = 1.0
            a0, a1, a2 = turning_axis(x, r)
            _turn_column(J, 3 + r, a0, a1, a2, memory.q, tip)


@inlined
def _turn_column(J: Array, k: int, a0: float, a1: float, a2: float, origin: Array, tip: Array) -> None:
    d0, d1, d2 = tip[0] - origin[0], tip[1] - origin[1], tip[2] - origin[2]
    J[0, k] = a1 * d2 - a2 * d1
    J[1, k] = a2 * d0 - a0 * d2
    J[2, k] = a0 * d1 - a1 * d0
    J[3, k], J[4, k], J[5, k] = a0, a1, a2


@inlined
def turning_axis(x: Array, k: int) -> tuple[float, float, float]:
    """Angular velocity in the world for a unit rate of one entry of the base's rotation vector."""
    r0, r1, r2 = x[3], x[4], x[5]
    squared = r0 * r0 + r1 * r1 + r2 * r2
    angle = math.sqrt(squared)
    if angle < 1e-4:
        b, c = 0.5, 1.0 / 6.0
    else:
        b = (1.0 - math.cos(angle)) / squared
        c = (angle - math.sin(angle)) / (squared * angle)
    u0, u1, u2 = 0.0, 0.0, 0.0
    if k == 0:
        u0 = 1.0
    elif k == 1:
        u1 = 1.0
    else:
        u2 = 1.0
    v0, v1, v2 = r1 * u2 - r2 * u1, r2 * u0 - r0 * u2, r0 * u1 - r1 * u0
    w0, w1, w2 = r1 * v2 - r2 * v1, r2 * v0 - r0 * v2, r0 * v1 - r1 * v0
    return u0 + b * v0 + c * w0, u1 + b * v1 + c * w1, u2 + b * v2 + c * w2
