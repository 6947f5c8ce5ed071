"""Compiled: the one door from outside to the judge and to the search."""

from __future__ import annotations

from kinematics.arrays import Array, Indices
from kinematics.compiled.compiler import compiled
from kinematics.kernel.judge import (
    CONTACT,
    FREE,
    REACH,
    RESOLUTION_M,
    contact_at,
    distances_at,
    judge_edge,
    judge_points,
)
from kinematics.kernel.memory import Memory, problem_at, work_at
from kinematics.kernel.search import connect
from kinematics.kernel.shortcuts import shorten
from kinematics.standing.posture import configuration

AT_CONFIGURATION, AT_POINTS, ALONG_POINTS, DISTANCES, TO_CONFIGURATION, CONNECT, SHORTEN, CONTACTS = range(8)


@compiled
def ask(
    floats: int,
    ints: int,
    table: Indices,
    question: int,
    points: Array,
    number: float,
    found: Array,
) -> tuple[int, float, int]:
    """The one door from outside: everything behind it is compiled and loaded as one piece.

    Args:
        floats, ints: Addresses of a packed problem and its memory.
        table: As in ``Packed``.
        question: One of the numbers above.
        points: One row a point; configurations for AT_CONFIGURATION, CONTACTS and DISTANCES; for CONNECT
            and SHORTEN see ``connect`` and ``shorten``.
        number: Most intervals to look at, for ALONG_POINTS; the cap in metres, for DISTANCES; iterations,
            for CONNECT and SHORTEN.
        found: Result of DISTANCES, by pair, of TO_CONFIGURATION, shape (nq,), of CONTACTS, a pair or -1 by
            row, and of CONNECT and SHORTEN.

    Returns:
        Verdict; row, or row plus parameter on the edge that begins there, or the number of rows of
        a path, or -1; pair or -1.
    """
    memory = Memory(floats, ints, table)
    if question == AT_CONFIGURATION:
        pair = contact_at(memory, points[0])
        return (CONTACT, 0.0, pair) if pair >= 0 else (FREE, -1.0, -1)
    if question == AT_POINTS:
        verdict, row, pair = judge_points(memory, points)
        return verdict, float(row), pair
    if question == ALONG_POINTS:
        for row in range(points.shape[0] - 1):
            verdict, t, pair = judge_edge(memory, points[row], points[row + 1], number, RESOLUTION_M)
            if verdict != FREE:
                return verdict, row + t, pair
        return FREE, -1.0, -1
    if question == DISTANCES:
        distances_at(memory, points[0], number, found)
        return FREE, -1.0, -1
    if question == CONTACTS:
        for row in range(points.shape[0]):
            found[row] = contact_at(memory, points[row])
        return FREE, -1.0, -1
    if question == CONNECT:
        return FREE, float(connect(memory, points, int(number), found)), -1
    if question == SHORTEN:
        return FREE, float(shorten(memory, points, int(number), found)), -1
    problem, work = problem_at(memory), work_at(memory)
    if not configuration(problem.space, problem.tree, points[0], found, work.base_R):
        return REACH, 0.0, -1
    return FREE, -1.0, -1
