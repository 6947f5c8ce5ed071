"""Compiled inverse kinematics of one frame in free coordinates: damped, clamped Gauss-Newton.

The feet stay where they are by construction. What is left are the frame's pose (six equations) and
inequalities that get a row each while they are broken: the CoM's margin at every edge of the support
polygon, and the limits of the leg joints, which follow from the base. Coordinates at a bound are
frozen for the step. Method: Wampler, "Manipulator inverse kinematic solutions based on vector
formulations and damped least-squares methods", IEEE Trans. SMC 1986, in its weighted form with the
posture in the null space.
"""

from __future__ import annotations

import math

from kinematics.kernel.compiler import compiled, inlined
from kinematics.kernel.coordinates import Coordinates, Limits
from kinematics.kernel.forward_kinematics import place_bodies
from kinematics.kernel.posture import configuration
from kinematics.kernel.reach_balance import broken_limits, inequality_rows
from kinematics.kernel.reach_pose import place_tool, pose_rows, tool_errors
from kinematics.kernel.reach_problem import Array, ReachGoal, ReachSettings, ReachSpace, Scratch
from kinematics.kernel.tree import Tree

_MOST_STEP = 0.4
"""Of a coordinate in one step, m or rad."""


@compiled
def reach(
    tree: Tree,
    space: Coordinates,
    limits: Limits,
    goal: ReachGoal,
    where: ReachSpace,
    settings: ReachSettings,
    x: Array,
    memory: Scratch,
) -> int:
    """Bring a frame to a pose from one start.

    Args:
        tree, space, limits: The robot and what its posture must keep.
        goal: What is to be reached.
        where: Where it is searched.
        settings: How the search goes.
        x: Start, and the result, shape (n,); inside the bounds.
        memory: Scratch; ``memory.q`` is the configuration of the result.

    Returns:
        Steps taken, or -1 when it was not reached.
    """
    inequalities = limits.offset.shape[0] + 6 * space.leg_bodies.shape[0]
    for k in range(x.shape[0]):
        x[k] = min(max(x[k], where.lower[k]), where.upper[k])
    last = math.inf
    for count in range(settings.most_steps):
        shrunk = 0
        while not configuration(space, tree, x, memory.q, memory.base_R):
            # a foot is out of reach: back towards the posture that stands
            if shrunk == 6:
                return -1
            shrunk += 1
            for k in range(6):
                x[k] = 0.5 * (x[k] + where.reference[k])
        place_bodies(tree, memory.q, memory.needed, memory.R, memory.p)
        place_tool(goal, memory)
        far, turned = tool_errors(goal, memory)
        worst = broken_limits(tree, space, limits, memory.q, memory.R, memory.p, memory.com, memory.broken)
        if far <= settings.position_m and turned <= settings.turn_rad and worst <= 0.0:
            return count
        if count % 10 == 9:
            # neither an unreachable pose nor a dead end gets better by waiting
            now = far + 0.1 * turned + max(worst, 0.0)
            if now > 0.8 * last:
                return -1
            last = now
        m = 6
        for k in range(x.shape[0]):
            memory.freedom[k] = where.freedom[k]
        pose_rows(tree, space, goal, where, x, memory)
        if worst > 0.0:
            m = inequality_rows(tree, space, limits, where, inequalities, x, memory)
        solve_step(where, settings, m, x, memory)
        for k in range(x.shape[0]):
            x[k] = min(max(x[k] + memory.step[k], where.lower[k]), where.upper[k])
    return -1


@inlined
def solve_step(where: ReachSpace, settings: ReachSettings, m: int, x: Array, memory: Scratch) -> None:
    """The step: least weighted change that satisfies the rows, the posture pulled in what is left."""
    n = x.shape[0]
    J, A, free, step = memory.rows, memory.system, memory.freedom, memory.step
    right = memory.right
    for _ in range(4):
        for r in range(m):
            for s in range(r + 1):
                t = settings.damping if r == s else 0.0
                for k in range(n):
                    t += J[r, k] * J[s, k] * free[k]
                A[r, s] = t
        for r in range(m):
            t = memory.wanted[r]
            for k in range(n):
                if free[k] > 0.0:
                    t -= J[r, k] * settings.pull * (where.reference[k] - x[k])
            right[r] = t
        _cholesky_solve(A, right, m)
        again = False
        for k in range(n):
            step[k] = 0.0
            if free[k] == 0.0:
                continue
            t = settings.pull * (where.reference[k] - x[k])
            for r in range(m):
                t += free[k] * J[r, k] * right[r]
            t = min(max(t, -_MOST_STEP), _MOST_STEP)
            step[k] = t
            outward = (t < 0.0 and x[k] <= where.lower[k] + 1e-9) or (
                t > 0.0 and x[k] >= where.upper[k] - 1e-9
            )
            if outward:
                free[k] = 0.0
                step[k] = 0.0
                again = True
        if not again:
            return


@inlined
def _cholesky_solve(A: Array, b: Array, m: int) -> None:
    """Solve ``A b' = b`` in place for a positive definite lower triangle, shape (m, m)."""
    for i in range(m):
        for j in range(i + 1):
            t = A[i, j]
            for k in range(j):
                t -= A[i, k] * A[j, k]
            A[i, j] = math.sqrt(max(t, 1e-14)) if i == j else t / A[j, j]
    for i in range(m):
        t = b[i]
        for k in range(i):
            t -= A[i, k] * b[k]
        b[i] = t / A[i, i]
    for i in range(m - 1, -1, -1):
        t = b[i]
        for k in range(i + 1, m):
            t -= A[k, i] * b[k]
        b[i] = t / A[i, i]
