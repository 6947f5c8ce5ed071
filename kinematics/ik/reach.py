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

from kinematics.arrays import Array
from kinematics.compiled.compiler import compiled, inlined
from kinematics.ik.reach_balance import broken_limits, inequality_rows
from kinematics.ik.reach_pose import place_tool, pose_rows, tool_errors
from kinematics.ik.reach_problem import ReachGoal, ReachSettings, ReachSpace, Scratch
from kinematics.model.forward_kinematics import place_bodies
from kinematics.model.tree import WORLD, Tree
from kinematics.standing.flat_coordinates import Coordinates, Limits
from kinematics.standing.posture import configuration

_MOST_STEP = 0.4
"""Of a coordinate in one step, m or rad."""
_PATIENCE = 5
_HEADWAY = 0.9
"""In so many steps the errors have to shrink by this factor."""
_AT_BOUND = 1e-9
"""As near to a bound is at it."""


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
        memory: Scratch; ``memory.q`` is the configuration of the result, ``memory.noted`` tells what
            had to be kept.

    Returns:
        Steps taken, or -1 when it was not reached.
    """
    inequalities = limits.offset.shape[0] + 6 * space.leg_bodies.shape[0]
    moving = 0
    for k in range(x.shape[0]):
        x[k] = min(max(x[k], where.lower[k]), where.upper[k])
        if where.freedom[k] > 0.0:
            memory.moving[moving] = k
            moving += 1
    configuration(space, tree, x, memory.q, memory.base_R)
    whole = _lumped(tree, memory)
    memory.noted[:] = 0
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
        place_bodies(whole, memory.q, memory.needed, memory.R, memory.p)
        place_tool(goal, memory)
        far, turned = tool_errors(goal, memory)
        unbalanced, worst = broken_limits(
            whole, space, limits, memory.q, memory.R, memory.p, memory.com, memory.broken
        )
        if unbalanced > 0.0:
            memory.noted[0] = 1
        if far <= settings.position_m and turned <= settings.turn_rad and worst <= 0.0:
            return count
        if count % _PATIENCE == _PATIENCE - 1 and count > _PATIENCE:
            # neither an unreachable pose nor a dead end gets better by waiting
            now = far + 0.1 * turned + max(worst, 0.0)
            if now > _HEADWAY * last:
                return -1
            last = now
        m = 6
        for k in range(x.shape[0]):
            memory.freedom[k] = where.freedom[k]
        pose_rows(whole, space, goal, where, x, memory)
        if worst > 0.0:
            m = inequality_rows(whole, space, limits, where, inequalities, x, memory)
        _solve_step(where, settings, m, moving, x, memory)
        for at in range(moving):
            k = memory.moving[at]
            x[k] = min(max(x[k] + memory.step[k], where.lower[k]), where.upper[k])
        if space.floating == 1 and x[2] <= where.lower[2] + _AT_BOUND:
            memory.noted[1] = 1
    return -1


@compiled
def reach_in_turn(
    tree: Tree,
    space: Coordinates,
    limits: Limits,
    farthest: Array,
    goal: ReachGoal,
    targets: Array,
    where: ReachSpace,
    settings: ReachSettings,
    x: Array,
    found: Array,
    memory: Scratch,
) -> int:
    """Bring a frame to one pose after another, each from the posture at the last one and near to it.

    Args:
        tree, space, limits, where, settings, memory: As for ``reach``; ``where.reference`` is overwritten.
        farthest: Offsets of the CoM's margin to be content with where those of ``limits`` cannot be kept.
        goal: The frame; its target is overwritten.
        targets: The poses, shape (m, 4, 4).
        x: Where it begins, shape (n,); overwritten.
        found: Result, configurations, shape (m, nq).

    Returns:
        How many of the poses were reached.
    """
    content = Limits(lower=limits.lower, upper=limits.upper, inward=limits.inward, offset=farthest)
    for row in range(targets.shape[0]):
        for r in range(3):
            goal.target_p[r] = targets[row, r, 3]
            for k in range(3):
                goal.target_R[r, k] = targets[row, r, k]
        where.reference[:] = x
        if reach(tree, space, limits, goal, where, settings, x, memory) < 0:
            if memory.noted[0] == 0:
                # the CoM was not what was in the way
                return row
            x[:] = where.reference
            if reach(tree, space, content, goal, where, settings, x, memory) < 0:
                return row
        found[row, :] = memory.q
    return int(targets.shape[0])


@inlined
def _lumped(tree: Tree, memory: Scratch) -> Tree:
    """The tree with what does not move in the search as part of what carries it."""
    place_bodies(tree, memory.q, memory.everything, memory.R, memory.p)
    weight, lever = memory.weight, memory.lever
    weight[:] = tree.mass
    lever[:, :] = tree.lever
    for body in range(tree.parent.shape[0] - 1, 0, -1):
        m = weight[body]
        if memory.needed[body] == 1 or m == 0.0:
            continue
        weight[body] = 0.0
        a = tree.parent[body]
        if a == WORLD:
            continue
        R, p, A, b = memory.R[body], memory.p[body], memory.R[a], memory.p[a]
        d0 = p[0] + R[0, 0] * lever[body, 0] + R[0, 1] * lever[body, 1] + R[0, 2] * lever[body, 2] - b[0]
        d1 = p[1] + R[1, 0] * lever[body, 0] + R[1, 1] * lever[body, 1] + R[1, 2] * lever[body, 2] - b[1]
        d2 = p[2] + R[2, 0] * lever[body, 0] + R[2, 1] * lever[body, 1] + R[2, 2] * lever[body, 2] - b[2]
        both = weight[a] + m
        for r in range(3):
            own = A[0, r] * d0 + A[1, r] * d1 + A[2, r] * d2
            lever[a, r] = (weight[a] * lever[a, r] + m * own) / both
        weight[a] = both
    return Tree(
        parent=tree.parent,
        kind=tree.kind,
        column=tree.column,
        spin=tree.spin,
        axis=tree.axis,
        turned=tree.turned,
        place_R=tree.place_R,
        place_p=tree.place_p,
        mass=weight,
        lever=lever,
    )


@inlined
def _solve_step(
    where: ReachSpace, settings: ReachSettings, m: int, moving: int, x: Array, memory: Scratch
) -> None:
    """The step: least weighted change that satisfies the rows, the posture pulled in what is left."""
    J, A, free, step, columns = memory.rows, memory.system, memory.freedom, memory.step, memory.moving
    right = memory.right
    for _ in range(4):
        for r in range(m):
            for s in range(r + 1):
                t = settings.damping if r == s else 0.0
                for at in range(moving):
                    k = columns[at]
                    t += J[r, k] * J[s, k] * free[k]
                A[r, s] = t
        for r in range(m):
            t = memory.wanted[r]
            for at in range(moving):
                k = columns[at]
                if free[k] > 0.0:
                    t -= J[r, k] * settings.pull * (where.reference[k] - x[k])
            right[r] = t
        _cholesky_solve(A, right, m)
        again = False
        for at in range(moving):
            k = columns[at]
            step[k] = 0.0
            if free[k] == 0.0:
                continue
            t = settings.pull * (where.reference[k] - x[k])
            for r in range(m):
                t += free[k] * J[r, k] * right[r]
            t = min(max(t, -_MOST_STEP), _MOST_STEP)
            step[k] = t
            outward = (t < 0.0 and x[k] <= where.lower[k] + _AT_BOUND) or (
                t > 0.0 and x[k] >= where.upper[k] - _AT_BOUND
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
