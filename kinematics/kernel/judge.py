"""Compiled: judge a configuration, points or a whole edge, each in one call that allocates nothing.

A pair is proven apart, cheapest first, by bounding balls, by the direction that separated it last,
and by GJK. On an edge every pair has to be farther apart in the middle of an interval than it can
move in half of it; pairs that are not are looked at again in both halves, and only they. So a free
edge is proven free everywhere, not at samples, and an edge that is not free is refused.
"""

from __future__ import annotations

import math

from kinematics.kernel.compiler import compiled, inlined
from kinematics.kernel.coordinates import Limits
from kinematics.kernel.forward_kinematics import centre_of_mass, place_bodies
from kinematics.kernel.memory import Memory, Problem, Work, problem_at, work_at
from kinematics.kernel.motion_bound import STILL, bound_motion, nearing, swept
from kinematics.kernel.posture import com_room, configuration, leg_ranges, limits_kept
from kinematics.kernel.separation import OVERLAP, core_gap, point_distance
from kinematics.kernel.solids import HULL, Array, Indices, Solids

FREE, REACH, LIMITS, BALANCE, CONTACT, UNPROVEN = 0, 1, 2, 3, 4, 5
# Nothing was seen where it was looked, and not everything is proven.
PRESUMED = 6

# Status of a pair.
_APART, _OPEN, _TOUCHING = 0, 1, 2
# A closer look is not worth while when less than this part of the motion bound uses up the distance.
_HOPELESS = 0.5
# What is still open when nothing moves any more by this much stays unproven, m (and rad for limits).
RESOLUTION_M = 1e-4
# An edge is cut into intervals in which no joint moves farther than this, before any pair is looked at.
_FIRST_REACH_RAD = 0.2
_FIRST_SPANS = 16


@inlined
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
def _distance(memory: Memory, first: int, second: int, pair: int, enough: float, little: float) -> float:
    """Lower bound of the distance of two placed solids; see ``core_distance``."""
    solids, work = problem_at(memory).solids, work_at(memory)
    axis = work.axis[pair]
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
    distance = -math.inf
    # chosen vertices, padded; when those are too near, all vertices
    for exact in range(0 if little > OVERLAP else 1, 2):
        off = rounds if exact == 1 else rounds + pads
        found = core_gap(solids, first, second, exact, R, p, enough + off, little + off, axis, work.S, work.v)
        distance = found - off
        if distance > little or pads == 0.0:
            break
    return distance


@inlined
def _place(problem: Problem, work: Work) -> None:
    """Place the needed bodies, their balls and those of their solids at ``work.q``."""
    place_bodies(problem.tree, work.q, work.needed, work.R, work.p)
    solids, pairs, chains = problem.solids, problem.pairs, problem.chains
    for at in range(pairs.limb_bodies.shape[0]):
        body = pairs.limb_bodies[at]
        if work.needed[body] == 0:
            continue
        _carry(work, body, chains.centre, body, work.ball)
        for k in range(pairs.body_start[at], pairs.body_start[at + 1]):
            _carry(work, body, solids.centre, pairs.body_solids[k], work.centre)


@inlined
def _carry(work: Work, body: int, local: Array, row: int, world: Array) -> None:
    R, p = work.R, work.p
    a, b, c = local[row, 0], local[row, 1], local[row, 2]
    for r in range(3):
        world[row, r] = p[body, r] + R[body, r, 0] * a + R[body, r, 1] * b + R[body, r, 2] * c


@inlined
def _all_needed(work: Work) -> None:
    for body in range(work.needed.shape[0]):
        work.needed[body] = 1


@inlined
def _need_body(problem: Problem, work: Work, body: int) -> None:
    """Mark a body, all that it hangs from, and all that it stands on."""
    parent, chains = problem.tree.parent, problem.chains
    if chains.length[body] > 0:
        # a planted leg's bodies stand on the ankle, whose joints are farther from the base
        at = max(body, chains.joint[body, chains.length[body] - 1])
        while at > 0 and work.needed[at] == 0:
            work.needed[at] = 1
            at = parent[at]
    at = body
    while at > 0 and work.needed[at] == 0:
        work.needed[at] = 1
        at = parent[at]


@inlined
def _need_pair(problem: Problem, work: Work, pair: int) -> None:
    """Mark what a pair's judgement needs; a planted leg is needed as a whole."""
    solids, pairs = problem.solids, problem.pairs
    count = pairs.first.shape[0]
    if pair < count:
        _need_body(problem, work, solids.body[pairs.first[pair]])
        _need_body(problem, work, solids.body[pairs.second[pair]])
    else:
        _need_body(problem, work, solids.body[(pair - count) % pairs.moving])


@inlined
def _judge_own(memory: Memory, problem: Problem, work: Work, pair: int, slack: float) -> int:
    """Whether two moving solids are apart by their margin and by what both can move."""
    solids, pairs = problem.solids, problem.pairs
    i = pairs.first[pair]
    j = pairs.second[pair]
    margin = pairs.margin[pair]
    centre = work.centre
    d0 = centre[i, 0] - centre[j, 0]
    d1 = centre[i, 1] - centre[j, 1]
    d2 = centre[i, 2] - centre[j, 2]
    square = d0 * d0 + d1 * d1 + d2 * d2
    need = margin + slack
    far = need + solids.radius[i] + solids.radius[j]
    if square > far * far:
        return _APART
    between = math.sqrt(square)
    if between > margin + solids.radius[i] + solids.radius[j] and margin + _HOPELESS * slack >= between:
        # apart now, and not by so much: no closer look can prove it
        return _OPEN
    distance = _distance(memory, i, j, pair, need, margin)
    if distance > need:
        return _APART
    if distance <= margin:
        return _TOUCHING
    group = pairs.group[pair]
    first = swept(
        memory,
        solids.body[i],
        pairs.first_level[group],
        centre[i, 0],
        centre[i, 1],
        centre[i, 2],
        solids.radius[i],
    )
    second = swept(
        memory,
        solids.body[j],
        pairs.second_level[group],
        centre[j, 0],
        centre[j, 1],
        centre[j, 2],
        solids.radius[j],
    )
    nears = nearing(work.first_R, work.axis[pair], first, solids.radius[i], second, solids.radius[j])
    return _APART if distance > margin + nears else _OPEN


@inlined
def _judge_with(memory: Memory, problem: Problem, work: Work, i: int, thing: int, slack: float) -> int:
    """Whether a moving solid is apart from an object by its margin and by what it can move."""
    solids, pairs = problem.solids, problem.pairs
    j = pairs.moving + thing
    margin = pairs.object_margin[thing]
    between = point_distance(solids, j, work.centre[i, 0], work.centre[i, 1], work.centre[i, 2])
    gap = between - solids.radius[i]
    need = margin + slack
    if gap > need:
        return _APART
    if gap > margin and margin + _HOPELESS * slack >= between:
        return _OPEN
    pair = pairs.first.shape[0] + thing * pairs.moving + i
    distance = _distance(memory, i, j, pair, need, margin)
    if distance > need:
        return _APART
    if distance <= margin:
        return _TOUCHING
    body = solids.body[i]
    c = work.centre[i]
    first = swept(memory, body, problem.chains.length[body], c[0], c[1], c[2], solids.radius[i])
    nears = nearing(work.first_R, work.axis[pair], first, solids.radius[i], STILL, 0.0)
    return _APART if distance > margin + nears else _OPEN


@inlined
def _own_slack(problem: Problem, work: Work, group: int) -> float:
    """How far two bodies can move against each other, m."""
    pairs = problem.pairs
    first: float = work.moved[pairs.group_first[group], pairs.first_level[group]]
    second: float = work.moved[pairs.group_second[group], pairs.second_level[group]]
    return first + second


@inlined
def _slack(problem: Problem, work: Work, pair: int) -> float:
    """How far the two solids of a pair can move against each other, m."""
    pairs = problem.pairs
    count = pairs.first.shape[0]
    if pair < count:
        return _own_slack(problem, work, pairs.group[pair])
    body = problem.solids.body[(pair - count) % pairs.moving]
    moved: float = work.moved[body, problem.chains.length[body]]
    return moved


@inlined
def _judge_pair(memory: Memory, problem: Problem, work: Work, pair: int) -> int:
    """Status of a pair by its number."""
    slack = _slack(problem, work, pair)
    count = problem.pairs.first.shape[0]
    if pair < count:
        return _judge_own(memory, problem, work, pair, slack)
    thing = (pair - count) // problem.pairs.moving
    return _judge_with(memory, problem, work, pair - count - thing * problem.pairs.moving, thing, slack)


@compiled
def _scan(memory: Memory, found: Indices) -> tuple[int, int]:
    """Judge all pairs; list those that are open.

    Args:
        memory: Bodies and motion bounds in place.
        found: Result: open pairs.

    Returns:
        A pair that touches, or -1; and how many were listed, or -1 when the list is full.
    """
    problem, work = problem_at(memory), work_at(memory)
    pairs, chains, ball = problem.pairs, problem.chains, work.ball
    listed = 0
    for group in range(pairs.group_first.shape[0]):
        first = pairs.group_start[group]
        last = pairs.group_start[group + 1]
        a = pairs.group_first[group]
        b = pairs.group_second[group]
        d0 = ball[a, 0] - ball[b, 0]
        d1 = ball[a, 1] - ball[b, 1]
        d2 = ball[a, 2] - ball[b, 2]
        slack = _own_slack(problem, work, group)
        far = chains.radius[a] + chains.radius[b] + pairs.group_margin[group] + slack
        if d0 * d0 + d1 * d1 + d2 * d2 > far * far:
            continue
        for pair in range(first, last):
            status = _judge_own(memory, problem, work, pair, slack)
            if status == _TOUCHING:
                return pair, listed
            if status == _OPEN:
                if listed >= found.shape[0]:
                    return -1, -1
                found[listed] = pair
                listed += 1
    if pairs.object_margin.shape[0] == 0:
        return -1, listed
    for limb in range(chains.limbs):
        if pairs.limb_start[limb] < pairs.limb_start[limb + 1]:
            touching, listed = _scan_limb(memory, problem, work, limb, found, listed)
            if touching >= 0 or listed < 0:
                return touching, listed
    return -1, listed


@inlined
def _scan_limb(
    memory: Memory, problem: Problem, work: Work, limb: int, found: Indices, listed: int
) -> tuple[int, int]:
    """Judge a limb with every object: as a whole, body by body, solid by solid; see ``_scan``."""
    solids, pairs, chains, ball = problem.solids, problem.pairs, problem.chains, work.ball
    first, last = pairs.limb_start[limb], pairs.limb_start[limb + 1]
    low0 = low1 = low2 = math.inf
    high0 = high1 = high2 = -math.inf
    farthest = 0.0
    for at in range(first, last):
        body = pairs.limb_bodies[at]
        r = chains.radius[body]
        low0 = min(low0, ball[body, 0] - r)
        low1 = min(low1, ball[body, 1] - r)
        low2 = min(low2, ball[body, 2] - r)
        high0 = max(high0, ball[body, 0] + r)
        high1 = max(high1, ball[body, 1] + r)
        high2 = max(high2, ball[body, 2] + r)
        farthest = max(farthest, work.moved[body, chains.length[body]])
    c0, c1, c2 = 0.5 * (low0 + high0), 0.5 * (low1 + high1), 0.5 * (low2 + high2)
    around = math.sqrt((high0 - c0) ** 2 + (high1 - c1) ** 2 + (high2 - c2) ** 2) + farthest
    for thing in range(pairs.object_margin.shape[0]):
        solid = pairs.moving + thing
        margin = pairs.object_margin[thing]
        if point_distance(solids, solid, c0, c1, c2) > around + margin:
            continue
        for at in range(first, last):
            body = pairs.limb_bodies[at]
            slack = work.moved[body, chains.length[body]]
            away = point_distance(solids, solid, ball[body, 0], ball[body, 1], ball[body, 2])
            if away > chains.radius[body] + slack + margin:
                continue
            for k in range(pairs.body_start[at], pairs.body_start[at + 1]):
                s = pairs.body_solids[k]
                if pairs.judged[thing, s] == 0:
                    continue
                status = _judge_with(memory, problem, work, s, thing, slack)
                if status == _APART:
                    continue
                pair = pairs.first.shape[0] + thing * pairs.moving + s
                if status == _TOUCHING:
                    return pair, listed
                if listed >= found.shape[0]:
                    return -1, -1
                found[listed] = pair
                listed += 1
    return -1, listed


@inlined
def contact_at(memory: Memory, q: Array) -> int:
    """First pair that is nearer than its margin at a configuration, shape (nq,); -1 for none."""
    problem, work = problem_at(memory), work_at(memory)
    work.q[:] = q
    work.moved[:, :] = 0.0
    _all_needed(work)
    _place(problem, work)
    return _scan(memory, work.open_pairs[0])[0]


@compiled
def judge_point(memory: Memory, x: Array) -> tuple[int, int]:
    """Verdict on one point of the free coordinates, and the pair of a contact or -1."""
    problem, work = problem_at(memory), work_at(memory)
    if not configuration(problem.space, problem.tree, x, work.q, work.base_R):
        return REACH, -1
    if not limits_kept(problem.limits, work.q):
        return LIMITS, -1
    work.moved[:, :] = 0.0
    _all_needed(work)
    _place(problem, work)
    if problem.limits.offset.shape[0] > 0:
        centre_of_mass(problem.tree, work.R, work.p, work.com)
        if com_room(problem.limits, work.com) < 0.0:
            return BALANCE, -1
    pair = _scan(memory, work.open_pairs[0])[0]
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
            m. That makes the edge unproven, or, when this is negative, presumed.

    Returns:
        FREE when every point of the line is proven to be free, else a refusal, the parameter in [0, 1]
        where it arose or -1, and the pair or -1. CONTACT, LIMITS, BALANCE and REACH were seen there;
        UNPROVEN means that something comes so near to its bound that it could not be proven. PRESUMED
        that nothing was seen to be refused.
    """
    problem, work = problem_at(memory), work_at(memory)
    lazy = resolution < 0.0
    resolution = abs(resolution)
    presumed = False
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
    while spans < _FIRST_SPANS and widest * half > _FIRST_REACH_RAD:
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
    if step > 0.0 or turn > 0.0:
        # the base and planted legs do not turn about an axis at one speed
        work.rate[1] = math.nan
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
            for k in range(space.columns.shape[0]):
                work.rate[space.bodies[k]] = (b[first + k] - a[first + k]) * half
                work.reach[space.bodies[k]] = abs(work.rate[space.bodies[k]])
            bounded = leg_ranges(space, tree, work.q, work.base_R, step * half, turn * half, work.reach)
            if whole or work.spans[old, span, 3] == 1:
                _all_needed(work)
            else:
                work.needed[:] = 0
                for at in range(work.spans[old, span, 1], work.spans[old, span, 2]):
                    _need_pair(problem, work, work.open_pairs[old, at])
            _place(problem, work)
            bound_motion(
                tree,
                problem.chains,
                work.needed,
                work.R,
                work.p,
                work.reach,
                step * half,
                turn * half,
                work.moved,
            )
            posture_open = False
            if work.spans[old, span, 3] == 1:
                verdict, proven, largest = _posture(problem, work, bounded)
                if verdict != FREE:
                    return verdict, t, -1
                if not proven:
                    if largest < resolution or half < 1e-6:
                        if not lazy:
                            return UNPROVEN, t, -1
                        presumed = True
                    else:
                        posture_open = True
            begin = listed
            if whole:
                touching, more = _scan(memory, found[listed:])
                if touching >= 0:
                    return CONTACT, t, touching
                if more < 0:
                    return UNPROVEN, t, -1
                listed += more
            else:
                for at in range(work.spans[old, span, 1], work.spans[old, span, 2]):
                    pair = work.open_pairs[old, at]
                    status = _judge_pair(memory, problem, work, pair)
                    if status == _TOUCHING:
                        return CONTACT, t, pair
                    if status == _OPEN:
                        if listed >= found.shape[0]:
                            return UNPROVEN, t, pair
                        found[listed] = pair
                        listed += 1
            wide = begin
            for at in range(begin, listed):
                if _slack(problem, work, found[at]) >= resolution:
                    found[wide] = found[at]
                    wide += 1
                elif not lazy:
                    return UNPROVEN, t, found[at]
                else:
                    presumed = True
            listed = wide
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
    return (PRESUMED if presumed else FREE), -1.0, -1


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
    _all_needed(work)
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
            distance = _distance(memory, i, j, pair, cap, OVERLAP)
            found[pair] = max(gap, distance)
