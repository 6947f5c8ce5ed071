"""Compiled: a path between two points of the free coordinates.

RRT-Connect (Kuffner and LaValle, ICRA 2000) that is lazy about proofs: an edge of a tree is looked at in
a few points. Once the trees meet, corners of the way are left out where it looks free without them, and
what is left is proven; an edge of a tree that is not is dropped with all that grew on it. Counted in
iterations, with samples of a generator of its own, so that one seed gives one path on every machine.
"""

from __future__ import annotations

import math

import numpy as np

from kinematics.arrays import Array, Indices
from kinematics.compiled.compiler import compiled, inlined
from kinematics.kernel.judge import FREE, RESOLUTION_M, judge_edge, judge_point
from kinematics.kernel.memory import Memory
from kinematics.kernel.shortcuts import blocked, distance_of, shortcut_is_proven

# Most intervals of a proof.
_PROOF_EFFORT = 4000.0
# Nodes of a tree for each iteration; a tree that is full ends the search.
_NODES_PER_ITERATION = 8
_MOST_NODES = 60_000
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
def _may_join(memory: Memory, a: Array, b: Array) -> bool:
    """Whether an edge may join a tree: its end first, which is what is refused most often."""
    return judge_point(memory, b)[0] == FREE and not blocked(memory, a, b)


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
    way = np.empty((found.shape[0] // size, size))
    leads = np.empty((found.shape[0] // size, 2), np.int64)
    sample = np.empty(size)
    step = np.empty(size)
    for side in range(2):
        for k in range(size):
            trees[side, 0, k] = points[side, k]
        parents[side, 0] = -1
    for iteration in range(iterations):
        grown = iteration % 2
        other = 1 - grown
        for k in range(size):
            part = uniform(seed, iteration * size + k + 1)
            sample[k] = lower[k] + (upper[k] - lower[k]) * part
        near = _nearest(trees[grown], counts[grown], sample, weights)
        distance = distance_of(trees[grown, near], sample, weights)
        if distance < 1e-9:
            continue
        part = min(1.0, extend / distance)
        for k in range(size):
            step[k] = trees[grown, near, k] + (sample[k] - trees[grown, near, k]) * part
        if not _may_join(memory, trees[grown, near], step):
            continue
        if counts[grown] == most:
            return 0
        new = counts[grown]
        trees[grown, new, :] = step
        parents[grown, new] = near
        states[grown, new] = _UNSURE
        counts[grown] += 1
        node = _nearest(trees[other], counts[other], step, weights)
        joined = False
        while not joined:
            distance = distance_of(trees[other, node], trees[grown, new], weights)
            joined = distance <= extend
            part = 1.0 if joined else extend / distance
            for k in range(size):
                here = trees[other, node, k]
                step[k] = trees[grown, new, k] if joined else here + (trees[grown, new, k] - here) * part
            if not _may_join(memory, trees[other, node], step):
                joined = False
                break
            if counts[other] == most:
                return 0
            at = counts[other]
            trees[other, at, :] = step
            parents[other, at] = node
            states[other, at] = _UNSURE
            counts[other] += 1
            node = at
        if not joined:
            continue
        ends = (new, node) if grown == 0 else (node, new)
        rows = _way(trees, parents, ends[0], ends[1], way, leads)
        if rows == 0:
            return 0
        kept = _proven(memory, trees, parents, states, counts, way, leads, rows, found)
        if kept > 0:
            return kept
    return 0


@inlined
def _way(trees: Array, parents: Indices, first: int, second: int, way: Array, leads: Indices) -> int:
    """Write the way over two nodes that lie on one point.

    Args:
        trees, parents: Both trees.
        first, second: The node of each of them where they meet.
        way: Result, a point a row.
        leads: Result: tree and node whose edge leads from a row of the way to the next one.

    Returns:
        Number of its rows; 0 when it does not fit.
    """
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
    if head + tail > way.shape[0]:
        return 0
    row = head - 1
    node = first
    while node >= 0:
        way[row, :] = trees[0, node]
        if row > 0:
            leads[row - 1, 0] = 0
            leads[row - 1, 1] = node
        row -= 1
        node = parents[0, node]
    row = head
    node = second
    while parents[1, node] >= 0:
        leads[row - 1, 0] = 1
        leads[row - 1, 1] = node
        node = parents[1, node]
        way[row, :] = trees[1, node]
        row += 1
    return head + tail


@compiled
def _proven(
    memory: Memory,
    trees: Array,
    parents: Indices,
    states: Indices,
    counts: Indices,
    way: Array,
    leads: Indices,
    rows: int,
    found: Array,
) -> int:
    """Leave out corners of a way that looks free without them, and prove what is left.

    Where that cannot be proven, every other corner comes back, in the end the edges of the trees.

    Returns:
        Number of the rows that were written to ``found``; 0 when an edge of a tree is not proven, which is
        then dropped.
    """
    size = way.shape[1]
    # rows to go to, the nearest one last; each is half as far as the one before
    ahead = np.empty(64, np.int64)
    waiting = 0
    row = 0
    kept = 1
    found[:size] = way[0]
    while row < rows - 1:
        if waiting == 0:
            last = rows - 1
            while last > row + 1 and blocked(memory, way[row], way[last]):
                last -= 1
            ahead[0] = last
            waiting = 1
        goal = ahead[waiting - 1]
        if goal == row + 1:
            side, node = leads[row, 0], leads[row, 1]
            if states[side, node] == _UNSURE:
                edge = judge_edge(memory, way[row], way[goal], _PROOF_EFFORT, RESOLUTION_M)
                if edge[0] != FREE:
                    _drop(trees[side], parents[side], counts[side], node)
                    return 0
                states[side, node] = _PROVEN
        elif not shortcut_is_proven(memory, way[row], way[goal]):
            ahead[waiting] = (row + goal) // 2
            waiting += 1
            continue
        found[kept * size : (kept + 1) * size] = way[goal]
        kept += 1
        row = goal
        waiting -= 1
    return kept
