"""Compiled: place what a question is about, and nothing else."""

from __future__ import annotations

from kinematics.arrays import Array
from kinematics.compiled.compiler import inlined
from kinematics.distance.solids import HULL, Solids
from kinematics.kernel.memory import Problem, Work
from kinematics.model.forward_kinematics import place_bodies


@inlined
def pose_of(solids: Solids, solid: int, work: Work, R: Array, p: Array) -> None:
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


@inlined
def place(problem: Problem, work: Work) -> None:
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
def need_all(work: Work) -> None:
    """Mark all bodies."""
    for body in range(work.needed.shape[0]):
        work.needed[body] = 1


@inlined
def need_body(problem: Problem, work: Work, body: int) -> None:
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
def need_pair(problem: Problem, work: Work, pair: int) -> None:
    """Mark what a pair's judgement needs; a planted leg is needed as a whole."""
    solids, pairs = problem.solids, problem.pairs
    count = pairs.first.shape[0]
    if pair < count:
        need_body(problem, work, solids.body[pairs.first[pair]])
        need_body(problem, work, solids.body[pairs.second[pair]])
    else:
        need_body(problem, work, solids.body[(pair - count) % pairs.moving])
