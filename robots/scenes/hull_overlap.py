"""Whether convex hulls share room: what is made of parts may reach into another thing's outline.

Two hulls are apart where some direction has all of the one before all of the other. Directions are sought by
Gilbert's algorithm: the point of the hulls' difference that is nearest to the origin is come near to, step by
step (E. G. Gilbert, SIAM J. Control 4, 1966).
"""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from kinematics.arrays import Array

_STEPS = 80
_FIRST = np.vstack([np.eye(3), -np.eye(3)])


def hulls_overlap(first: Iterable[Array], second: Iterable[Array], deeper_than_m: float) -> bool:
    """Whether some of two things' hulls reach into each other.

    Args:
        first, second: Corners of each of their hulls, shape (n, 3), m, in one frame.
        deeper_than_m: What is less deep is a touch.
    """
    others = list(second)
    return any(not _apart(one, other, deeper_than_m) for one in first for other in others)


def _apart(one: Array, other: Array, deeper_than_m: float) -> bool:
    if np.any(one.min(axis=0) > other.max(axis=0)) or np.any(other.min(axis=0) > one.max(axis=0)):
        return True
    if any(_gap_m(one, other, way) >= -deeper_than_m for way in _FIRST):
        return True
    nearest = one.mean(axis=0) - other.mean(axis=0)
    for _ in range(_STEPS):
        length = float(np.linalg.norm(nearest))
        if length < deeper_than_m:
            return False
        way = nearest / length
        corner = one[np.argmin(one @ way)] - other[np.argmax(other @ way)]
        if corner @ way >= -deeper_than_m:
            return True
        step = nearest - corner
        share = min(max(float(nearest @ step) / float(step @ step), 0.0), 1.0)
        nearest = nearest - share * step
    return False


def _gap_m(one: Array, other: Array, way: Array) -> float:
    """How far all of one is before all of the other along a direction; negative where they are not."""
    return float((one @ way).min() - (other @ way).max())
