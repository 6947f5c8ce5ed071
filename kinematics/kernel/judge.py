"""Compiled: judge a configuration, points or a whole edge, each in one call that allocates nothing.

A pair is proven apart, cheapest first, by bounding balls, by the direction that separated it last,
and by GJK. On an edge every pair has to be farther apart in the middle of an interval than it can
move in half of it; pairs that are not are looked at again in both halves, and only they. So a free
edge is proven free everywhere, not at samples, and an edge that is not free is refused.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from kinematics.kernel.compiler import compiled
from kinematics.kernel.coordinates import Coordinates, Limits
from kinematics.kernel.forward_kinematics import centre_of_mass, place_bodies
from kinematics.kernel.motion_bound import bound_motion
from kinematics.kernel.pairs import Pairs
from kinematics.kernel.posture import com_room, configuration, leg_ranges, limits_kept
from kinematics.kernel.robot_arrays import Chains
from kinematics.kernel.separation import core_distance, point_distance
from kinematics.kernel.solids import HULL, Array, Indices, Solids
from kinematics.kernel.tree import Tree

FREE, REACH, LIMITS, BALANCE, CONTACT, UNPROVEN = 0, 1, 2, 3, 4, 5

# Status of a pair.
_APART, _OPEN, _TOUCHING = 0, 1, 2
# What is still open when nothing moves any more by this much stays unproven, m (and rad for limits).
RESOLUTION_M = 1e-4


class Problem(NamedTuple):
    """Everything that does not change from question to question."""

    tree: Tree
    chains: Chains
    space: Coordinates
    limits: Limits
    solids: Solids
    pairs: Pairs


class Work(NamedTuple):
    """Memory of the compiled code; the separating directions outlive a question.

    Attributes:
        x, q: A point and its configuration.
        base_R: Rotation of its base.
        R, p: Poses of bodies.
        com: Centre of mass.
        centre: Centres of the moving solids' balls.
        reach: How far each joint moves.
        moved: How far bodies move, as ``motion_bound`` writes it.
        axis: Separating direction of each pair.
        S, v: Scratch of GJK.
        first_R, first_p, second_R, second_p, R_between, p_between: Scratch of relative poses.
        open_pairs: Pairs that are open, two generations, shape (2, n).
        spans: Intervals that hold them: index, first and last open pair, whether the posture is open;
            two generations, shape (2, m, 4).
    """

    x: Array
    q: Array
    base_R: Array
    R: Array
    p: Array
    com: Array
    centre: Array
    reach: Array
    moved: Array
    axis: Array
    S: Array
    v: Array
    first_R: Array
    first_p: Array
    second_R: Array
    second_p: Array
    R_between: Array
    p_between: Array
    open_pairs: Indices
    spans: Indices


@compiled
def _pose_of(solids: Solids, solid: int, work: Work, R: Array, p: Array) -> None:
    """World pose of a solid's own frame."""
    body = solids.body[solid]
    B = work.R[body]
    at = work.p[body]
    if solids.kind[solid] == HULL:
        for r in range(3):
            p[r] = at[r]
            for k in range(3):
                R[r, k] = B[r, k]
        return
    P = solids.R[solid]
    offset = solids.p[solid]
    for r in range(3):
        p[r] = at[r] + B[r, 0] * offset[0] + B[r, 1] * offset[1] + B[r, 2] * offset[2]
        for k in range(3):
            R[r, k] = B[r, 0] * P[0, k] + B[r, 1] * P[1, k] + B[r, 2] * P[2, k]


@compiled
def _distance(
    solids: Solids, work: Work, first: int, second: int, axis: Array, enough: float, little: float
) -> float:
    """Lower bound of the distance of two placed solids; see ``core_distance``."""
    A, a, B, b = work.first_R, work.first_p, work.second_R, work.second_p
    R, p = work.R_between, work.p_between
    _pose_of(solids, first, work, A, a)
    _pose_of(solids, second, work, B, b)
    for r in range(3):
        p[r] = A[0, r] * (b[0] - a[0]) + A[1, r] * (b[1] - a[1]) + A[2, r] * (b[2] - a[2])
        for k in range(3):
            R[r, k] = A[0, r] * B[0, k] + A[1, r] * B[1, k] + A[2, r] * B[2, k]
    rounds = solids.round[first] + solids.round[second]
    pads = solids.pad[first] + solids.pad[second]
    off = rounds + pads
    found = core_distance(
        solids, first, second, False, R, p, enough + off, little + off, axis, work.S, work.v
    )
    if found - off > little or pads == 0.0:
        return found - off
    # the padded hulls are too near: the true ones decide
    found = core_distance(
        solids, first, second, True, R, p, enough + rounds, little + rounds, axis, work.S, work.v
    )
    return found - rounds


@compiled
def _place(problem: Problem, work: Work) -> None:
    """Place the bodies and the balls of the moving solids at ``work.q``."""
    place_bodies(problem.tree, work.q, work.R, work.p)
    solids = problem.solids
    for s in range(problem.pairs.moving):
        body = solids.body[s]
        R, p, c = work.R[body], work.p[body], solids.centre[s]
        for r in range(3):
            work.centre[s, r] = p[r] + R[r, 0] * c[0] + R[r, 1] * c[1] + R[r, 2] * c[2]


@compiled
def _judge_pair(problem: Problem, work: Work, pair: int) -> int:
    """Whether a pair is apart by its margin and by what both can move."""
    solids, pairs = problem.solids, problem.pairs
    count = pairs.first.shape[0]
    if pair < count:
        i = pairs.first[pair]
        j = pairs.second[pair]
        margin = pairs.margin[pair]
        slack = (
            work.moved[solids.body[i], pairs.first_level[pair]]
            + work.moved[solids.body[j], pairs.second_level[pair]]
        )
        d0 = work.centre[i, 0] - work.centre[j, 0]
        d1 = work.centre[i, 1] - work.centre[j, 1]
        d2 = work.centre[i, 2] - work.centre[j, 2]
        between = math.sqrt(d0 * d0 + d1 * d1 + d2 * d2)
        gap = between - solids.radius[i] - solids.radius[j]
    else:
        thing = (pair - count) // pairs.moving
        i = (pair - count) - thing * pairs.moving
        j = pairs.moving + thing
        margin = pairs.object_margin[thing]
        body = solids.body[i]
        slack = work.moved[body, problem.chains.length[body]]
        c = work.centre[i]
        between = point_distance(solids, j, c[0], c[1], c[2])
        gap = between - solids.radius[i]
    need = margin + slack
    if gap > need:
        return _APART
    if gap > margin and need >= between:
        # apart now, and not by so much: no closer look can prove it
        return _OPEN
    distance = _distance(solids, work, i, j, work.axis[pair], need, margin)
    if distance > need:
        return _APART
    return _OPEN if distance > margin else _TOUCHING


@compiled
def _slack(problem: Problem, work: Work, pair: int) -> float:
    """How far the two solids of a pair can move against each other, m."""
    solids, pairs = problem.solids, problem.pairs
    count = pairs.first.shape[0]
    if pair < count:
        first = work.moved[solids.body[pairs.first[pair]], pairs.first_level[pair]]
        return first + work.moved[solids.body[pairs.second[pair]], pairs.second_level[pair]]
    body = solids.body[(pair - count) % pairs.moving]
    return work.moved[body, problem.chains.length[body]]


@compiled
def _scan(problem: Problem, work: Work, found: Indices) -> tuple[int, int]:
    """Judge all pairs; list those that are open.

    Returns:
        A pair that touches, or -1; and how many were listed, or -1 when the list is full.
    """
    solids, pairs = problem.solids, problem.pairs
    count = pairs.first.shape[0]
    listed = 0
    centre, radius, moved = work.centre, solids.radius, work.moved
    for pair in range(count):
        i = pairs.first[pair]
        j = pairs.second[pair]
        d0 = centre[i, 0] - centre[j, 0]
        d1 = centre[i, 1] - centre[j, 1]
        d2 = centre[i, 2] - centre[j, 2]
        need = radius[i] + radius[j] + pairs.margin[pair]
        need += moved[solids.body[i], pairs.first_level[pair]]
        need += moved[solids.body[j], pairs.second_level[pair]]
        if d0 * d0 + d1 * d1 + d2 * d2 > need * need:
            continue
        status = _judge_pair(problem, work, pair)
        if status == _TOUCHING:
            return pair, listed
        if status == _OPEN:
            if listed >= found.shape[0]:
                return -1, -1
            found[listed] = pair
            listed += 1
    if pairs.object_margin.shape[0] == 0:
        return -1, listed
    for limb in range(pairs.limb_start.shape[0] - 1):
        first, last = pairs.limb_start[limb], pairs.limb_start[limb + 1]
        if first == last:
            continue
        # a ball about the limb: the one about the box of its balls
        low0 = low1 = low2 = math.inf
        high0 = high1 = high2 = -math.inf
        farthest = 0.0
        for at in range(first, last):
            s = pairs.limb_solids[at]
            r = radius[s]
            low0 = min(low0, centre[s, 0] - r)
            low1 = min(low1, centre[s, 1] - r)
            low2 = min(low2, centre[s, 2] - r)
            high0 = max(high0, centre[s, 0] + r)
            high1 = max(high1, centre[s, 1] + r)
            high2 = max(high2, centre[s, 2] + r)
            body = solids.body[s]
            farthest = max(farthest, moved[body, problem.chains.length[body]])
        c0, c1, c2 = 0.5 * (low0 + high0), 0.5 * (low1 + high1), 0.5 * (low2 + high2)
        around = math.sqrt((high0 - c0) ** 2 + (high1 - c1) ** 2 + (high2 - c2) ** 2) + farthest
        for thing in range(pairs.object_margin.shape[0]):
            solid = pairs.moving + thing
            margin = pairs.object_margin[thing]
            if point_distance(solids, solid, c0, c1, c2) > around + margin:
                continue
            for at in range(first, last):
                s = pairs.limb_solids[at]
                if pairs.judged[thing, s] == 0:
                    continue
                pair = count + thing * pairs.moving + s
                status = _judge_pair(problem, work, pair)
                if status == _TOUCHING:
                    return pair, listed
                if status == _OPEN:
                    if listed >= found.shape[0]:
                        return -1, -1
                    found[listed] = pair
                    listed += 1
    return -1, listed


@compiled
def contact_at(problem: Problem, work: Work, q: Array) -> int:
    """First pair that is nearer than its margin at a configuration, shape (nq,); -1 for none."""
    work.q[:] = q
    work.moved[:, :] = 0.0
    _place(problem, work)
    return _scan(problem, work, work.open_pairs[0])[0]


@compiled
def judge_point(problem: Problem, work: Work, x: Array) -> tuple[int, int]:
    """Verdict on one point of the free coordinates, and the pair of a contact or -1."""
    if not configuration(problem.space, problem.tree, x, work.q, work.base_R):
        return REACH, -1
    if not limits_kept(problem.limits, work.q):
        return LIMITS, -1
    work.moved[:, :] = 0.0
    _place(problem, work)
    if problem.limits.offset.shape[0] > 0:
        centre_of_mass(problem.tree, work.R, work.p, work.com)
        if com_room(problem.limits, work.com) < 0.0:
            return BALANCE, -1
    pair = _scan(problem, work, work.open_pairs[0])[0]
    return (CONTACT, pair) if pair >= 0 else (FREE, -1)


@compiled
def judge_points(problem: Problem, work: Work, x: Array) -> tuple[int, int, int]:
    """Verdict on points, shape (n, size): ends first, then the middles of ever smaller gaps.

    Returns:
        FREE or the first refusal, the row it was found at or -1, and the pair of a contact or -1.
    """
    n = x.shape[0]
    for row in (0, n - 1):
        verdict, pair = judge_point(problem, work, x[row])
        if verdict != FREE:
            return verdict, row, pair
    stride = 1
    while stride < n:
        stride *= 2
    while stride > 1:
        half = stride // 2
        for row in range(half, n - 1, stride):
            verdict, pair = judge_point(problem, work, x[row])
            if verdict != FREE:
                return verdict, row, pair
        stride = half
    return FREE, -1, -1


@compiled
def _posture(problem: Problem, work: Work, bounded: bool) -> tuple[int, bool, float]:
    """Limits and balance in the middle of an interval.

    Returns:
        A refusal or FREE; whether the whole interval is proven; how much can move, m or rad.
    """
    limits, tree, space = problem.limits, problem.tree, problem.space
    if not limits_kept(limits, work.q):
        return LIMITS, False, 0.0
    proven = bounded
    largest = 0.0 if bounded else math.inf
    if bounded:
        for leg in range(space.leg_bodies.shape[0]):
            for k in range(6):
                body = space.leg_bodies[leg, k]
                column = tree.column[body]
                reach = work.reach[body]
                largest = max(largest, reach)
                if _outside(limits, work.q[column], column, reach):
                    proven = False
    if limits.offset.shape[0] > 0:
        centre_of_mass(tree, work.R, work.p, work.com)
        room = com_room(limits, work.com)
        if room < 0.0:
            return BALANCE, False, 0.0
        mass = 0.0
        drift = 0.0
        for body in range(1, tree.mass.shape[0]):
            mass += tree.mass[body]
            drift += tree.mass[body] * work.moved[body, problem.chains.length[body]]
        drift /= mass
        largest = max(largest, drift)
        if room <= drift:
            proven = False
    return FREE, proven, largest


@compiled
def _outside(limits: Limits, value: float, column: int, reach: float) -> bool:
    """Whether a joint can leave its limits by moving so far."""
    return value - reach < limits.lower[column] or value + reach > limits.upper[column]


@compiled
def judge_edge(problem: Problem, work: Work, a: Array, b: Array, effort: int) -> tuple[int, float, int]:
    """Verdict on the whole straight line between two points of the free coordinates.

    Args:
        problem: Robot and scene.
        work: Memory.
        a, b: Ends, shape (size,); both are judged too.
        effort: Most intervals to look at.

    Returns:
        FREE when every point of the line is proven to be free, else a refusal, the parameter in [0, 1]
        where it arose or -1, and the pair or -1. CONTACT, LIMITS, BALANCE and REACH were seen there;
        UNPROVEN means that something comes so near to its bound that it could not be proven.
    """
    space, tree, limits = problem.space, problem.tree, problem.limits
    first = 6 * space.floating
    # joints that move linearly keep their limits when both ends do
    for k in range(space.columns.shape[0]):
        column = space.columns[k]
        low, high = min(a[first + k], b[first + k]), max(a[first + k], b[first + k])
        if low < limits.lower[column] or high > limits.upper[column]:
            return LIMITS, 0.0 if _outside(limits, a[first + k], column, 0.0) else 1.0, -1
    step = 0.0
    turn = 0.0
    if space.floating == 1:
        step = math.sqrt((b[0] - a[0]) ** 2 + (b[1] - a[1]) ** 2 + (b[2] - a[2]) ** 2)
        turn = math.sqrt((b[3] - a[3]) ** 2 + (b[4] - a[4]) ** 2 + (b[5] - a[5]) ** 2)
    old = 0
    work.spans[0, 0, 0] = 0
    work.spans[0, 0, 3] = 1
    spans = 1
    half = 0.5
    looked = 0
    whole = True
    while spans > 0:
        new = 1 - old
        kept = 0
        listed = 0
        found = work.open_pairs[new]
        for span in range(spans):
            looked += 1
            index = work.spans[old, span, 0]
            t = (2 * index + 1) * half
            if looked > effort:
                return UNPROVEN, t, -1
            for k in range(a.shape[0]):
                work.x[k] = a[k] + (b[k] - a[k]) * t
            if not configuration(space, tree, work.x, work.q, work.base_R):
                return REACH, t, -1
            for k in range(space.columns.shape[0]):
                work.reach[space.bodies[k]] = abs(b[first + k] - a[first + k]) * half
            bounded = leg_ranges(
                space, tree, work.q, work.base_R, step * half, turn * half, work.reach
            )
            _place(problem, work)
            bound_motion(
                tree, problem.chains, work.R, work.p, work.reach, step * half, turn * half, work.moved
            )
            posture_open = False
            if work.spans[old, span, 3] == 1:
                verdict, proven, largest = _posture(problem, work, bounded)
                if verdict != FREE:
                    return verdict, t, -1
                if not proven:
                    if largest < RESOLUTION_M or half < 1e-6:
                        return UNPROVEN, t, -1
                    posture_open = True
            begin = listed
            if whole:
                touching, listed = _scan(problem, work, found)
                if touching >= 0:
                    return CONTACT, t, touching
                if listed < 0:
                    return UNPROVEN, t, -1
            else:
                for at in range(work.spans[old, span, 1], work.spans[old, span, 2]):
                    pair = work.open_pairs[old, at]
                    status = _judge_pair(problem, work, pair)
                    if status == _TOUCHING:
                        return CONTACT, t, pair
                    if status == _OPEN:
                        if listed >= found.shape[0]:
                            return UNPROVEN, t, pair
                        found[listed] = pair
                        listed += 1
            for at in range(begin, listed):
                if _slack(problem, work, found[at]) < RESOLUTION_M:
                    return UNPROVEN, t, found[at]
            if listed > begin or posture_open:
                if kept + 2 > work.spans.shape[1]:
                    return UNPROVEN, t, -1
                for side in range(2):
                    work.spans[new, kept, 0] = 2 * index + side
                    work.spans[new, kept, 1] = begin
                    work.spans[new, kept, 2] = listed
                    work.spans[new, kept, 3] = 1 if posture_open else 0
                    kept += 1
        spans = kept
        old = new
        half *= 0.5
        whole = False
    return FREE, -1.0, -1


@compiled
def distances_at(problem: Problem, work: Work, q: Array, cap: float, found: Array) -> None:
    """Lower bounds of the distances of all pairs at a configuration.

    Bounds are exact within a micrometre where they are below ``cap``, and 0 or less where the pair
    touches or overlaps. A pair that is not judged gets infinity.

    Args:
        problem: Robot and scene.
        work: Memory.
        q: Shape (nq,).
        cap: Larger distances need not be known, m.
        found: Result, by pair, m.
    """
    work.q[:] = q
    _place(problem, work)
    solids, pairs = problem.solids, problem.pairs
    count = pairs.first.shape[0]
    for pair in range(found.shape[0]):
        if pair < count:
            i = pairs.first[pair]
            j = pairs.second[pair]
            square = 0.0
            for r in range(3):
                square += (work.centre[i, r] - work.centre[j, r]) ** 2
            gap = math.sqrt(square) - solids.radius[i] - solids.radius[j]
        else:
            thing = (pair - count) // pairs.moving
            i = (pair - count) - thing * pairs.moving
            j = pairs.moving + thing
            if pairs.judged[thing, i] == 0:
                found[pair] = math.inf
                continue
            c = work.centre[i]
            gap = point_distance(solids, j, c[0], c[1], c[2]) - solids.radius[i]
        if gap > cap:
            found[pair] = gap
        else:
            distance = _distance(solids, work, i, j, work.axis[pair], cap, -math.inf)
            found[pair] = max(gap, distance)


def work_for(problem: Problem, open_pairs: int = 32768, spans: int = 4096) -> Work:
    """Memory for a problem."""
    tree, pairs = problem.tree, problem.pairs
    n = len(tree.parent)
    size = 6 * problem.space.floating + len(problem.space.columns)
    count = len(pairs.first) + len(pairs.object_margin) * pairs.moving
    return Work(
        x=np.zeros(size),
        q=np.zeros(len(problem.limits.lower)),
        base_R=np.eye(3),
        R=np.zeros((n, 3, 3)),
        p=np.zeros((n, 3)),
        com=np.zeros(3),
        centre=np.zeros((pairs.moving, 3)),
        reach=np.zeros(n),
        moved=np.zeros((n, problem.chains.joint.shape[1] + 1)),
        axis=np.zeros((count, 3)),
        S=np.zeros((4, 3)),
        v=np.zeros(3),
        first_R=np.zeros((3, 3)),
        first_p=np.zeros(3),
        second_R=np.zeros((3, 3)),
        second_p=np.zeros(3),
        R_between=np.zeros((3, 3)),
        p_between=np.zeros(3),
        open_pairs=np.zeros((2, max(open_pairs, count)), np.int64),
        spans=np.zeros((2, spans, 4), np.int64),
    )
