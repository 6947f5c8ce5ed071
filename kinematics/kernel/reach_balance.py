"""Compiled: the inequalities of a standing robot, the CoM's margin and the limits of the legs, as rows."""

from __future__ import annotations

import math

from kinematics.kernel.compiler import inlined
from kinematics.kernel.coordinates import Coordinates, Limits
from kinematics.kernel.forward_kinematics import centre_of_mass, place_bodies
from kinematics.kernel.posture import configuration
from kinematics.kernel.reach_problem import MOST_ROWS, Array, ReachSpace, Scratch
from kinematics.kernel.tree import Tree

_BASE = 1
"""The body of the floating base."""
_PROBE = 1e-6
"""Step of the differences that give the legs' and the CoM's slopes along the base, m and rad."""
_INSIDE = 1e-4
"""Inequalities are steered this far inside, m or rad, so that they are reached in few steps."""


@inlined
def broken_limits(
    tree: Tree, space: Coordinates, limits: Limits, q: Array, R: Array, p: Array, com: Array, broken: Array
) -> float:
    """By how much each inequality is broken (negative while it holds), and the most of them."""
    if limits.offset.shape[0] > 0:
        centre_of_mass(tree, R, p, com)
    return overstepped(tree, space, limits, q, com, broken)


@inlined
def overstepped(tree: Tree, space: Coordinates, limits: Limits, q: Array, com: Array, broken: Array) -> float:
    """As ``broken_limits``, with the CoM known."""
    worst = -math.inf
    edges = limits.offset.shape[0]
    for k in range(edges):
        broken[k] = limits.offset[k] - limits.inward[k, 0] * com[0] - limits.inward[k, 1] * com[1]
        worst = max(worst, float(broken[k]))
    at = edges
    for leg in range(space.leg_bodies.shape[0]):
        for k in range(6):
            column = tree.column[space.leg_bodies[leg, k]]
            over, under = q[column] - limits.upper[column], limits.lower[column] - q[column]
            broken[at] = over if over > under else under
            worst = max(worst, float(broken[at]))
            at += 1
    return worst


@inlined
def _split_mass(tree: Tree, space: Coordinates, memory: Scratch) -> None:
    """Mark base and legs; all the rest moves with the base as one body, of a mass and a moment of it."""
    memory.legs[:] = 0
    memory.legs[_BASE] = 1
    for leg in range(space.leg_bodies.shape[0]):
        for k in range(6):
            memory.legs[space.leg_bodies[leg, k]] = 1
    memory.rest[:] = 0.0
    base_R, base_p = memory.R[_BASE], memory.p[_BASE]
    for body in range(1, tree.parent.shape[0]):
        if memory.legs[body] == 1 and body != _BASE:
            continue
        m, lever, R, p = tree.mass[body], tree.lever[body], memory.R[body], memory.p[body]
        d0 = p[0] + R[0, 0] * lever[0] + R[0, 1] * lever[1] + R[0, 2] * lever[2] - base_p[0]
        d1 = p[1] + R[1, 0] * lever[0] + R[1, 1] * lever[1] + R[1, 2] * lever[2] - base_p[1]
        d2 = p[2] + R[2, 0] * lever[0] + R[2, 1] * lever[1] + R[2, 2] * lever[2] - base_p[2]
        memory.rest[3] += m
        for r in range(3):
            memory.rest[r] += m * (base_R[0, r] * d0 + base_R[1, r] * d1 + base_R[2, r] * d2)


@inlined
def _com_over_legs(tree: Tree, memory: Scratch) -> None:
    """The CoM from the legs, which are placed anew, and the rest, which the base carries."""
    rest, base_R, base_p = memory.rest, memory.R[_BASE], memory.p[_BASE]
    total = rest[3]
    for r in range(3):
        turned = base_R[r, 0] * rest[0] + base_R[r, 1] * rest[1] + base_R[r, 2] * rest[2]
        memory.com[r] = rest[3] * base_p[r] + turned
    for body in range(_BASE + 1, tree.parent.shape[0]):
        if memory.legs[body] == 0:
            continue
        m, lever, R, p = tree.mass[body], tree.lever[body], memory.R[body], memory.p[body]
        total += m
        for r in range(3):
            turned = R[r, 0] * lever[0] + R[r, 1] * lever[1] + R[r, 2] * lever[2]
            memory.com[r] += m * (p[r] + turned)
    for r in range(3):
        memory.com[r] /= total


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
    for k in range(inequalities):
        if memory.broken[k] > 0.0 and m < MOST_ROWS:
            memory.wanted[m] = -memory.broken[k] - _INSIDE
            for c in range(x.shape[0]):
                memory.rows[m, c] = 0.0
            m += 1
    if edges > 0:
        _com_columns(tree, limits, where, inequalities, memory)
    if space.floating == 1:
        _split_mass(tree, space, memory)
        for c in range(x.shape[0]):
            memory.probe[c] = x[c]
        for c in range(6):
            memory.probe[c] = x[c] + _PROBE
            if configuration(space, tree, memory.probe, memory.probe_q, memory.base_R):
                place_bodies(tree, memory.probe_q, memory.legs, memory.R, memory.p)
                _com_over_legs(tree, memory)
                overstepped(tree, space, limits, memory.probe_q, memory.com, memory.probe_broken)
                row = 6
                for k in range(inequalities):
                    if memory.broken[k] > 0.0 and row < MOST_ROWS:
                        memory.rows[row, c] = (memory.probe_broken[k] - memory.broken[k]) / _PROBE
                        row += 1
            memory.probe[c] = x[c]
    return m


@inlined
def _com_columns(tree: Tree, limits: Limits, where: ReachSpace, inequalities: int, memory: Scratch) -> None:
    """What the joints do to the CoM's distance from the edges that it is beyond."""
    n = tree.parent.shape[0]
    total = 0.0
    for body in range(n):
        memory.mass[body] = tree.mass[body]
        R, p, lever = memory.R[body], memory.p[body], tree.lever[body]
        for r in range(3):
            centre = p[r] + R[r, 0] * lever[0] + R[r, 1] * lever[1] + R[r, 2] * lever[2]
            memory.moment[body, r] = tree.mass[body] * centre if body > 0 else 0.0
        total += tree.mass[body]
    for body in range(n - 1, 0, -1):
        parent = tree.parent[body]
        memory.mass[parent] += memory.mass[body]
        for r in range(3):
            memory.moment[parent, r] += memory.moment[body, r]
    for body in range(1, n):
        k = where.column[body]
        if k < 0 or where.freedom[k] == 0.0:
            continue
        R, axis, p = memory.R[body], tree.axis[body], memory.p[body]
        a0 = R[0, 0] * axis[0] + R[0, 1] * axis[1] + R[0, 2] * axis[2]
        a1 = R[1, 0] * axis[0] + R[1, 1] * axis[1] + R[1, 2] * axis[2]
        a2 = R[2, 0] * axis[0] + R[2, 1] * axis[1] + R[2, 2] * axis[2]
        m = memory.mass[body]
        d0 = memory.moment[body, 0] - m * p[0]
        d1 = memory.moment[body, 1] - m * p[1]
        d2 = memory.moment[body, 2] - m * p[2]
        vx = (a1 * d2 - a2 * d1) / total
        vy = (a2 * d0 - a0 * d2) / total
        row = 6
        for edge in range(inequalities):
            if memory.broken[edge] > 0.0 and row < MOST_ROWS:
                if edge < limits.offset.shape[0]:
                    memory.rows[row, k] = -limits.inward[edge, 0] * vx - limits.inward[edge, 1] * vy
                row += 1
