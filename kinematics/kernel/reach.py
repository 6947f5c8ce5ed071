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
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kinematics.kernel.compiler import compiled
from kinematics.kernel.coordinates import Coordinates, Limits
from kinematics.kernel.forward_kinematics import centre_of_mass, place_bodies
from kinematics.kernel.posture import configuration
from kinematics.kernel.tree import WORLD, Tree

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

MOST_ROWS = 40
"""The frame's six, edges of the support polygon, limits of the legs."""
_PROBE = 1e-6
"""Step of the differences that give the legs' and the CoM's slopes along the base, m and rad."""
_FARTHEST_M, _FARTHEST_RAD = 0.2, 0.8
"""Errors beyond these are approached in steps: linearised farther they mislead."""
_MOST_STEP = 0.4
"""Of a coordinate in one step, m or rad."""
_INSIDE = 1e-4
"""Inequalities are steered this far inside, m or rad, so that they are reached in few steps."""


class ReachSettings(NamedTuple):
    """How the search goes.

    Attributes:
        position_m, turn_rad: The frame is there when both errors are smaller.
        damping: Added to the diagonal of the system.
        pull: Share of the way to the reference posture that a step takes in the null space.
        most_steps: For one start.
    """

    position_m: float
    turn_rad: float
    damping: float
    pull: float
    most_steps: int


class ReachGoal(NamedTuple):
    """What is to be reached.

    Attributes:
        body: Body that carries the frame.
        offset_R, offset_p: The frame in the body, shapes (3, 3) and (3,).
        target_R, target_p: The frame's wanted pose in the world.
    """

    body: int
    offset_R: Array
    offset_p: Array
    target_R: Array
    target_p: Array


class ReachSpace(NamedTuple):
    """Where it is searched.

    Attributes:
        lower, upper: Bounds of the coordinates, shape (n,).
        freedom: How willingly each one moves; 0 holds it, shape (n,).
        reference: Posture that is preferred, shape (n,).
        column: Coordinate of each body's joint, or -1, shape (bodies,).
    """

    lower: Array
    upper: Array
    freedom: Array
    reference: Array
    column: Indices


class Scratch(NamedTuple):
    """Memory of one search."""

    q: Array
    base_R: Array
    needed: Indices
    R: Array
    p: Array
    com: Array
    tool_R: Array
    tool_p: Array
    rows: Array
    wanted: Array
    broken: Array
    probe: Array
    probe_q: Array
    probe_broken: Array
    system: Array
    right: Array
    freedom: Array
    step: Array
    mass: Array
    moment: Array


def scratch(tree: Tree, nq: int, coordinates: int) -> Scratch:
    """Memory for a robot with configurations of shape (nq,) and so many free coordinates."""
    bodies = len(tree.parent)
    edges = MOST_ROWS - 6
    return Scratch(
        q=np.zeros(nq),
        base_R=np.eye(3),
        needed=np.ones(bodies, np.int64),
        R=np.zeros((bodies, 3, 3)),
        p=np.zeros((bodies, 3)),
        com=np.zeros(3),
        tool_R=np.eye(3),
        tool_p=np.zeros(3),
        rows=np.zeros((MOST_ROWS, coordinates)),
        wanted=np.zeros(MOST_ROWS),
        broken=np.zeros(edges),
        probe=np.zeros(coordinates),
        probe_q=np.zeros(nq),
        probe_broken=np.zeros(edges),
        system=np.zeros((MOST_ROWS, MOST_ROWS)),
        right=np.zeros(MOST_ROWS),
        freedom=np.zeros(coordinates),
        step=np.zeros(coordinates),
        mass=np.zeros(bodies),
        moment=np.zeros((bodies, 3)),
    )


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
        _place_tool(goal, memory)
        far, turned = _errors(goal, memory)
        worst = _broken(tree, space, limits, memory.q, memory.R, memory.p, memory.com, memory.broken)
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
        _pose_rows(tree, space, goal, where, x, memory)
        if worst > 0.0:
            m = _inequality_rows(tree, space, limits, where, inequalities, x, memory)
        _solve(where, settings, m, x, memory)
        for k in range(x.shape[0]):
            x[k] = min(max(x[k] + memory.step[k], where.lower[k]), where.upper[k])
    return -1


@compiled
def _place_tool(goal: ReachGoal, memory: Scratch) -> None:
    R, p = memory.R[goal.body], memory.p[goal.body]
    for r in range(3):
        memory.tool_p[r] = p[r]
        for k in range(3):
            memory.tool_p[r] += R[r, k] * goal.offset_p[k]
            t = 0.0
            for s in range(3):
                t += R[r, s] * goal.offset_R[s, k]
            memory.tool_R[r, k] = t


@compiled
def _errors(goal: ReachGoal, memory: Scratch) -> tuple[float, float]:
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


@compiled
def _broken(
    tree: Tree, space: Coordinates, limits: Limits, q: Array, R: Array, p: Array, com: Array, broken: Array
) -> float:
    """By how much each inequality is broken (negative while it holds), and the most of them."""
    worst = -math.inf
    edges = limits.offset.shape[0]
    if edges > 0:
        centre_of_mass(tree, R, p, com)
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


@compiled
def _pose_rows(
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
            a0, a1, a2 = _turning_axis(x, r)
            _turn_column(J, 3 + r, a0, a1, a2, memory.q, tip)


@compiled
def _turn_column(J: Array, k: int, a0: float, a1: float, a2: float, origin: Array, tip: Array) -> None:
    d0, d1, d2 = tip[0] - origin[0], tip[1] - origin[1], tip[2] - origin[2]
    J[0, k] = a1 * d2 - a2 * d1
    J[1, k] = a2 * d0 - a0 * d2
    J[2, k] = a0 * d1 - a1 * d0
    J[3, k], J[4, k], J[5, k] = a0, a1, a2


@compiled
def _turning_axis(x: Array, k: int) -> tuple[float, float, float]:
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


@compiled
def _inequality_rows(
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
        for c in range(x.shape[0]):
            memory.probe[c] = x[c]
        for c in range(6):
            memory.probe[c] = x[c] + _PROBE
            if configuration(space, tree, memory.probe, memory.probe_q, memory.base_R):
                place_bodies(tree, memory.probe_q, memory.needed, memory.R, memory.p)
                _broken(
                    tree,
                    space,
                    limits,
                    memory.probe_q,
                    memory.R,
                    memory.p,
                    memory.com,
                    memory.probe_broken,
                )
                row = 6
                for k in range(inequalities):
                    if memory.broken[k] > 0.0 and row < MOST_ROWS:
                        memory.rows[row, c] = (memory.probe_broken[k] - memory.broken[k]) / _PROBE
                        row += 1
            memory.probe[c] = x[c]
    return m


@compiled
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


@compiled
def _solve(where: ReachSpace, settings: ReachSettings, m: int, x: Array, memory: Scratch) -> None:
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


@compiled
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
