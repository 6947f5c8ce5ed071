"""Compiled: the proof that no two solids touch at any instant of a motion.

The motion is a binary tree of intervals. In an interval's middle two solids are apart by at least a
distance; within it they approach by no more than the joints between them move, times how far the
solids can be from their axes. Where the first exceeds the second the pair is done with, for the whole
interval; what is left goes on to the two halves, the earlier one first, so that the first contact of a
pair is the last thing that has to be known of it.

The distances are the kernel's; the kinematics and the bounds of motion are the checker's own. All
compiled code of the checker is in this file: numba looks at a function's own file alone to tell
whether what it kept is stale.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kinematics.kernel.compiler import compiled, inlined
from kinematics.kernel.pointers import floats1, floats2, floats3, ints1, ints2
from kinematics.kernel.separation import core_distance, point_distance
from kinematics.kernel.solids import HULL, Solids

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

_WORLD, _BASE, _FIRST_JOINT = 0, 1, 2
# An interval of an hour is shorter than a rounding error after so many halvings.
_DEPTH = 62
# Sums of path lengths are differences of running sums: their rounding, in m and rad.
_ROUNDING = 1e-12


class Course(NamedTuple):
    """A trajectory as arrays; see ``Timeline``.

    Attributes:
        t_s: Sample times, shape (n,).
        values, rates: Base position and joints, and their rates, shape (n, 3 + k).
        quaternions: Of the base, shape (n, 4).
        so_far: Path lengths (base, turn, joints) from the start to each sample, shape (n, 2 + k).
    """

    t_s: Array
    values: Array
    rates: Array
    quaternions: Array
    so_far: Array


class Links(NamedTuple):
    """The kinematic tree, with Rodrigues' formula multiplied out; see ``BatchedKinematics``.

    Attributes:
        parent: Shape (bodies,).
        offset: Shape (bodies, 3), m.
        axis: Shape (bodies, 3).
        fixed, sine, versine: Shape (bodies, 3, 3).
    """

    parent: Indices
    offset: Array
    axis: Array
    fixed: Array
    sine: Array
    versine: Array


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


# Arrays without a count of their users, see ``kernel.pointers``: whoever calls keeps them alive.
@inlined
def _loose1(a: Array) -> Array:
    return floats1(a.ctypes.data, np.array([0, a.shape[0]]))


@inlined
def _loose2(a: Array) -> Array:
    return floats2(a.ctypes.data, np.array([0, a.shape[0], a.shape[1]]))


@inlined
def _loose3(a: Array) -> Array:
    return floats3(a.ctypes.data, np.array([0, a.shape[0], a.shape[1], a.shape[2]]))


@inlined
def _loose_ints1(a: Indices) -> Indices:
    return ints1(a.ctypes.data, np.array([0, a.shape[0]]))


@inlined
def _loose_ints2(a: Indices) -> Indices:
    return ints2(a.ctypes.data, np.array([0, a.shape[0], a.shape[1]]))


@inlined
def _loose_course(course: Course) -> Course:
    return Course(
        _loose1(course.t_s),
        _loose2(course.values),
        _loose2(course.rates),
        _loose2(course.quaternions),
        _loose2(course.so_far),
    )


@inlined
def _loose_links(links: Links) -> Links:
    return Links(
        _loose_ints1(links.parent),
        _loose2(links.offset),
        _loose2(links.axis),
        _loose3(links.fixed),
        _loose3(links.sine),
        _loose3(links.versine),
    )


@inlined
def _loose_solids(solids: Solids) -> Solids:
    return Solids(
        _loose_ints1(solids.kind),
        _loose_ints1(solids.body),
        _loose3(solids.R),
        _loose2(solids.p),
        _loose2(solids.size),
        _loose1(solids.round),
        _loose_ints2(solids.few),
        _loose1(solids.pad),
        _loose_ints2(solids.all),
        _loose2(solids.points),
        _loose2(solids.centre),
        _loose1(solids.radius),
    )


@inlined
def _segment(t_s: Array, time: float) -> int:
    low = 0
    high = t_s.shape[0] - 1
    while high - low > 1:
        middle = (low + high) // 2
        if t_s[middle] <= time:
            low = middle
        else:
            high = middle
    return low


@compiled
def _state(course: Course, i: int, time: float, value: Array, rate: Array, quaternion: Array) -> None:
    """Values, rates and base orientation at a time in segment ``i``."""
    h = course.t_s[i + 1] - course.t_s[i]
    u = (time - course.t_s[i]) / h
    for r in range(value.shape[0]):
        change = course.values[i + 1, r] - course.values[i, r]
        bow = course.rates[i, r] * h - change
        lean = change - course.rates[i + 1, r] * h
        value[r] = course.values[i, r] + u * change + u * (1.0 - u) * ((1.0 - u) * bow + u * lean)
        rate[r] = (change + (1.0 - u) * (1.0 - 3.0 * u) * bow + u * (2.0 - 3.0 * u) * lean) / h
    square = 0.0
    for r in range(4):
        c = (1.0 - u) * course.quaternions[i, r] + u * course.quaternions[i + 1, r]
        quaternion[r] = c
        square += c * c
    length = math.sqrt(square)
    for r in range(4):
        quaternion[r] /= length


@inlined
def _add_piece(
    value_a: Array,
    rate_a: Array,
    quaternion_a: Array,
    value_b: Array,
    rate_b: Array,
    quaternion_b: Array,
    duration: float,
    out: Array,
) -> None:
    """Add the lengths of the control polygons of one cubic piece: no path is longer."""
    third = duration / 3.0
    first = 0.0
    middle = 0.0
    last = 0.0
    for r in range(3):
        a = rate_a[r] * third
        c = rate_b[r] * third
        b = value_b[r] - value_a[r] - a - c
        first += a * a
        middle += b * b
        last += c * c
    out[0] += math.sqrt(first) + math.sqrt(middle) + math.sqrt(last)
    chord = 0.0
    for r in range(4):
        d = quaternion_b[r] - quaternion_a[r]
        chord += d * d
    out[1] += 4.0 * math.asin(min(0.5 * math.sqrt(chord), 1.0))
    for r in range(3, value_a.shape[0]):
        a = rate_a[r] * third
        c = rate_b[r] * third
        out[r - 1] += abs(a) + abs(value_b[r] - value_a[r] - a - c) + abs(c)


@compiled
def running_lengths(t_s: Array, values: Array, rates: Array, quaternions: Array, so_far: Array) -> None:
    """Lengths of all paths from the start to each sample; arguments as of ``Course``."""
    so_far[0] = 0.0
    for i in range(t_s.shape[0] - 1):
        for r in range(so_far.shape[1]):
            so_far[i + 1, r] = so_far[i, r]
        _add_piece(
            values[i], rates[i], quaternions[i], values[i + 1], rates[i + 1], quaternions[i + 1],
            t_s[i + 1] - t_s[i], so_far[i + 1],
        )  # fmt: skip


@compiled
def _add_path(
    course: Course,
    begin: float,
    i: int,
    value_a: Array,
    rate_a: Array,
    quaternion_a: Array,
    end: float,
    j: int,
    value_b: Array,
    rate_b: Array,
    quaternion_b: Array,
    out: Array,
) -> None:
    """Lengths of all paths between two instants, in the segments ``i`` and ``j``."""
    out[:] = _ROUNDING
    t_s, values, rates, quaternions = course.t_s, course.values, course.rates, course.quaternions
    if i == j:
        _add_piece(value_a, rate_a, quaternion_a, value_b, rate_b, quaternion_b, end - begin, out)
        return
    n = i + 1
    _add_piece(value_a, rate_a, quaternion_a, values[n], rates[n], quaternions[n], t_s[n] - begin, out)
    for r in range(out.shape[0]):
        out[r] += course.so_far[j, r] - course.so_far[n, r]
    _add_piece(values[j], rates[j], quaternions[j], value_b, rate_b, quaternion_b, end - t_s[j], out)


@compiled
def _place(
    links: Links,
    value: Array,
    quaternion: Array,
    moves: Indices,
    needed: Indices,
    local: Array,
    R: Array,
    p: Array,
) -> None:
    """Poses of the needed bodies; ``local`` holds the rotations of joints that do not move."""
    x, y, z, w = quaternion[0], quaternion[1], quaternion[2], quaternion[3]
    R[1, 0, 0] = 1.0 - 2.0 * (y * y + z * z)
    R[1, 0, 1] = 2.0 * (x * y - z * w)
    R[1, 0, 2] = 2.0 * (x * z + y * w)
    R[1, 1, 0] = 2.0 * (x * y + z * w)
    R[1, 1, 1] = 1.0 - 2.0 * (x * x + z * z)
    R[1, 1, 2] = 2.0 * (y * z - x * w)
    R[1, 2, 0] = 2.0 * (x * z - y * w)
    R[1, 2, 1] = 2.0 * (y * z + x * w)
    R[1, 2, 2] = 1.0 - 2.0 * (x * x + y * y)
    for r in range(3):
        p[1, r] = value[r]
    for body in range(_FIRST_JOINT, needed.shape[0]):
        if needed[body] == 0:
            continue
        k = links.parent[body]
        if moves[body] == 1:
            angle = value[body + 1]
            sine = math.sin(angle)
            versine = 1.0 - math.cos(angle)
            for a in range(3):
                for b in range(3):
                    local[body, a, b] = (
                        links.fixed[body, a, b]
                        + sine * links.sine[body, a, b]
                        + versine * links.versine[body, a, b]
                    )
        o = links.offset[body]
        for a in range(3):
            x, y, z = R[k, a, 0], R[k, a, 1], R[k, a, 2]
            for b in range(3):
                R[body, a, b] = x * local[body, 0, b] + y * local[body, 1, b] + z * local[body, 2, b]
            p[body, a] = x * o[0] + y * o[1] + z * o[2] + p[k, a]


@compiled
def place_all(
    links: Links,
    base_R: Array,
    base_p: Array,
    joints: Array,
    needed: Indices,
    mass: Array,
    lever: Array,
    R: Array,
    p: Array,
    com: Array,
) -> None:
    """Poses of the needed bodies at n instants, and the moment of mass of those.

    Args:
        links: The robot.
        base_R, base_p: Poses of the base, shapes (n, 3, 3) and (n, 3), m.
        joints: Joint positions, shape (n, k), rad.
        needed: 1 for bodies to be placed, with all that they hang on, shape (bodies,).
        mass, lever: Of each body, shapes (bodies,) and (bodies, 3), kg and m.
        R, p: Results, shapes (bodies, n, 3, 3) and (bodies, n, 3).
        com: Result, sum of masses times positions, shape (n, 3), kg m.
    """
    local = np.empty((3, 3))
    for i in range(base_p.shape[0]):
        for a in range(3):
            for b in range(3):
                R[0, i, a, b] = 1.0 if a == b else 0.0
                R[1, i, a, b] = base_R[i, a, b]
            p[0, i, a] = 0.0
            p[1, i, a] = base_p[i, a]
        for body in range(_FIRST_JOINT, needed.shape[0]):
            if needed[body] == 0:
                continue
            k = links.parent[body]
            angle = joints[i, body - _FIRST_JOINT]
            sine = math.sin(angle)
            versine = 1.0 - math.cos(angle)
            for a in range(3):
                for b in range(3):
                    local[a, b] = (
                        links.fixed[body, a, b]
                        + sine * links.sine[body, a, b]
                        + versine * links.versine[body, a, b]
                    )
            for a in range(3):
                x, y, z = R[k, i, a, 0], R[k, i, a, 1], R[k, i, a, 2]
                for b in range(3):
                    R[body, i, a, b] = x * local[0, b] + y * local[1, b] + z * local[2, b]
                o = links.offset[body]
                p[body, i, a] = x * o[0] + y * o[1] + z * o[2] + p[k, i, a]
        for a in range(3):
            total = 0.0
            for body in range(needed.shape[0]):
                if needed[body] == 1:
                    c = lever[body]
                    x = R[body, i, a, 0] * c[0] + R[body, i, a, 1] * c[1] + R[body, i, a, 2] * c[2]
                    total += mass[body] * (x + p[body, i, a])
            com[i, a] = total


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
        if k == _BASE:
            far = math.sqrt(d0 * d0 + d1 * d1 + d2 * d2) + radius + total
            total += length[0] + length[1] * min(far, limbs.reach[solid, level])
        elif length[k] > 2.0 * _ROUNDING:
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
    course, links, solids = _loose_course(own_course), _loose_links(own_links), _loose_solids(own_solids)
    limbs = Limbs(
        _loose_ints2(own_limbs.body),
        _loose2(own_limbs.reach),
        _loose_ints1(own_limbs.length),
    )
    pairs = PairList(
        _loose_ints1(own_pairs.first),
        _loose_ints1(own_pairs.second),
        _loose_ints1(own_pairs.first_level),
        _loose_ints1(own_pairs.second_level),
        _loose1(own_pairs.clearance),
    )
    n = pairs.first.shape[0]
    bodies = links.parent.shape[0]
    count = solids.kind.shape[0]
    width = course.values.shape[1]
    own_R, own_p = np.zeros((bodies, 3, 3)), np.zeros((bodies, 3))
    R, p = _loose3(own_R), _loose2(own_p)
    for r in range(3):
        R[0, r, r] = 1.0
    local = np.zeros((bodies, 3, 3))
    moves = np.zeros(bodies, np.int64)
    last = course.so_far.shape[0] - 1
    for body in range(_FIRST_JOINT, bodies):
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
    axis = _loose2(own_axis)
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
    open_pairs = np.empty(n * (_DEPTH + 2), np.int64)
    spans = starts.shape[0] - 1
    begins, ends = np.empty(spans + _DEPTH + 2), np.empty(spans + _DEPTH + 2)
    bounds = np.empty((spans + _DEPTH + 2, 3), np.int64)
    for k in range(n):
        open_pairs[k] = k
    for k in range(spans):
        begins[k], ends[k] = starts[spans - 1 - k], starts[spans - k]
        bounds[k, 0], bounds[k, 1], bounds[k, 2] = 0, n, 0
    top = spans
    queries = 0
    while top > 0:
        top -= 1
        begin, end = begins[top], ends[top]
        first_open, last_open, depth = bounds[top, 0], bounds[top, 1], bounds[top, 2]
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
        i, j, k = _segment(course.t_s, begin), _segment(course.t_s, middle), _segment(course.t_s, end)
        _state(course, i, begin, values[0], rates[0], quaternions[0])
        _state(course, j, middle, values[1], rates[1], quaternions[1])
        _state(course, k, end, values[2], rates[2], quaternions[2])
        _add_path(
            course, begin, i, values[0], rates[0], quaternions[0],
            middle, j, values[1], rates[1], quaternions[1], early,
        )  # fmt: skip
        _add_path(
            course, middle, j, values[1], rates[1], quaternions[1],
            end, k, values[2], rates[2], quaternions[2], late,
        )  # fmt: skip
        for r in range(width - 1):
            early[r] = max(early[r], late[r])
        for solid in range(count):
            if wanted[solid] == 1:
                body = solids.body[solid]
                while body != _WORLD and needed[body] == 0:
                    needed[body] = 1
                    body = links.parent[body]
        _place(links, values[1], quaternions[1], moves, needed, local, R, p)
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
            if solids.body[second] == _WORLD and solids.kind[second] != HULL:
                apart = point_distance(solids, second, c[0], c[1], c[2]) - solids.radius[first]
            else:
                d = centre[second]
                square = (c[0] - d[0]) ** 2 + (c[1] - d[1]) ** 2 + (c[2] - d[2]) ** 2
                apart = math.sqrt(square) - solids.radius[first] - solids.radius[second]
            if apart > need + 1e-9:
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
                contact[pair] = middle
                if step <= collision:
                    # all of this interval is as near, and everything before is proven
                    contact[pair] = begin
                    continue
            if not jumping and depth < _DEPTH:
                open_pairs[left] = pair
                left += 1
        if left > last_open:
            for half in range(2):
                begins[top] = middle if half == 0 else begin
                ends[top] = end if half == 0 else middle
                bounds[top, 0], bounds[top, 1], bounds[top, 2] = last_open, left, depth + 1
                top += 1
    # a last use: their owners keep the loose arrays' memory until here
    owners = own_R.shape[0] + own_p.shape[0] + own_axis.shape[0] + scratch.shape[0]
    return queries if owners > 0 else 0
