"""Compiled: judge one pair of solids.

It is proven apart, cheapest first, by bounding balls, by the direction that separated it last, and by
GJK.
"""

from __future__ import annotations

import math

from kinematics.kernel.compiler import compiled, inlined
from kinematics.kernel.memory import Memory, Problem, Work, problem_at, work_at
from kinematics.kernel.motion_bound import STILL, nearing, swept
from kinematics.kernel.placing import pose_of
from kinematics.kernel.separation import OVERLAP, core_gap, point_distance

APART, OPEN, TOUCHING = 0, 1, 2
"""Status of a pair."""
# A closer look is not worth while when less than this part of the motion bound uses up the distance.
_HOPELESS = 0.5


@compiled
def pair_distance(memory: Memory, first: int, second: int, pair: int, enough: float, little: float) -> float:
    """Lower bound of the distance of two placed solids; see ``core_distance``."""
    solids, work = problem_at(memory).solids, work_at(memory)
    axis = work.axis[pair]
    A, a, B, b = work.first_R, work.first_p, work.second_R, work.second_p
    R, p = work.R_between, work.p_between
    pose_of(solids, first, work, A, a)
    pose_of(solids, second, work, B, b)
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
def judge_own(memory: Memory, problem: Problem, work: Work, pair: int, slack: float) -> int:
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
        return APART
    between = math.sqrt(square)
    if between > margin + solids.radius[i] + solids.radius[j] and margin + _HOPELESS * slack >= between:
        # apart now, and not by so much: no closer look can prove it
        return OPEN
    distance = pair_distance(memory, i, j, pair, need, margin)
    if distance > need:
        return APART
    if distance <= margin:
        return TOUCHING
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
    return APART if distance > margin + nears else OPEN


@inlined
def judge_with(memory: Memory, problem: Problem, work: Work, i: int, thing: int, slack: float) -> int:
    """Whether a moving solid is apart from an object by its margin and by what it can move."""
    solids, pairs = problem.solids, problem.pairs
    j = pairs.moving + thing
    margin = pairs.object_margin[thing]
    between = point_distance(solids, j, work.centre[i, 0], work.centre[i, 1], work.centre[i, 2])
    gap = between - solids.radius[i]
    need = margin + slack
    if gap > need:
        return APART
    if gap > margin and margin + _HOPELESS * slack >= between:
        return OPEN
    pair = pairs.first.shape[0] + thing * pairs.moving + i
    distance = pair_distance(memory, i, j, pair, need, margin)
    if distance > need:
        return APART
    if distance <= margin:
        return TOUCHING
    body = solids.body[i]
    c = work.centre[i]
    first = swept(memory, body, problem.chains.length[body], c[0], c[1], c[2], solids.radius[i])
    nears = nearing(work.first_R, work.axis[pair], first, solids.radius[i], STILL, 0.0)
    return APART if distance > margin + nears else OPEN


@inlined
def own_slack(problem: Problem, work: Work, group: int) -> float:
    """How far two bodies can move against each other, m."""
    pairs = problem.pairs
    first: float = work.moved[pairs.group_first[group], pairs.first_level[group]]
    second: float = work.moved[pairs.group_second[group], pairs.second_level[group]]
    return first + second


@inlined
def pair_slack(problem: Problem, work: Work, pair: int) -> float:
    """How far the two solids of a pair can move against each other, m."""
    pairs = problem.pairs
    count = pairs.first.shape[0]
    if pair < count:
        return own_slack(problem, work, pairs.group[pair])
    body = problem.solids.body[(pair - count) % pairs.moving]
    moved: float = work.moved[body, problem.chains.length[body]]
    return moved


@inlined
def judge_pair(memory: Memory, problem: Problem, work: Work, pair: int) -> int:
    """Status of a pair by its number."""
    slack = pair_slack(problem, work, pair)
    count = problem.pairs.first.shape[0]
    if pair < count:
        return judge_own(memory, problem, work, pair, slack)
    thing = (pair - count) // problem.pairs.moving
    return judge_with(memory, problem, work, pair - count - thing * problem.pairs.moving, thing, slack)
