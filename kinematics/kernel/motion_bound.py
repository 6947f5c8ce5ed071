"""Compiled: how far bodies can move against each other while joints and base move a little."""

from __future__ import annotations

import math

from kinematics.arrays import Array, Indices
from kinematics.compiled.compiler import compiled, inlined
from kinematics.kernel.chains import Chains
from kinematics.kernel.memory import Memory, problem_at, work_at
from kinematics.model.tree import FLOATING, SLIDE, Tree

Sweep = tuple[float, float, float, float, float, float, float]
"""Displacement of a ball's centre and turn, of first order, and what points of the ball can deviate, m."""
Direction = tuple[float, float, float]
STILL: Sweep = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


@compiled
def bound_motion(
    tree: Tree,
    chains: Chains,
    needed: Indices,
    R: Array,
    p: Array,
    reach: Array,
    step: float,
    turn: float,
    spin: Array,
    moved: Array,
) -> None:
    """Bound each body's displacement against every body on its way to the world.

    Joints are moved one after the other, the outermost first: each carries a point along an arc about
    an axis that still is where it is now, at a distance that has grown by no more than what the
    joints before it did. So the bound is rigorous, and of first order it is the true one.

    Args:
        tree, chains: The robot.
        needed: 0 for bodies that nobody asks for, shape (n,).
        R, p: Poses of the bodies.
        reach: No joint moves farther than this, by body, shape (n,), rad or m.
        step, turn: Nor does the base, m and rad.
        spin: Result, world axes of the needed bodies' joints, shape (n, 3).
        moved: Result, by body and number of joints crossed, shape (n, depth + 1), m: no point of a
            body moves farther against the body that is so many joints away.
    """
    for body in range(1, tree.parent.shape[0]):
        if needed[body] == 1:
            axis = tree.axis[body]
            for r in range(3):
                spin[body, r] = R[body, r, 0] * axis[0] + R[body, r, 1] * axis[1] + R[body, r, 2] * axis[2]
    for body in range(1, tree.parent.shape[0]):
        if needed[body] == 0:
            continue
        c = chains.centre[body]
        radius = chains.radius[body]
        c0 = p[body, 0] + R[body, 0, 0] * c[0] + R[body, 0, 1] * c[1] + R[body, 0, 2] * c[2]
        c1 = p[body, 1] + R[body, 1, 0] * c[0] + R[body, 1, 1] * c[1] + R[body, 1, 2] * c[2]
        c2 = p[body, 2] + R[body, 2, 0] * c[0] + R[body, 2, 1] * c[1] + R[body, 2, 2] * c[2]
        so_far = 0.0
        moved[body, 0] = 0.0
        for crossed in range(chains.length[body]):
            k = chains.joint[body, crossed]
            kind = tree.kind[k]
            d0 = c0 - p[k, 0]
            d1 = c1 - p[k, 1]
            d2 = c2 - p[k, 2]
            if kind == FLOATING:
                if step > 0.0 or turn > 0.0:
                    so_far += step + turn * (math.sqrt(d0 * d0 + d1 * d1 + d2 * d2) + radius + so_far)
            elif reach[k] > 0.0:
                if kind == SLIDE:
                    so_far += reach[k]
                else:
                    a0, a1, a2 = spin[k, 0], spin[k, 1], spin[k, 2]
                    x = a1 * d2 - a2 * d1
                    y = a2 * d0 - a0 * d2
                    z = a0 * d1 - a1 * d0
                    so_far += reach[k] * (math.sqrt(x * x + y * y + z * z) + radius + so_far)
            moved[body, crossed + 1] = so_far


@compiled
def swept(memory: Memory, body: int, levels: int, x: float, y: float, z: float, radius: float) -> Sweep:
    """How a ball on a body moves in half an interval against the body that is so many joints away.

    Joints move at one speed each. Then the velocity of a point is the sum of ``rate * axis x lever`` over
    the joints, and its acceleration the sum of ``rate_i * rate_k * axis_i x (axis_k x lever_k)`` over
    all pairs of them, ``k`` being the outer one; a slide has its axis in place of ``axis x lever``.
    No lever grows by more than what the joints outside of it move the point. The base is one more joint,
    whose axis and speed change by as much as ``drift`` says.

    Args:
        memory: Bodies, ``rate``, ``spin``, ``moved`` and ``drift`` in place.
        body, levels: The ball's body, and how many joints to cross.
        x, y, z, radius: The ball, m.

    Returns:
        Displacement of the centre and turn of the ball to one side, of first order; and a bound of what
        any point's displacement differs from that, NaN when there is none.
    """
    problem, work = problem_at(memory), work_at(memory)
    tree, chains = problem.tree, problem.chains
    v0 = v1 = v2 = o0 = o1 = o2 = 0.0
    bend = 0.0
    levers = 0.0
    for crossed in range(levels):
        k = chains.joint[body, crossed]
        rate = work.rate[k]
        if rate == 0.0:
            continue
        if math.isnan(rate):
            return v0, v1, v2, o0, o1, o2, math.nan
        if tree.kind[k] == FLOATING:
            base = work.drift
            d0 = x - work.p[k, 0]
            d1 = y - work.p[k, 1]
            d2 = z - work.p[k, 2]
            v0 += base[0] + base[4] * d2 - base[5] * d1
            v1 += base[1] + base[5] * d0 - base[3] * d2
            v2 += base[2] + base[3] * d1 - base[4] * d0
            o0 += base[3]
            o1 += base[4]
            o2 += base[5]
            lever = base[6] * (math.sqrt(d0 * d0 + d1 * d1 + d2 * d2) + radius + work.moved[body, crossed])
            bend += base[6] * (lever * (1.0 + base[7]) + 2.0 * levers)
            levers += lever
            continue
        a0 = rate * work.spin[k, 0]
        a1 = rate * work.spin[k, 1]
        a2 = rate * work.spin[k, 2]
        if tree.kind[k] == SLIDE:
            v0 += a0
            v1 += a1
            v2 += a2
            levers += abs(rate)
            continue
        d0 = x - work.p[k, 0]
        d1 = y - work.p[k, 1]
        d2 = z - work.p[k, 2]
        c0 = a1 * d2 - a2 * d1
        c1 = a2 * d0 - a0 * d2
        c2 = a0 * d1 - a1 * d0
        v0 += c0
        v1 += c1
        v2 += c2
        o0 += a0
        o1 += a1
        o2 += a2
        lever = math.sqrt(c0 * c0 + c1 * c1 + c2 * c2) + abs(rate) * (radius + work.moved[body, crossed])
        bend += abs(rate) * (lever + 2.0 * levers)
        levers += lever
    return v0, v1, v2, o0, o1, o2, 0.5 * bend


@inlined
def base_drift(x: Array, start: Array, end: Array, half: float, drift: Array) -> None:
    """How the base moves in half an interval of a line of free coordinates.

    Its place moves at one speed, its rotation vector ``r`` changes by ``d`` at one speed. The angular
    velocity is ``J(r) d``, ``J`` the left Jacobian ``1 + A [r] + B [r]^2`` with ``A = (1 - cos t) / t^2``,
    ``B = (t - sin t) / t^3``, ``t = |r|``. It is no larger than ``|d|``, and as ``[d] d = 0`` its derivative
    is no larger than ``|d|^2 (|A'| t + |B'| t^2 + B t)``. ``|A'| <= t / 12``, ``|B'| <= t / 60``,
    ``B <= 1 / 6``.

    Args:
        x: The middle of the interval, free coordinates.
        start, end: Of the whole line.
        half: Half the interval's share of the line.
        drift: Result: displacement (m) and turn (rad) of first order, how far the base turns at most, and
            by which share of its square the turn can change.
    """
    for r in range(3):
        drift[r] = (end[r] - start[r]) * half
    r0, r1, r2 = x[3], x[4], x[5]
    d0, d1, d2 = (end[3] - start[3]) * half, (end[4] - start[4]) * half, (end[5] - start[5]) * half
    t = math.sqrt(r0 * r0 + r1 * r1 + r2 * r2)
    a = 0.5 - t * t / 24.0 if t < 1e-3 else (1.0 - math.cos(t)) / (t * t)
    b = (1.0 - t * t / 20.0) / 6.0 if t < 1e-3 else (t - math.sin(t)) / (t * t * t)
    c0 = r1 * d2 - r2 * d1
    c1 = r2 * d0 - r0 * d2
    c2 = r0 * d1 - r1 * d0
    drift[3] = d0 + a * c0 + b * (r1 * c2 - r2 * c1)
    drift[4] = d1 + a * c1 + b * (r2 * c0 - r0 * c2)
    drift[5] = d2 + a * c2 + b * (r0 * c1 - r1 * c0)
    angle = math.sqrt(d0 * d0 + d1 * d1 + d2 * d2)
    widest = t + angle
    drift[6] = angle
    drift[7] = widest * (1.0 / 6.0 + widest / 12.0 + widest * widest / 60.0)


@inlined
def nearing(
    direction: Direction, first: Sweep, first_radius: float, second: Sweep, second_radius: float
) -> float:
    """How much the gap of two balls along a direction can shrink, m; NaN when it is not known.

    Args:
        direction: A unit vector of the world.
        first, second: Motion of the two, of ``swept``.
        first_radius, second_radius: Their sizes, m.
    """
    n0, n1, n2 = direction
    along = n0 * (first[0] - second[0]) + n1 * (first[1] - second[1]) + n2 * (first[2] - second[2])
    shrinks: float = (
        abs(along)
        + first_radius * _across(n0, n1, n2, first[3], first[4], first[5])
        + second_radius * _across(n0, n1, n2, second[3], second[4], second[5])
        + first[6]
        + second[6]
    )
    return shrinks


@inlined
def _across(n0: float, n1: float, n2: float, o0: float, o1: float, o2: float) -> float:
    c0 = n1 * o2 - n2 * o1
    c1 = n2 * o0 - n0 * o2
    c2 = n0 * o1 - n1 * o0
    return math.sqrt(c0 * c0 + c1 * c1 + c2 * c2)
