"""Compiled: judge all pairs of solids where the bodies are, the many that are far apart in bulk."""

from __future__ import annotations

import math

from kinematics.arrays import Indices
from kinematics.compiled.compiler import compiled, inlined
from kinematics.kernel.memory import Memory, Problem, Work, problem_at, work_at
from kinematics.kernel.pair_judge import APART, OPEN, TOUCHING, judge_own, judge_with, own_slack


@compiled
def scan(memory: Memory, found: Indices) -> tuple[int, int]:
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
        slack = own_slack(problem, work, group)
        far = chains.radius[a] + chains.radius[b] + pairs.group_margin[group] + slack
        if d0 * d0 + d1 * d1 + d2 * d2 > far * far:
            continue
        for pair in range(first, last):
            status = judge_own(memory, problem, work, pair, slack)
            if status == TOUCHING:
                return pair, listed
            if status == OPEN:
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
def _near_limb(problem: Problem, work: Work, limb: int) -> int:
    """List the objects whose boxes come near a limb as a whole; tell how many."""
    pairs, chains, ball = problem.pairs, problem.chains, work.ball
    low0 = low1 = low2 = math.inf
    high0 = high1 = high2 = -math.inf
    farthest = 0.0
    for at in range(pairs.limb_start[limb], pairs.limb_start[limb + 1]):
        body = pairs.limb_bodies[at]
        r = chains.radius[body]
        low0 = min(low0, ball[body, 0] - r)
        low1 = min(low1, ball[body, 1] - r)
        low2 = min(low2, ball[body, 2] - r)
        high0 = max(high0, ball[body, 0] + r)
        high1 = max(high1, ball[body, 1] + r)
        high2 = max(high2, ball[body, 2] + r)
        farthest = max(farthest, work.moved[body, chains.length[body]])
    low, high, away, margin = pairs.object_low, pairs.object_high, work.away, pairs.object_margin
    things = margin.shape[0]
    # box against box; without branches, so that several are done at once
    for thing in range(things):
        d0 = max(low[0, thing] - high0, low0 - high[0, thing])
        d1 = max(low[1, thing] - high1, low1 - high[1, thing])
        d2 = max(low[2, thing] - high2, low2 - high[2, thing])
        away[thing] = max(d0, max(d1, d2)) - margin[thing]
    count = 0
    for thing in range(things):
        if away[thing] <= farthest:
            work.near[count] = thing
            count += 1
    return count


@inlined
def _scan_limb(
    memory: Memory, problem: Problem, work: Work, limb: int, found: Indices, listed: int
) -> tuple[int, int]:
    """Judge a limb with every object: as a whole, body by body, solid by solid; see ``scan``."""
    pairs, chains, ball = problem.pairs, problem.chains, work.ball
    first, last = pairs.limb_start[limb], pairs.limb_start[limb + 1]
    for row in range(_near_limb(problem, work, limb)):
        thing = work.near[row]
        low0, low1, low2 = pairs.object_low[0, thing], pairs.object_low[1, thing], pairs.object_low[2, thing]
        high0, high1 = pairs.object_high[0, thing], pairs.object_high[1, thing]
        high2 = pairs.object_high[2, thing]
        margin = pairs.object_margin[thing]
        for at in range(first, last):
            body = pairs.limb_bodies[at]
            slack = work.moved[body, chains.length[body]]
            far = chains.radius[body] + slack + margin
            c0, c1, c2 = ball[body, 0], ball[body, 1], ball[body, 2]
            d0 = max(max(low0 - c0, c0 - high0), 0.0)
            d1 = max(max(low1 - c1, c1 - high1), 0.0)
            d2 = max(max(low2 - c2, c2 - high2), 0.0)
            if d0 * d0 + d1 * d1 + d2 * d2 > far * far:
                continue
            for k in range(pairs.body_start[at], pairs.body_start[at + 1]):
                s = pairs.body_solids[k]
                if pairs.judged[thing, s] == 0:
                    continue
                status = judge_with(memory, problem, work, s, thing, slack)
                if status == APART:
                    continue
                pair = pairs.first.shape[0] + thing * pairs.moving + s
                if status == TOUCHING:
                    return pair, listed
                if listed >= found.shape[0]:
                    return -1, -1
                found[listed] = pair
                listed += 1
    return -1, listed
