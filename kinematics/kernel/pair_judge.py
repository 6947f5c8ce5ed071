"""Compiled: judge one pair of solids.

It is proven apart, cheapest first, by bounding balls, by the direction that separated it last, and by
GJK.
"""

from __future__ import annotations

import math

from kinematics.compiled.compiler import compiled, inlined
from kinematics.distance.separation import OVERLAP, core_gap, point_distance
from kinematics.distance.solids import Solids
from kinematics.kernel.extents import along, extent
from kinematics.kernel.memory import Memory, Problem, Work, problem_at, work_at
from kinematics.kernel.motion_bound import STILL, Sweep, nearing, swept
from kinematics.kernel.placing import pose_of
from kinematics.model.tree import WORLD

APART, OPEN, TOUCHING = 0, 1, 2
"""Status of a pair."""
_ROUGH, _FEW = 1, 0


@compiled
def pair_distance(memory: Memory, first: int, second: int, pair: int, enough: float, little: float) -> float:
    """Lower bound of the distance of two placed solids; see ``core_distance``.

    The direction is remembered in the frame of the second when that is an object, whose faces it is
    mostly normal to, else in that of the first.
    """
    solids, work = problem_at(memory).solids, work_at(memory)
    axis, direction = work.axis[pair], work.direction
    A, a, B, b = work.first_R, work.first_p, work.second_R, work.second_p
    R, p = work.R_between, work.p_between
    pose_of(solids, first, work, A, a)
    pose_of(solids, second, work, B, b)
    for r in range(3):
        p[r] = A[0, r] * (b[0] - a[0]) + A[1, r] * (b[1] - a[1]) + A[2, r] * (b[2] - a[2])
        for k in range(3):
            R[r, k] = A[0, r] * B[0, k] + A[1, r] * B[1, k] + A[2, r] * B[2, k]
    still = solids.body[second] == WORLD
    for r in range(3):
        direction[r] = A[0, r] * axis[0] + A[1, r] * axis[1] + A[2, r] * axis[2] if still else axis[r]
    rounds = solids.round[first] + solids.round[second]
    pads = solids.pad[first] + solids.pad[second]
    distance = -math.inf
    # chosen vertices, padded; when those are too near, all vertices
    for exact in range(0 if little > OVERLAP else 1, 2):
        off = rounds if exact == 1 else rounds + pads
        found = core_gap(
            solids, first, second, exact, R, p, enough + off, little + off, direction, work.S, work.v
        )
        distance = found - off
        if distance > little or pads == 0.0:
            break
    for r in range(3):
        turned = A[r, 0] * direction[0] + A[r, 1] * direction[1] + A[r, 2] * direction[2]
        axis[r] = turned if still else direction[r]
    return distance


@inlined
def _remembered(solids: Solids, work: Work, first: int, second: int, pair: int) -> tuple[float, float, float]:
    """The direction that separated a pair last, in the world; zero when there is none."""
    axis = work.axis[pair]
    if solids.body[second] == WORLD:
        return axis[0], axis[1], axis[2]
    return along(solids, work.R, first, axis[0], axis[1], axis[2])


@compiled
def _gap(memory: Memory, first: int, second: int, rough: int, x: float, y: float, z: float) -> float:
    """Gap of two solids along a direction of the world, m.

    By their rough or their chosen vertices, without what rounds or pads them.
    """
    solids, work = problem_at(memory).solids, work_at(memory)
    near = extent(solids, work.R, work.p, first, rough, -x, -y, -z)
    return -near - extent(solids, work.R, work.p, second, rough, x, y, z)


@inlined
def _own_nearing(
    memory: Memory, problem: Problem, work: Work, pair: int, n: tuple[float, float, float]
) -> float:
    """How much nearer two moving solids can come along a direction, m; NaN when it is not known."""
    solids, pairs = problem.solids, problem.pairs
    i, j, group = pairs.first[pair], pairs.second[pair], pairs.group[pair]
    c, d = work.centre[i], work.centre[j]
    ri, rj = solids.radius[i], solids.radius[j]
    one = swept(memory, solids.body[i], pairs.first_level[group], c[0], c[1], c[2], ri)
    other = swept(memory, solids.body[j], pairs.second_level[group], d[0], d[1], d[2], rj)
    return nearing(n, one, ri, other, rj)


@inlined
def _sweep_of(memory: Memory, problem: Problem, work: Work, i: int) -> Sweep:
    """Motion of a moving solid against the world, reckoned once in an interval."""
    s = work.sweep[i]
    if work.sweep_look[i] != work.look[0]:
        work.sweep_look[i] = work.look[0]
        body, c = problem.solids.body[i], work.centre[i]
        radius = problem.solids.radius[i]
        s[0], s[1], s[2], s[3], s[4], s[5], s[6] = swept(
            memory, body, problem.chains.length[body], c[0], c[1], c[2], radius
        )
    return s[0], s[1], s[2], s[3], s[4], s[5], s[6]


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
    if (
        between > margin + solids.radius[i] + solids.radius[j]
        and margin + problem.tuning.hopeless * slack >= between
    ):
        # apart now, and not by so much: no closer look can prove it
        return OPEN
    bound = slack
    n = _remembered(solids, work, i, j, pair)
    if n[0] != 0.0 or n[1] != 0.0 or n[2] != 0.0:
        off = solids.round[i] + solids.round[j]
        pads = solids.rough_pad[i] + solids.rough_pad[j]
        gap = _gap(memory, i, j, _ROUGH, n[0], n[1], n[2]) - off
        if gap - pads > need:
            return APART
        if slack > 0.0 and gap > margin:
            nears = _own_nearing(memory, problem, work, pair, n)
            if nears < bound:
                bound = nears
            if gap - pads > margin + bound:
                return APART
            narrow = margin + bound + off + solids.pad[i] + solids.pad[j]
            if gap > margin + bound and _gap(memory, i, j, _FEW, n[0], n[1], n[2]) > narrow:
                return APART
            bound = min(slack, problem.tuning.enough * bound)
    distance = pair_distance(memory, i, j, pair, margin + bound, margin)
    if distance > need:
        return APART
    if distance <= margin:
        return TOUCHING
    nears = _own_nearing(memory, problem, work, pair, _remembered(solids, work, i, j, pair))
    return APART if distance > margin + nears else OPEN


@inlined
def judge_with(memory: Memory, problem: Problem, work: Work, i: int, thing: int, slack: float) -> int:
    """Whether a moving solid is apart from an object by its margin and by what it can move."""
    solids, pairs = problem.solids, problem.pairs
    j = pairs.moving + thing
    margin = pairs.object_margin[thing]
    between = point_distance(solids, j, work.centre[i, 0], work.centre[i, 1], work.centre[i, 2])
    radius = solids.radius[i]
    gap = between - radius
    need = margin + slack
    if gap > need:
        return APART
    if gap > margin and margin + problem.tuning.hopeless * slack >= between:
        return OPEN
    pair = pairs.first.shape[0] + thing * pairs.moving + i
    bound = slack
    axis = work.axis[pair]
    n = axis[0], axis[1], axis[2]
    if n[0] != 0.0 or n[1] != 0.0 or n[2] != 0.0:
        off = solids.round[i] + solids.round[j]
        gap = _gap(memory, i, j, _ROUGH, n[0], n[1], n[2]) - off
        if gap - solids.rough_pad[i] > need:
            return APART
        if slack > 0.0 and gap > margin:
            nears = nearing(n, _sweep_of(memory, problem, work, i), radius, STILL, 0.0)
            if nears < bound:
                bound = nears
            if gap - solids.rough_pad[i] > margin + bound:
                return APART
            narrow = margin + bound + off + solids.pad[i]
            if gap > margin + bound and _gap(memory, i, j, _FEW, n[0], n[1], n[2]) > narrow:
                return APART
            bound = min(slack, problem.tuning.enough * bound)
    distance = pair_distance(memory, i, j, pair, margin + bound, margin)
    if distance > need:
        return APART
    if distance <= margin:
        return TOUCHING
    n = axis[0], axis[1], axis[2]
    nears = nearing(n, _sweep_of(memory, problem, work, i), radius, STILL, 0.0)
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
