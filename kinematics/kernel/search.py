"""Compiled: a path between two points of the free coordinates, and a shorter one.

RRT-Connect (Kuffner and LaValle, ICRA 2000) that is lazy about proofs: an edge of a tree is judged in
intervals of a centimetre's motion, and proven only when it is part of a path; one that is not proven
then is dropped with all that grew on it. Counted in iterations, with samples of a generator of its own,
so that one seed gives one path on every machine.
"""

from __future__ import annotations

import math

import numpy as np

from kinematics.kernel.compiler import compiled, inlined
from kinematics.kernel.judge import CONTACT, FREE, PRESUMED, RESOLUTION_M, judge_edge, judge_point
from kinematics.kernel.memory import Memory, problem_at, work_at
from kinematics.kernel.solids import Array, Indices

# Most intervals of a proof.
_PROOF_EFFORT = 4000.0
# Most points at which an edge is asked first.
_MOST_POINTS = 16
# Nodes of a tree for each iteration; a tree that is full ends the search.
_NODES_PER_ITERATION = 8
_MOST_NODES = 60_000
# A shortcut is worth its proof when it saves this part of what it replaces.
_WORTH = 0.01
# A point of a dropped branch is put here, where it is nobody's neighbour.
_NOWHERE = 1e15
# State of the edge that leads to a node.
_PROVEN, _UNSURE = 1, 0


@inlined
def uniform(seed: int, counter: int) -> float:
    """The number in [0, 1) that a counter has in a stream (splitmix64: Steele, Lea, Flood, 2014)."""
    z = np.uint64(seed) + np.uint64(counter) * np.uint64(0x9E3779B97F4A7C15)
    z = (z ^ (z >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
    z = (z ^ (z >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
    z = z ^ (z >> np.uint64(31))
    return float(z >> np.uint64(11)) * (1.0 / 9007199254740992.0)


@inlined
def _distance(a: Array, b: Array, weights: Array) -> float:
    square = 0.0
    for k in range(a.shape[0]):
        step = (a[k] - b[k]) * weights[k]
        square += step * step
    return math.sqrt(square)


@inlined
def _nearest(tree: Array, count: int, point: Array, weights: Array) -> int:
    best = 0
    least = math.inf
    for i in range(count):
        square = 0.0
        for k in range(point.shape[0]):
            step = (tree[i, k] - point[k]) * weights[k]
            square += step * step
            if square >= least:
                break
        if square < least:
            least = square
            best = i
    return best


@compiled
def _blocked(memory: Memory, a: Array, b: Array) -> bool:
    """Whether an edge is refused at one of a few points, the middle first; a point is cheap."""
    work, step = work_at(memory), problem_at(memory).tuning.point_step_rad
    widest = 0.0
    for k in range(a.shape[0]):
        widest = max(widest, abs(b[k] - a[k]))
    count = 1
    while count < _MOST_POINTS and widest > step * (count + 1):
        for i in range(count):
            t = (i + 0.5) / count
            for k in range(a.shape[0]):
                work.x[k] = a[k] + (b[k] - a[k]) * t
            if judge_point(memory, work.x)[0] != FREE:
                return True
        count *= 2
    return False


@compiled
def _look(memory: Memory, a: Array, b: Array) -> int:
    """Whether an edge may join a tree: its end first, which is what is refused most often."""
    verdict, _ = judge_point(memory, b)
    if verdict != FREE:
        return verdict
    if _blocked(memory, a, b):
        return CONTACT
    tuning = problem_at(memory).tuning
    return judge_edge(memory, a, b, tuning.tree_effort, -tuning.look_m)[0]


@compiled
def _prove(memory: Memory, tree: Array, parent: Indices, state: Indices, count: int, node: int) -> bool:
    """Prove the way from a node to its root; drop what grew on an edge that is not proven."""
    while parent[node] >= 0:
        if state[node] == _UNSURE:
            edge = judge_edge(memory, tree[parent[node]], tree[node], _PROOF_EFFORT, RESOLUTION_M)
            if edge[0] != FREE:
                _drop(tree, parent, count, node)
                return False
            state[node] = _PROVEN
        node = parent[node]
    return True


@inlined
def _drop(tree: Array, parent: Indices, count: int, node: int) -> None:
    """Move a branch out of the way; a node is younger than what it grew on."""
    tree[node, :] = _NOWHERE
    for i in range(node + 1, count):
        if tree[parent[i], 0] == _NOWHERE:
            tree[i, :] = _NOWHERE


@compiled
def connect(memory: Memory, points: Array, iterations: int, found: Array) -> int:
    """Search a way between two points.

    Args:
        memory: Robot and scene.
        points: Start, goal, least and largest sample, weights, shape (5, size).
        iterations: Most extensions.
        found: On entry the seed, a whole number below 2**53, and the longest step of a tree; on return
            the way, row behind row, when it fits.

    Returns:
        Number of rows of the way, both ends among them; 0 when none was found or it does not fit.
    """
    size = points.shape[1]
    lower, upper, weights = points[2], points[3], points[4]
    seed = int(found[0])
    extend = found[1]
    if judge_point(memory, points[0])[0] != FREE or judge_point(memory, points[1])[0] != FREE:
        return 0
    most = min(_MOST_NODES, _NODES_PER_ITERATION * iterations + 8)
    trees = np.empty((2, most, size))
    parents = np.empty((2, most), np.int64)
    states = np.empty((2, most), np.int64)
    counts = np.ones(2, np.int64)
    sample = np.empty(size)
    step = np.empty(size)
    for side in range(2):
        for k in range(size):
            trees[side, 0, k] = points[side, k]
        parents[side, 0] = -1
        states[side, 0] = _PROVEN
    for iteration in range(iterations):
        grown = iteration % 2
        other = 1 - grown
        for k in range(size):
            part = uniform(seed, iteration * size + k + 1)
            sample[k] = lower[k] + (upper[k] - lower[k]) * part
        near = _nearest(trees[grown], counts[grown], sample, weights)
        distance = _distance(trees[grown, near], sample, weights)
        if distance < 1e-9:
            continue
        part = min(1.0, extend / distance)
        for k in range(size):
            step[k] = trees[grown, near, k] + (sample[k] - trees[grown, near, k]) * part
        verdict = _look(memory, trees[grown, near], step)
        if verdict != FREE and verdict != PRESUMED:
            continue
        if counts[grown] == most:
            return 0
        new = counts[grown]
        trees[grown, new, :] = step
        parents[grown, new] = near
        states[grown, new] = _PROVEN if verdict == FREE else _UNSURE
        counts[grown] += 1
        node = _nearest(trees[other], counts[other], step, weights)
        joined = False
        while not joined:
            distance = _distance(trees[other, node], trees[grown, new], weights)
            joined = distance <= extend
            part = 1.0 if joined else extend / distance
            for k in range(size):
                here = trees[other, node, k]
                step[k] = trees[grown, new, k] if joined else here + (trees[grown, new, k] - here) * part
            verdict = _look(memory, trees[other, node], step)
            if verdict != FREE and verdict != PRESUMED:
                joined = False
                break
            if counts[other] == most:
                return 0
            at = counts[other]
            trees[other, at, :] = step
            parents[other, at] = node
            states[other, at] = _PROVEN if verdict == FREE else _UNSURE
            counts[other] += 1
            node = at
        if not joined:
            continue
        if not _prove(memory, trees[grown], parents[grown], states[grown], counts[grown], new):
            continue
        if not _prove(memory, trees[other], parents[other], states[other], counts[other], node):
            continue
        ends = (new, node) if grown == 0 else (node, new)
        return _way(trees, parents, ends[0], ends[1], found)
    return 0


@inlined
def _way(trees: Array, parents: Indices, first: int, second: int, found: Array) -> int:
    """Write the way over two nodes that lie on one point; see ``connect``."""
    size = trees.shape[2]
    head = 0
    node = first
    while node >= 0:
        head += 1
        node = parents[0, node]
    tail = 0
    node = parents[1, second]
    while node >= 0:
        tail += 1
        node = parents[1, node]
    if (head + tail) * size > found.shape[0]:
        return 0
    row = head - 1
    node = first
    while node >= 0:
        found[row * size : (row + 1) * size] = trees[0, node]
        row -= 1
        node = parents[0, node]
    row = head
    node = parents[1, second]
    while node >= 0:
        found[row * size : (row + 1) * size] = trees[1, node]
        row += 1
        node = parents[1, node]
    return head + tail


@inlined
def _point_at(way: Array, along: Array, count: int, at: float, point: Array) -> int:
    """Write the point at a length along a way; tell the row before it."""
    row = 0
    while row < count - 2 and along[row + 1] <= at:
        row += 1
    length = along[row + 1] - along[row]
    part = min(1.0, max(0.0, (at - along[row]) / length)) if length > 0.0 else 0.0
    for k in range(point.shape[0]):
        point[k] = way[row, k] + (way[row + 1, k] - way[row, k]) * part
    return row


@compiled
def shorten(memory: Memory, points: Array, iterations: int, found: Array) -> int:
    """Cut corners of a free way: between any two points on it, not between its corners alone.

    Args:
        memory: Robot and scene.
        points: Weights, then the way, shape (1 + rows, size).
        iterations: Attempts.
        found: On entry the seed; on return the way, row behind row, never longer than it was.

    Returns:
        Number of its rows; 0 when it does not fit.
    """
    tuning = problem_at(memory).tuning
    size = points.shape[1]
    weights = points[0]
    seed = int(found[0])
    most = found.shape[0] // size
    count: int = points.shape[0] - 1
    if count > most:
        return 0
    way = np.empty((most, size))
    along = np.zeros(most)
    a = np.empty(size)
    b = np.empty(size)
    for row in range(count):
        for k in range(size):
            way[row, k] = points[row + 1, k]
    for row in range(1, count):
        along[row] = along[row - 1] + _distance(way[row - 1], way[row], weights)
    for attempt in range(iterations):
        if count <= 2:
            break
        one = uniform(seed, 2 * attempt + 1) * along[count - 1]
        two = uniform(seed, 2 * attempt + 2) * along[count - 1]
        first = _point_at(way, along, count, min(one, two), a)
        second = _point_at(way, along, count, max(one, two), b)
        gap = abs(two - one)
        # rows between the two points give way to them
        if second == first or count + 2 - (second - first) > most:
            continue
        if _distance(a, b, weights) > (1.0 - _WORTH) * gap:
            continue
        if _blocked(memory, a, b):
            continue
        if judge_edge(memory, a, b, tuning.shortcut_effort, tuning.shortcut_m)[0] != FREE:
            continue
        shift = 2 - (second - first)
        if shift > 0:
            for row in range(count - 1, second, -1):
                way[row + shift, :] = way[row]
        elif shift < 0:
            for row in range(second + 1, count):
                way[row + shift, :] = way[row]
        way[first + 1, :] = a
        way[first + 2, :] = b
        count += shift
        for row in range(max(1, first), count):
            along[row] = along[row - 1] + _distance(way[row - 1], way[row], weights)
    for row in range(count):
        found[row * size : (row + 1) * size] = way[row]
    return count
