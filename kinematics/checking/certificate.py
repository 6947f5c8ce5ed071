"""Compiled: the proof that no two solids touch at any instant of a motion.

The motion is a binary tree of intervals. In an interval's middle two solids are apart by at least a
distance; within it they approach by no more than the joints between them move, times how far the
solids can be from their axes. Where the first exceeds the second the pair is done with, for the whole
interval; what is left goes on to the two halves, the earlier one first, so that the first contact of a
pair is the last thing that has to be known of it. Its upper levels join parts that are cut beforehand:
there, what stays as far apart as it is, or is far away, is proven once for many parts.

The distances are the kernel's; the kinematics and the bounds of motion are the checker's own.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from kinematics.arrays import Array, Indices
from kinematics.checking.compiled_course import (
    ROUNDING,
    Course,
    add_path,
    loose_course,
    segment_of,
    state_at,
)
from kinematics.checking.compiled_placing import FIRST_JOINT, Links, loose_links, place_needed
from kinematics.compiled.compiler import compiled, inlined
from kinematics.compiled.loose_arrays import loose1, loose2, loose3, loose_ints1, loose_ints2
from kinematics.compiled.pointers import floats1, floats2
from kinematics.distance.separation import core_distance, point_distance
from kinematics.distance.solids import HULL, Solids


@inlined
def loose_solids(solids: Solids) -> Solids:
    """Every array of solids."""
    return Solids(
        loose_ints1(solids.kind),
        loose_ints1(solids.body),
        loose3(solids.R),
        loose2(solids.p),
        loose2(solids.size),
        loose1(solids.round),
        loose_ints2(solids.few),
        loose1(solids.pad),
        loose_ints2(solids.all),
        loose2(solids.points),
        loose2(solids.centre),
        loose1(solids.radius),
        loose_ints1(solids.rough),
        loose1(solids.rough_pad),
    )


WORLD, BASE = 0, 1
# In intervals of more parts than one, distances are computed of what comes no nearer than this: of the rest
# balls tell which pairs are far away. Nothing that is near and moves is proven there.
_HARDLY_M = 0.02
# An interval of an hour is shorter than a rounding error after so many halvings.
_DEPTH = 62


class Limbs(NamedTuple):
    """The bodies that carry each solid, from its own to the base.

    Attributes:
        body: Shape (solids, depth).
        reach: Farthest that a point of the solid can be from that body's axis (from the origin of the
            base), over all configurations, shape (solids, depth), m.
        length: How many they are, shape (solids,).
    """

    body: Indices
    reach: Array
    length: Indices


class PairList(NamedTuple):
    """What may not touch.

    Attributes:
        first, second: Numbers of the solids, shape (p,).
        first_level, second_level: How many bodies are between each and what carries both, shape (p,).
        clearance: Shape (p,), m.
    """

    first: Indices
    second: Indices
    first_level: Indices
    second_level: Indices
    clearance: Array


@compiled
def _bound(
    links: Links,
    limbs: Limbs,
    solids: Solids,
    solid: int,
    length: Array,
    R: Array,
    p: Array,
    c: Array,
    moved: Array,
) -> None:
    """How far a solid's points can move against each body that it hangs on, while joints go some way.

    Joints are moved one after the other, the outermost first. Each carries a point along an arc about
    an axis that is still where it is now; the distance from it has grown by no more than what the
    joints before did, and never exceeds the farthest over all configurations.
    """
    radius = solids.radius[solid]
    total = 0.0
    moved[solid, 0] = 0.0
    for level in range(limbs.length[solid]):
        k = limbs.body[solid, level]
        d0 = c[0] - p[k, 0]
        d1 = c[1] - p[k, 1]
        d2 = c[2] - p[k, 2]
        if k == BASE:
            far = math.sqrt(d0 * d0 + d1 * d1 + d2 * d2) + radius + total
            total += length[0] + length[1] * min(far, limbs.reach[solid, level])
        elif length[k] > 2.0 * ROUNDING:
            axis = links.axis[k]
            a0 = R[k, 0, 0] * axis[0] + R[k, 0, 1] * axis[1] + R[k, 0, 2] * axis[2]
            a1 = R[k, 1, 0] * axis[0] + R[k, 1, 1] * axis[1] + R[k, 1, 2] * axis[2]
            a2 = R[k, 2, 0] * axis[0] + R[k, 2, 1] * axis[1] + R[k, 2, 2] * axis[2]
            x = a1 * d2 - a2 * d1
            y = a2 * d0 - a0 * d2
            z = a0 * d1 - a1 * d0
            far = math.sqrt(x * x + y * y + z * z) + radius + total
            total += length[k] * min(far, limbs.reach[solid, level])
        else:
            total += length[k] * limbs.reach[solid, level]
        moved[solid, level + 1] = total


@compiled
def _relative(
    solids: Solids, first: int, second: int, R: Array, p: Array, A: Array, B: Array, a: Array, b: Array
) -> None:
    """Pose of the second solid in the first's frame into ``B`` and ``b``."""
    i, j = solids.body[first], solids.body[second]
    # from the second's frame to the world
    for r in range(3):
        x, y, z = R[j, r, 0], R[j, r, 1], R[j, r, 2]
        for c in range(3):
            A[r, c] = x * solids.R[second, 0, c] + y * solids.R[second, 1, c] + z * solids.R[second, 2, c]
        a[r] = x * solids.p[second, 0] + y * solids.p[second, 1] + z * solids.p[second, 2] + p[j, r] - p[i, r]
    # to the first's body
    for r in range(3):
        x, y, z = R[i, 0, r], R[i, 1, r], R[i, 2, r]
        for c in range(3):
            B[r, c] = x * A[0, c] + y * A[1, c] + z * A[2, c]
        b[r] = x * a[0] + y * a[1] + z * a[2] - solids.p[first, r]
    if solids.kind[first] == HULL:
        return
    for r in range(3):
        x, y, z = solids.R[first, 0, r], solids.R[first, 1, r], solids.R[first, 2, r]
        for c in range(3):
            A[r, c] = x * B[0, c] + y * B[1, c] + z * B[2, c]
        a[r] = x * b[0] + y * b[1] + z * b[2]
    for r in range(3):
        for c in range(3):
            B[r, c] = A[r, c]
        b[r] = a[r]


@compiled
def certify(
    own_course: Course,
    own_links: Links,
    own_limbs: Limbs,
    own_solids: Solids,
    own_pairs: PairList,
    starts: Array,
    jumps: Array,
    collision: float,
    contact: Array,
    least: Array,
) -> int:
    """Prove all pairs apart, or find where each first touches.

    Args:
        own_course: The motion.
        own_links, own_limbs, own_solids: Robot, held objects, and what is around.
        own_pairs: What may not touch.
        starts: Times at which to cut the motion beforehand, from its start to its end, s.
        jumps: Beginnings and ends of what is looked at but not refined, shape (m, 2), s.
        collision: A pair nearer than this beyond its clearance counts as touching, m.
        contact: Result, first time of contact of each pair, infinite without, shape (p,), s.
        least: Result, the smallest distance that was met, shape (1,), m.

    Returns:
        How many distances were computed.
    """
    course, links, solids = loose_course(own_course), loose_links(own_links), loose_solids(own_solids)
    limbs = Limbs(
        loose_ints2(own_limbs.body),
        loose2(own_limbs.reach),
        loose_ints1(own_limbs.length),
    )
    pairs = PairList(
        loose_ints1(own_pairs.first),
        loose_ints1(own_pairs.second),
        loose_ints1(own_pairs.first_level),
        loose_ints1(own_pairs.second_level),
        loose1(own_pairs.clearance),
    )
    n = pairs.first.shape[0]
    bodies = links.parent.shape[0]
    count = solids.kind.shape[0]
    width = course.values.shape[1]
    own_R, own_p = np.zeros((bodies, 3, 3)), np.zeros((bodies, 3))
    R, p = loose3(own_R), loose2(own_p)
    for r in range(3):
        R[0, r, r] = 1.0
    local = np.zeros((bodies, 3, 3))
    moves = np.zeros(bodies, np.int64)
    last = course.so_far.shape[0] - 1
    for body in range(FIRST_JOINT, bodies):
        if course.so_far[last, body] > 0.0:
            moves[body] = 1
            continue
        angle = course.values[0, body + 1]
        for row in range(3):
            for column in range(3):
                local[body, row, column] = (
                    links.fixed[body, row, column]
                    + math.sin(angle) * links.sine[body, row, column]
                    + (1.0 - math.cos(angle)) * links.versine[body, row, column]
                )
    values, rates, quaternions = np.empty((3, width)), np.empty((3, width)), np.empty((3, 4))
    early, late = np.empty(width - 1), np.empty(width - 1)
    needed, wanted = np.zeros(bodies, np.int64), np.zeros(count, np.int64)
    centre, moved = np.zeros((count, 3)), np.zeros((count, limbs.body.shape[1] + 1))
    own_axis = np.zeros((n, 3))
    axis = loose2(own_axis)
    scratch = np.empty(39)
    loose = scratch.ctypes.data
    S, A, B = (
        floats2(loose, np.array([0, 4, 3])),
        floats2(loose, np.array([12, 3, 3])),
        floats2(loose, np.array([21, 3, 3])),
    )
    v, a, b = (
        floats1(loose, np.array([30, 3])),
        floats1(loose, np.array([33, 3])),
        floats1(loose, np.array([36, 3])),
    )
    parts = starts.shape[0] - 1
    levels = _DEPTH + 2
    while parts >> (levels - _DEPTH - 2) > 0:
        levels += 1
    open_pairs = np.empty(n * levels, np.int64)
    begins, ends = np.empty(levels), np.empty(levels)
    # first and last open pair, how often a part was halved, and the first and last part
    bounds = np.empty((levels, 5), np.int64)
    for k in range(n):
        open_pairs[k] = k
    begins[0], ends[0] = starts[0], starts[parts]
    bounds[0, 0], bounds[0, 1], bounds[0, 2], bounds[0, 3], bounds[0, 4] = 0, n, 0, 0, parts
    top = 1
    queries = 0
    while top > 0:
        top -= 1
        begin, end = begins[top], ends[top]
        first_open, last_open, depth = bounds[top, 0], bounds[top, 1], bounds[top, 2]
        first_part, last_part = bounds[top, 3], bounds[top, 4]
        joined = last_part - first_part > 1
        needed[:] = 0
        wanted[:] = 0
        some = False
        for row in range(first_open, last_open):
            pair = open_pairs[row]
            if contact[pair] <= begin:
                continue
            some = True
            wanted[pairs.first[pair]] = 1
            wanted[pairs.second[pair]] = 1
        if not some:
            continue
        middle = 0.5 * (begin + end)
        i, j, k = segment_of(course.t_s, begin), segment_of(course.t_s, middle), segment_of(course.t_s, end)
        state_at(course, i, begin, values[0], rates[0], quaternions[0])
        state_at(course, j, middle, values[1], rates[1], quaternions[1])
        state_at(course, k, end, values[2], rates[2], quaternions[2])
        add_path(
            course, begin, i, values[0], rates[0], quaternions[0],
            middle, j, values[1], rates[1], quaternions[1], early,
        )  # fmt: skip
        add_path(
            course, middle, j, values[1], rates[1], quaternions[1],
            end, k, values[2], rates[2], quaternions[2], late,
        )  # fmt: skip
        for r in range(width - 1):
            early[r] = max(early[r], late[r])
        for solid in range(count):
            if wanted[solid] == 1:
                body = solids.body[solid]
                while body != WORLD and needed[body] == 0:
                    needed[body] = 1
                    body = links.parent[body]
        place_needed(links, values[1], quaternions[1], moves, needed, local, R, p)
        for solid in range(count):
            if wanted[solid] == 1:
                body = solids.body[solid]
                c = solids.centre[solid]
                for r in range(3):
                    centre[solid, r] = (
                        p[body, r] + R[body, r, 0] * c[0] + R[body, r, 1] * c[1] + R[body, r, 2] * c[2]
                    )
                _bound(links, limbs, solids, solid, early, R, p, centre[solid], moved)
        jumping = False
        for r in range(jumps.shape[0]):
            if jumps[r, 0] - 1e-9 <= begin and end <= jumps[r, 1] + 1e-9:
                jumping = True
        left = last_open
        for row in range(first_open, last_open):
            pair = open_pairs[row]
            if contact[pair] <= begin:
                continue
            first, second = pairs.first[pair], pairs.second[pair]
            step = moved[first, pairs.first_level[pair]] + moved[second, pairs.second_level[pair]]
            need = pairs.clearance[pair] + step
            c = centre[first]
            if solids.body[second] == WORLD and solids.kind[second] != HULL:
                apart = point_distance(solids, second, c[0], c[1], c[2]) - solids.radius[first]
            else:
                d = centre[second]
                square = (c[0] - d[0]) ** 2 + (c[1] - d[1]) ** 2 + (c[2] - d[2]) ** 2
                apart = math.sqrt(square) - solids.radius[first] - solids.radius[second]
            if apart > need + 1e-9:
                continue
            if joined and step > _HARDLY_M:
                open_pairs[left] = pair
                left += 1
                continue
            _relative(solids, first, second, R, p, A, B, a, b)
            rounding = solids.round[first] + solids.round[second]
            queries += 1
            w = axis[pair]
            # nothing beyond this has to be known better: it is proven, and farther than others
            target = max(need, least[0])
            touching = pairs.clearance[pair] + collision
            pad = solids.pad[first] + solids.pad[second]
            enough = target + rounding + pad
            low = core_distance(solids, first, second, 0, B, b, enough, -math.inf, w, S, v)
            if low > enough:
                continue
            high = low
            low -= rounding + pad
            # both reduced hulls are parts of the whole ones, which are therefore no farther apart
            if low <= max(touching, least[0]) or high - rounding > need - 1e-6:
                enough = target + rounding
                apart = core_distance(solids, first, second, 1, B, b, enough, -math.inf, w, S, v) - rounding
                if apart > target:
                    continue
                least[0] = min(least[0], apart)
                if apart > need:
                    continue
            else:
                apart = low
            if apart < touching:
                contact[pair] = min(contact[pair], middle)
                if step <= collision:
                    # all of this interval is as near, and everything before is proven
                    contact[pair] = begin
                    continue
            if joined or (not jumping and depth < _DEPTH):
                open_pairs[left] = pair
                left += 1
        if left > last_open:
            cut = (first_part + last_part) // 2
            if joined:
                middle = starts[cut]
            else:
                depth += 1
            for half in range(2):
                begins[top] = middle if half == 0 else begin
                ends[top] = end if half == 0 else middle
                bounds[top, 0], bounds[top, 1], bounds[top, 2] = last_open, left, depth
                bounds[top, 3] = cut if joined and half == 0 else first_part
                bounds[top, 4] = cut if joined and half == 1 else last_part
                top += 1
    # a last use: their owners keep the loose arrays' memory until here
    owners = own_R.shape[0] + own_p.shape[0] + own_axis.shape[0] + scratch.shape[0]
    return queries if owners > 0 else 0
