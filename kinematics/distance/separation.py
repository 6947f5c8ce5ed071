"""Compiled: lower bounds of the distance of two convex solids, by GJK with a remembered direction.

Gilbert, Johnson, Keerthi (1988); the search for the nearest point of a simplex looks at all its
faces. What is claimed rests on support functions alone: along any direction, the gap between the two
solids' extents is a lower bound of their distance. A slip of the search can therefore cost a proof,
never make a false one.
"""

from __future__ import annotations

import math

import numpy as np

from kinematics.arrays import Array, Indices
from kinematics.compiled.compiler import compiled, inlined
from kinematics.distance.solids import BOX, CYLINDER, HULL, POINT, SEGMENT, Solids

OVERLAP = -math.inf
"""Lower bound when the cores overlap."""
_ITERATIONS = 60
# Bounds from above and below that are so near are one number.
_CONVERGED_M = 1e-7
_CONVERGED_PART = 1e-6
# Taken off every bound: rounding in coordinates of some metres.
_ROUNDING_M = 1e-9


@inlined
def _farthest(points: Array, first: int, last: int, x: float, y: float, z: float) -> int:
    """Row of the point that lies farthest along a direction."""
    best = first
    most = points[first, 0] * x + points[first, 1] * y + points[first, 2] * z
    for i in range(first + 1, last):
        along = points[i, 0] * x + points[i, 1] * y + points[i, 2] * z
        if along > most:
            most = along
            best = i
    return best


@inlined
def _support(
    solids: Solids, solid: int, exact: int, x: float, y: float, z: float
) -> tuple[float, float, float]:
    """Point of a solid's core that lies farthest along a direction, both in the solid's frame."""
    kind = solids.kind[solid]
    if kind == HULL:
        rows = solids.all[solid] if exact == 1 else solids.few[solid]
        i = _farthest(solids.points, rows[0], rows[1], x, y, z)
        return solids.points[i, 0], solids.points[i, 1], solids.points[i, 2]
    size = solids.size[solid]
    if kind == BOX:
        return (
            size[0] if x > 0.0 else -size[0],
            size[1] if y > 0.0 else -size[1],
            size[2] if z > 0.0 else -size[2],
        )
    if kind == CYLINDER:
        across = math.sqrt(x * x + y * y)
        part = size[0] / across if across > 1e-12 else 0.0
        return part * x, part * y, size[1] if z > 0.0 else -size[1]
    if kind == SEGMENT:
        return 0.0, 0.0, size[1] if z > 0.0 else -size[1]
    return 0.0, 0.0, 0.0


@inlined
def _dot(S: Array, i: int, j: int) -> float:
    product: float = S[i, 0] * S[j, 0] + S[i, 1] * S[j, 1] + S[i, 2] * S[j, 2]
    return product


@inlined
def _determinant(S: Array, i: int, j: int, k: int) -> float:
    x = S[j, 1] * S[k, 2] - S[j, 2] * S[k, 1]
    y = S[j, 2] * S[k, 0] - S[j, 0] * S[k, 2]
    z = S[j, 0] * S[k, 1] - S[j, 1] * S[k, 0]
    volume: float = S[i, 0] * x + S[i, 1] * y + S[i, 2] * z
    return volume


@inlined
def _contains_origin(S: Array) -> bool:
    """Whether the tetrahedron of four rows holds the origin."""
    a = _determinant(S, 1, 2, 3)
    b = -_determinant(S, 0, 2, 3)
    c = _determinant(S, 0, 1, 3)
    d = -_determinant(S, 0, 1, 2)
    whole = a + b + c + d
    if whole < 0.0:
        a, b, c, d = -a, -b, -c, -d
    return abs(whole) > 1e-18 and a >= 0.0 and b >= 0.0 and c >= 0.0 and d >= 0.0


@inlined
def _nearest(S: Array, n: int, v: Array) -> int:
    """Point of a simplex that is nearest to the origin.

    Args:
        S: Corners, in the first ``n`` rows; on return only those of the face that holds the point.
        n: 1 to 4.
        v: Result, shape (3,).

    Returns:
        Number of corners left; 0 when the origin is inside.
    """
    if n == 4 and _contains_origin(S):
        return 0
    best = math.inf
    mask = 0
    for i in range(n):
        square = _dot(S, i, i)
        if square < best:
            best = square
            mask = 1 << i
            for r in range(3):
                v[r] = S[i, r]
    for i in range(n):
        ii = _dot(S, i, i)
        for j in range(i + 1, n):
            ij = _dot(S, i, j)
            jj = _dot(S, j, j)
            length = ii - 2.0 * ij + jj
            t = ii - ij
            if t <= 0.0 or t >= length or length < 1e-20:
                continue
            t /= length
            square = 0.0
            for r in range(3):
                c = S[i, r] + t * (S[j, r] - S[i, r])
                square += c * c
            if square < best:
                best = square
                mask = (1 << i) | (1 << j)
                for r in range(3):
                    v[r] = S[i, r] + t * (S[j, r] - S[i, r])
    for i in range(n):
        for j in range(i + 1, n):
            for k in range(j + 1, n):
                uu = 0.0
                uw = 0.0
                ww = 0.0
                au = 0.0
                aw = 0.0
                for r in range(3):
                    u = S[j, r] - S[i, r]
                    w = S[k, r] - S[i, r]
                    uu += u * u
                    uw += u * w
                    ww += w * w
                    au -= S[i, r] * u
                    aw -= S[i, r] * w
                area = uu * ww - uw * uw
                if area < 1e-12 * uu * ww or area < 1e-30:
                    continue
                s = (au * ww - aw * uw) / area
                t = (aw * uu - au * uw) / area
                if s <= 0.0 or t <= 0.0 or s + t >= 1.0:
                    continue
                square = 0.0
                for r in range(3):
                    c = S[i, r] + s * (S[j, r] - S[i, r]) + t * (S[k, r] - S[i, r])
                    square += c * c
                if square < best:
                    best = square
                    mask = (1 << i) | (1 << j) | (1 << k)
                    for r in range(3):
                        v[r] = S[i, r] + s * (S[j, r] - S[i, r]) + t * (S[k, r] - S[i, r])
    m = 0
    for i in range(n):
        if (mask >> i) & 1:
            if m != i:
                for r in range(3):
                    S[m, r] = S[i, r]
            m += 1
    return m


@inlined
def core_gap(
    solids: Solids,
    first: int,
    second: int,
    exact: int,
    R: Array,
    p: Array,
    enough: float,
    little: float,
    axis: Array,
    S: Array,
    v: Array,
) -> float:
    """As ``core_distance``, made part of whoever calls it."""
    bound: float = OVERLAP
    n = 0
    for r in range(3):
        v[r] = axis[r]
    length = math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2])
    if length < 1e-9:
        for r in range(3):
            v[r] = solids.centre[first, r] - p[r] if solids.kind[first] == HULL else -p[r]
        if solids.kind[second] == HULL:
            c = solids.centre[second]
            for r in range(3):
                v[r] -= R[r, 0] * c[0] + R[r, 1] * c[1] + R[r, 2] * c[2]
        length = math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2])
        if length < 1e-9:
            v[0] = v[1] = 0.0
            v[2] = length = 1.0
    for _ in range(_ITERATIONS):
        a0, a1, a2 = _support(solids, first, exact, -v[0], -v[1], -v[2])
        b0, b1, b2 = _support(
            solids,
            second,
            exact,
            R[0, 0] * v[0] + R[1, 0] * v[1] + R[2, 0] * v[2],
            R[0, 1] * v[0] + R[1, 1] * v[1] + R[2, 1] * v[2],
            R[0, 2] * v[0] + R[1, 2] * v[1] + R[2, 2] * v[2],
        )
        w0 = a0 - (R[0, 0] * b0 + R[0, 1] * b1 + R[0, 2] * b2 + p[0])
        w1 = a1 - (R[1, 0] * b0 + R[1, 1] * b1 + R[1, 2] * b2 + p[1])
        w2 = a2 - (R[2, 0] * b0 + R[2, 1] * b1 + R[2, 2] * b2 + p[2])
        gap = (v[0] * w0 + v[1] * w1 + v[2] * w2) / length - _ROUNDING_M
        if gap > bound:
            bound = gap
            for r in range(3):
                axis[r] = v[r] / length
            if bound > enough:
                return bound
        if n > 0:
            # now length is the distance of two points of the cores: a bound from above
            if length - bound <= _CONVERGED_M + _CONVERGED_PART * length or length <= little:
                return bound
            if little > OVERLAP and length <= enough and 2.0 * bound >= length + little and bound > little:
                return bound
        S[n, 0] = w0
        S[n, 1] = w1
        S[n, 2] = w2
        n = _nearest(S, n + 1, v)
        if n == 0:
            return OVERLAP
        length = math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2])
        if length < 1e-9:
            return OVERLAP
    return bound


@compiled
def core_distance(
    solids: Solids,
    first: int,
    second: int,
    exact: int,
    R: Array,
    p: Array,
    enough: float,
    little: float,
    axis: Array,
    S: Array,
    v: Array,
) -> float:
    """Lower bound of the distance of two cores.

    Args:
        solids: All solids.
        first, second: Which two.
        exact: 1 for all vertices of hulls, 0 for the chosen ones.
        R, p: Pose of the second's frame in the first's, shapes (3, 3) and (3,), m.
        enough: The search ends when the bound passes this, m.
        little: The search ends when the distance is known to be no more than this; or when it is
            known to be no more than ``enough`` and the bound is half-way from ``little`` to it. With
            ``OVERLAP`` here, only ``enough`` and convergence end it.
        axis: Direction to begin with, from the second to the first in the first's frame, shape
            (3,), or zero; on return the best one found.
        S, v: Scratch, shapes (4, 3) and (3,).
    """
    return core_gap(solids, first, second, exact, R, p, enough, little, axis, S, v)


@inlined
def point_distance(solids: Solids, solid: int, x: float, y: float, z: float) -> float:
    """Distance of a point to a box, cylinder, ball or capsule, both in one frame; 0 in the core.

    Of a hull, that to the box that holds it, which is a lower bound.
    """
    R, size = solids.R[solid], solids.size[solid]
    p = solids.centre[solid] if solids.kind[solid] == HULL else solids.p[solid]
    x -= p[0]
    y -= p[1]
    z -= p[2]
    a = abs(R[0, 0] * x + R[1, 0] * y + R[2, 0] * z)
    b = abs(R[0, 1] * x + R[1, 1] * y + R[2, 1] * z)
    c = abs(R[0, 2] * x + R[1, 2] * y + R[2, 2] * z)
    kind = solids.kind[solid]
    if kind in (BOX, HULL):
        a = max(a - size[0], 0.0)
        b = max(b - size[1], 0.0)
        c = max(c - size[2], 0.0)
    elif kind != POINT:
        a = max(math.sqrt(a * a + b * b) - size[0], 0.0)
        b = 0.0
        c = max(c - size[1], 0.0)
    distance: float = math.sqrt(a * a + b * b + c * c) - solids.round[solid]
    return distance


@compiled
def reduced_hull(points: Array, tolerance: float, order: Indices) -> tuple[int, float]:
    """Choose vertices whose hull is nearly that of all.

    Args:
        points: Vertices of a convex hull, shape (n, 3), m.
        tolerance: No vertex stays farther than this from the hull of the chosen ones, m.
        order: Result, the chosen vertices' rows first, shape (n,).

    Returns:
        How many were chosen, and by how much their hull has to be rounded to hold all.
    """
    n = points.shape[0]
    chosen = points.copy()
    solids = _hull_and_point(chosen)
    # not literal numbers, for which the compiler would make a version of its own
    which = np.array([0, 1])
    R = np.eye(3)
    S, v, axis = np.empty((4, 3)), np.empty(3), np.empty(3)
    taken = np.zeros(n, np.bool_)
    count = 0
    for x in range(-1, 2):
        for y in range(-1, 2):
            for z in range(-1, 2):
                i = _farthest(points, 0, n, float(x), float(y), float(z))
                if not taken[i]:
                    taken[i] = True
                    chosen[count] = points[i]
                    order[count] = i
                    count += 1
    off = np.full(n, np.inf)
    seen = np.zeros(n, np.int64)
    for i in range(n):
        if taken[i]:
            off[i] = 0.0
    while True:
        i = int(np.argmax(off))
        if seen[i] == count or off[i] == 0.0:
            # the farthest of all: distances only shrink while vertices are added
            if off[i] <= tolerance:
                return count, off[i] + 1e-9
            taken[i] = True
            chosen[count] = points[i]
            order[count] = i
            count += 1
            off[i] = 0.0
            continue
        solids.few[0, 1] = count
        axis[:] = 0.0
        bound = core_distance(solids, which[0], which[1], which[0], R, points[i], np.inf, -np.inf, axis, S, v)
        # the length found is a distance from above
        off[i] = 0.0 if bound == OVERLAP else math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2])
        seen[i] = count


@compiled
def _hull_and_point(points: Array) -> Solids:
    rows = np.zeros((2, 2), np.int64)
    return Solids(
        kind=np.array([HULL, POINT]),
        body=np.zeros(2, np.int64),
        R=np.zeros((2, 3, 3)),
        p=np.zeros((2, 3)),
        size=np.zeros((2, 3)),
        round=np.zeros(2),
        few=rows,
        pad=np.zeros(2),
        all=rows,
        points=points,
        centre=np.zeros((2, 3)),
        radius=np.zeros(2),
        rough=np.zeros(2, np.int64),
        rough_pad=np.zeros(2),
    )
