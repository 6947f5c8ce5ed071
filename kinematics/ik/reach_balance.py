"""Compiled: the inequalities of a standing robot, the CoM's margin and the limits of the legs, as rows."""

from __future__ import annotations

import math

from kinematics.arrays import Array
from kinematics.compiled.compiler import inlined
from kinematics.ik.reach_pose import turning_axis
from kinematics.ik.reach_problem import MOST_ROWS, ReachSpace, Scratch
from kinematics.model.forward_kinematics import centre_of_mass
from kinematics.model.tree import WORLD, Tree
from kinematics.standing.flat_coordinates import Coordinates, Limits

_BASE = 1
"""The body of the floating base."""
_SINGULAR = 1e-6
"""A pivot below this tells that a leg is stretched."""
_INSIDE = 1e-4
"""Inequalities are steered this far inside, m or rad, so that they are reached in few steps."""


@inlined
def broken_limits(
    tree: Tree, space: Coordinates, limits: Limits, q: Array, R: Array, p: Array, com: Array, broken: Array
) -> tuple[float, float]:
    """By how much each inequality is broken (negative while it holds), into ``broken``.

    Returns:
        The most that the CoM's margin is broken, and the most of all.
    """
    worst = -math.inf
    edges = limits.offset.shape[0]
    if edges > 0:
        centre_of_mass(tree, R, p, com)
    for k in range(edges):
        broken[k] = limits.offset[k] - limits.inward[k, 0] * com[0] - limits.inward[k, 1] * com[1]
        worst = max(worst, float(broken[k]))
    unbalanced = worst
    at = edges
    for leg in range(space.leg_bodies.shape[0]):
        for k in range(6):
            column = tree.column[space.leg_bodies[leg, k]]
            over, under = q[column] - limits.upper[column], limits.lower[column] - q[column]
            broken[at] = over if over > under else under
            worst = max(worst, float(broken[at]))
            at += 1
    return unbalanced, worst


@inlined
def inequality_rows(
    tree: Tree,
    space: Coordinates,
    limits: Limits,
    where: ReachSpace,
    inequalities: int,
    x: Array,
    memory: Scratch,
) -> int:
    """One row for each broken inequality, after the pose's; gives the number of all rows."""
    m = 6
    edges = limits.offset.shape[0]
    unbalanced = False
    for k in range(inequalities):
        if memory.broken[k] > 0.0 and m < MOST_ROWS:
            memory.wanted[m] = -memory.broken[k] - _INSIDE
            unbalanced = unbalanced or k < edges
            for c in range(x.shape[0]):
                memory.rows[m, c] = 0.0
            m += 1
    if unbalanced:
        _add_up(tree, memory)
        _com_columns(tree, limits, where, inequalities, memory)
    if space.floating == 1:
        _base_columns(tree, space, limits, inequalities, unbalanced, x, memory)
    return m


@inlined
def _add_up(tree: Tree, memory: Scratch) -> None:
    """Mass of each body with all that hangs on it, and its moment about the world's origin."""
    n = tree.parent.shape[0]
    for body in range(n):
        m, R, p, lever = tree.mass[body], memory.R[body], memory.p[body], tree.lever[body]
        memory.mass[body] = m
        for r in range(3):
            centre = p[r] + R[r, 0] * lever[0] + R[r, 1] * lever[1] + R[r, 2] * lever[2]
            memory.moment[body, r] = m * centre if m > 0.0 else 0.0
    for body in range(n - 1, 0, -1):
        parent = tree.parent[body]
        memory.mass[parent] += memory.mass[body]
        for r in range(3):
            memory.moment[parent, r] += memory.moment[body, r]


@inlined
def _com_speed(tree: Tree, memory: Scratch, body: int) -> tuple[float, float, float]:
    """Velocity of the CoM for a unit rate of a body's hinge; the base does not move."""
    R, axis, p = memory.R[body], tree.axis[body], memory.p[body]
    a0 = R[0, 0] * axis[0] + R[0, 1] * axis[1] + R[0, 2] * axis[2]
    a1 = R[1, 0] * axis[0] + R[1, 1] * axis[1] + R[1, 2] * axis[2]
    a2 = R[2, 0] * axis[0] + R[2, 1] * axis[1] + R[2, 2] * axis[2]
    m, total = memory.mass[body], memory.mass[WORLD]
    d0 = memory.moment[body, 0] - m * p[0]
    d1 = memory.moment[body, 1] - m * p[1]
    d2 = memory.moment[body, 2] - m * p[2]
    return (a1 * d2 - a2 * d1) / total, (a2 * d0 - a0 * d2) / total, (a0 * d1 - a1 * d0) / total


@inlined
def _com_columns(tree: Tree, limits: Limits, where: ReachSpace, inequalities: int, memory: Scratch) -> None:
    """What the joints do to the CoM's distance from the edges that it is beyond."""
    for body in range(1, tree.parent.shape[0]):
        k = where.column[body]
        if k < 0 or where.freedom[k] == 0.0:
            continue
        vx, vy, _ = _com_speed(tree, memory, body)
        row = 6
        for edge in range(inequalities):
            if memory.broken[edge] > 0.0 and row < MOST_ROWS:
                if edge < limits.offset.shape[0]:
                    memory.rows[row, k] = -limits.inward[edge, 0] * vx - limits.inward[edge, 1] * vy
                row += 1


@inlined
def _base_columns(
    tree: Tree,
    space: Coordinates,
    limits: Limits,
    inequalities: int,
    unbalanced: bool,
    x: Array,
    memory: Scratch,
) -> None:
    """What the base does to all of them, the legs following it."""
    _leg_rates(tree, space, x, memory)
    edges, legs, rates = limits.offset.shape[0], space.leg_bodies, memory.leg_rates
    com, base = memory.com, memory.p[_BASE]
    for c in range(6):
        s0 = s1 = 0.0
        if unbalanced:
            # everything goes with the base, and the legs turn against it
            if c < 3:
                s0, s1 = (1.0 if c == 0 else 0.0), (1.0 if c == 1 else 0.0)
            else:
                a0, a1, a2 = turning_axis(x, c - 3)
                d0, d1, d2 = com[0] - base[0], com[1] - base[1], com[2] - base[2]
                s0, s1 = a1 * d2 - a2 * d1, a2 * d0 - a0 * d2
            for leg in range(legs.shape[0]):
                for k in range(6):
                    vx, vy, _ = _com_speed(tree, memory, legs[leg, k])
                    s0 += rates[leg, k, c] * vx
                    s1 += rates[leg, k, c] * vy
        row = 6
        for k in range(inequalities):
            if memory.broken[k] > 0.0 and row < MOST_ROWS:
                if k < edges:
                    memory.rows[row, c] = -limits.inward[k, 0] * s0 - limits.inward[k, 1] * s1
                else:
                    leg, joint = (k - edges) // 6, (k - edges) % 6
                    column = tree.column[legs[leg, joint]]
                    over = memory.q[column] > limits.upper[column]
                    memory.rows[row, c] = rates[leg, joint, c] if over else -rates[leg, joint, c]
                row += 1


@inlined
def _leg_rates(tree: Tree, space: Coordinates, x: Array, memory: Scratch) -> None:
    """How fast the legs' joints turn for a unit rate of each of the base's coordinates: ankles rest.

    Where a leg is stretched it cannot follow, and nothing is known.
    """
    legs, A, base = space.leg_bodies, memory.leg_system, memory.p[_BASE]
    for leg in range(legs.shape[0]):
        ankle = memory.p[legs[leg, 5]]
        for k in range(6):
            body = legs[leg, k]
            R, axis, p = memory.R[body], tree.axis[body], memory.p[body]
            a0 = R[0, 0] * axis[0] + R[0, 1] * axis[1] + R[0, 2] * axis[2]
            a1 = R[1, 0] * axis[0] + R[1, 1] * axis[1] + R[1, 2] * axis[2]
            a2 = R[2, 0] * axis[0] + R[2, 1] * axis[1] + R[2, 2] * axis[2]
            d0, d1, d2 = ankle[0] - p[0], ankle[1] - p[1], ankle[2] - p[2]
            A[0, k], A[1, k], A[2, k] = a1 * d2 - a2 * d1, a2 * d0 - a0 * d2, a0 * d1 - a1 * d0
            A[3, k], A[4, k], A[5, k] = a0, a1, a2
        for c in range(3):
            for r in range(6):
                A[r, 6 + c] = -1.0 if r == c else 0.0
            a0, a1, a2 = turning_axis(x, c)
            d0, d1, d2 = ankle[0] - base[0], ankle[1] - base[1], ankle[2] - base[2]
            A[0, 9 + c], A[1, 9 + c], A[2, 9 + c] = a2 * d1 - a1 * d2, a0 * d2 - a2 * d0, a1 * d0 - a0 * d1
            A[3, 9 + c], A[4, 9 + c], A[5, 9 + c] = -a0, -a1, -a2
        solvable = _eliminate(A)
        for k in range(6):
            for c in range(6):
                memory.leg_rates[leg, k, c] = A[k, 6 + c] if solvable else 0.0


@inlined
def _eliminate(A: Array) -> bool:
    """Gauss and Jordan on a system of six with its right sides behind it, shape (6, 12)."""
    for column in range(6):
        best = column
        for row in range(column + 1, 6):
            if abs(A[row, column]) > abs(A[best, column]):
                best = row
        if abs(A[best, column]) < _SINGULAR:
            return False
        for k in range(column, 12):
            A[best, k], A[column, k] = A[column, k], A[best, k]
        part = 1.0 / A[column, column]
        for k in range(column, 12):
            A[column, k] *= part
        for row in range(6):
            part = A[row, column]
            if row != column and part != 0.0:
                for k in range(column, 12):
                    A[row, k] -= part * A[column, k]
    return True
