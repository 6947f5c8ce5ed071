"""Compiled: how far placed solids extend along directions of the world.

The gap of two solids' extents along any one direction is a lower bound of their distance: the
cheapest proof that they are apart.
"""

from __future__ import annotations

import math

from kinematics.arrays import Array
from kinematics.compiled.compiler import inlined
from kinematics.distance.solids import BOX, CYLINDER, HULL, SEGMENT, Solids

# Added to every extent: rounding in coordinates of some metres.
_ROUNDING_M = 1e-9


@inlined
def along(solids: Solids, R: Array, solid: int, x: float, y: float, z: float) -> tuple[float, float, float]:
    """A direction of a solid's own frame, in the world; ``R`` holds the bodies' rotations."""
    if solids.kind[solid] != HULL:
        P = solids.R[solid]
        x, y, z = (
            P[0, 0] * x + P[0, 1] * y + P[0, 2] * z,
            P[1, 0] * x + P[1, 1] * y + P[1, 2] * z,
            P[2, 0] * x + P[2, 1] * y + P[2, 2] * z,
        )
    B = R[solids.body[solid]]
    return (
        B[0, 0] * x + B[0, 1] * y + B[0, 2] * z,
        B[1, 0] * x + B[1, 1] * y + B[1, 2] * z,
        B[2, 0] * x + B[2, 1] * y + B[2, 2] * z,
    )


@inlined
def extent(solids: Solids, R: Array, p: Array, solid: int, rough: int, x: float, y: float, z: float) -> float:
    """The largest coordinate of a solid's core along a direction, m.

    Args:
        solids: All solids.
        R, p: Poses of the bodies, shapes (n, 3, 3) and (n, 3), m.
        solid: Which one.
        rough: 1 for a hull's rough vertices, 0 for the chosen ones; without their pads, which hold the
            rest.
        x, y, z: The direction, of length 1, in the world.
    """
    body = solids.body[solid]
    B = R[body]
    a = B[0, 0] * x + B[1, 0] * y + B[2, 0] * z
    b = B[0, 1] * x + B[1, 1] * y + B[2, 1] * z
    c = B[0, 2] * x + B[1, 2] * y + B[2, 2] * z
    start: float = p[body, 0] * x + p[body, 1] * y + p[body, 2] * z + _ROUNDING_M
    kind = solids.kind[solid]
    if kind == HULL:
        points = solids.points
        row = solids.few[solid, 0]
        last = solids.rough[solid] if rough == 1 else solids.few[solid, 1]
        one = points[row, 0] * a + points[row, 1] * b + points[row, 2] * c
        # two chains of comparisons: neither waits for the other
        other = one
        row += 1
        while row + 1 < last:
            one = max(one, points[row, 0] * a + points[row, 1] * b + points[row, 2] * c)
            other = max(other, points[row + 1, 0] * a + points[row + 1, 1] * b + points[row + 1, 2] * c)
            row += 2
        if row < last:
            one = max(one, points[row, 0] * a + points[row, 1] * b + points[row, 2] * c)
        most: float = start + max(one, other)
        return most
    P, offset, size = solids.R[solid], solids.p[solid], solids.size[solid]
    start += offset[0] * a + offset[1] * b + offset[2] * c
    e = P[0, 0] * a + P[1, 0] * b + P[2, 0] * c
    f = P[0, 1] * a + P[1, 1] * b + P[2, 1] * c
    g = P[0, 2] * a + P[1, 2] * b + P[2, 2] * c
    if kind == BOX:
        start += abs(e) * size[0] + abs(f) * size[1] + abs(g) * size[2]
    elif kind == CYLINDER:
        start += math.sqrt(e * e + f * f) * size[0] + abs(g) * size[1]
    elif kind == SEGMENT:
        start += abs(g) * size[1]
    return start
