"""Compiled: judge a configuration, points or a whole edge, each in one call that allocates nothing.

On an edge every pair has to be farther apart in the middle of an interval than it can
move in half of it; pairs that are not are looked at again in both halves, and only they. So a free
edge is proven free everywhere, not at samples, and an edge that is not free is refused.
"""

from __future__ import annotations

import math

from kinematics.arrays import Array
from kinematics.compiled.compiler import compiled, inlined
from kinematics.distance.separation import OVERLAP, point_distance
from kinematics.kernel.memory import Memory, Problem, Work, problem_at, work_at
from kinematics.kernel.motion_bound import base_drift, bound_motion
from kinematics.kernel.pair_judge import OPEN, TOUCHING, judge_pair, pair_distance, pair_slack
from kinematics.kernel.placing import need_all, need_pair, place
from kinematics.kernel.scan import scan
from kinematics.model.forward_kinematics import centre_of_mass
from kinematics.standing.flat_coordinates import Limits
from kinematics.standing.posture import com_room, configuration, leg_ranges, limits_kept

FREE, REACH, LIMITS, BALANCE, CONTACT, UNPROVEN = 0, 1, 2, 3, 4, 5

# What is still open when nothing moves any more by this much stays unproven, m (and rad for limits).
RESOLUTION_M = 1e-4
# An edge is cut into no more intervals than this before any pair is looked at.
_FIRST_SPANS = 16


@inlined
def contact_at(memory: Memory, q: Array) -> int:
    """First pair that is nearer than its margin at a configuration, shape (nq,); -1 for none."""
    problem, work = problem_at(memory), work_at(memory)
    work.q[:] = q
    work.moved[:, :] = 0.0
    need_all(work)
    place(problem, work)
    return scan(memory, work.open_pairs[0])[0]


@compiled
def judge_point(memory: Memory, x: Array) -> tuple[int, int]:
    """Verdict on one point of the free coordinates, and the pair of a contact or -1."""
    problem, work = problem_at(memory), work_at(memory)
    if not configuration(problem.space, problem.tree, x, work.q, work.base_R):
        return REACH, -1
    if not limits_kept(problem.limits, work.q):
        return LIMITS, -1
    work.moved[:, :] = 0.0
    need_all(work)
    place(problem, work)
    if problem.limits.offset.shape[0] > 0:
        centre_of_mass(problem.tree, work.R, work.p, work.com)
        if com_room(problem.limits, work.com) < 0.0:
            return BALANCE, -1
    pair = scan(memory, work.open_pairs[0])[0]
    return (CONTACT, pair) if pair >= 0 else (FREE, -1)


@inlined
def judge_points(memory: Memory, x: Array) -> tuple[int, int, int]:
    """Verdict on points, shape (n, size): ends first, then the middles of ever smaller gaps.

    Returns:
        FREE or the first refusal, the row it was found at or -1, and the pair of a contact or -1.
    """
    n = x.shape[0]
    for row in range(0, n, max(1, n - 1)):
        verdict, pair = judge_point(memory, x[row])
        if verdict != FREE:
            return verdict, row, pair
    stride = 1
    while stride < n:
        stride *= 2
    while stride > 1:
        half = stride // 2
        for row in range(half, n - 1, stride):
            verdict, pair = judge_point(memory, x[row])
            if verdict != FREE:
                return verdict, row, pair
        stride = half
    return FREE, -1, -1


@inlined
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


@inlined
def _outside(limits: Limits, value: float, column: int, reach: float) -> bool:
    """Whether a joint can leave its limits by moving so far."""
    low: float = limits.lower[column]
    high: float = limits.upper[column]
    return value - reach < low or value + reach > high


@compiled
def judge_edge(
    memory: Memory, a: Array, b: Array, effort: float, resolution: float
) -> tuple[int, float, int]:
    """Verdict on the whole straight line between two points of the free coordinates.

    Args:
        memory: Robot and scene.
        a, b: Ends, shape (size,); both are judged too.
        effort: Most intervals to look at; no integer, as the compiler makes a version for each constant.
        resolution: What is open when nothing moves any more by this much is not looked at more closely,
            m. That makes the edge unproven.

    Returns:
        FREE when every point of the line is proven to be free, else a refusal, the parameter in [0, 1]
        where it arose or -1, and the pair or -1. CONTACT, LIMITS, BALANCE and REACH were seen there;
        UNPROVEN means that something comes so near to its bound that it could not be proven.
    """
    problem, work = problem_at(memory), work_at(memory)
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
    spans = 1
    half = 0.5
    widest = max(step, turn)
    for k in range(space.columns.shape[0]):
        widest = max(widest, abs(b[first + k] - a[first + k]))
    while spans < _FIRST_SPANS and widest * half > problem.tuning.first_reach_rad:
        spans *= 2
        half *= 0.5
    for span in range(spans):
        # numbers with their bits in reverse: what collides is found early
        index = 0
        bit = 1
        while bit < spans:
            index = 2 * index + (1 if span & bit else 0)
            bit *= 2
        work.spans[0, span, 0] = index
        work.spans[0, span, 3] = 1
    work.rate[:] = 0.0
    moving_base = step > 0.0 or turn > 0.0
    if moving_base:
        work.rate[1] = 1.0
        # planted legs do not turn at one speed
        for leg in range(space.leg_bodies.shape[0]):
            for k in range(6):
                work.rate[space.leg_bodies[leg, k]] = math.nan
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
            if moving_base:
                base_drift(work.x, a, b, half, work.drift)
            for k in range(space.columns.shape[0]):
                work.rate[space.bodies[k]] = (b[first + k] - a[first + k]) * half
                work.reach[space.bodies[k]] = abs(work.rate[space.bodies[k]])
            bounded = leg_ranges(space, tree, work.q, work.base_R, step * half, turn * half, work.reach)
            if whole or work.spans[old, span, 3] == 1:
                need_all(work)
            else:
                work.needed[:] = 0
                for at in range(work.spans[old, span, 1], work.spans[old, span, 2]):
                    need_pair(problem, work, work.open_pairs[old, at])
            place(problem, work)
            bound_motion(
                tree,
                problem.chains,
                work.needed,
                work.R,
                work.p,
                work.reach,
                step * half,
                turn * half,
                work.spin,
                work.moved,
            )
            work.look[0] += 1
            posture_open = False
            if work.spans[old, span, 3] == 1:
                verdict, proven, largest = _posture(problem, work, bounded)
                if verdict != FREE:
                    return verdict, t, -1
                if not proven:
                    if largest < resolution or half < 1e-6:
                        return UNPROVEN, t, -1
                    posture_open = True
            begin = listed
            if whole:
                touching, more = scan(memory, found[listed:])
                if touching >= 0:
                    return CONTACT, t, touching
                if more < 0:
                    return UNPROVEN, t, -1
                listed += more
            else:
                for at in range(work.spans[old, span, 1], work.spans[old, span, 2]):
                    pair = work.open_pairs[old, at]
                    status = judge_pair(memory, problem, work, pair)
                    if status == TOUCHING:
                        return CONTACT, t, pair
                    if status == OPEN:
                        if listed >= found.shape[0]:
                            return UNPROVEN, t, pair
                        found[listed] = pair
                        listed += 1
            for at in range(begin, listed):
                if pair_slack(problem, work, found[at]) < resolution:
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


@inlined
def distances_at(memory: Memory, q: Array, cap: float, found: Array) -> None:
    """Lower bounds of the distances of all pairs at a configuration.

    Bounds are exact within a micrometre where they are below ``cap``, and 0 or less where the pair
    touches or overlaps. A pair that is not judged gets infinity.

    Args:
        memory: Robot and scene.
        q: Shape (nq,).
        cap: Larger distances need not be known, m.
        found: Result, by pair, m.
    """
    problem, work = problem_at(memory), work_at(memory)
    work.q[:] = q
    need_all(work)
    place(problem, work)
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
            distance = pair_distance(memory, i, j, pair, cap, OVERLAP)
            found[pair] = max(gap, distance)
