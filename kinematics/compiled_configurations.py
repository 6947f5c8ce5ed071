"""Compiled: configurations of many points of free coordinates at once."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from kinematics.kernel.compiler import compiled
from kinematics.kernel.coordinates import Coordinates
from kinematics.kernel.posture import configuration
from kinematics.kernel.tree import Tree

Array = NDArray[np.float64]


@compiled
def configurations(space: Coordinates, tree: Tree, x: Array, q: Array, reached: NDArray[np.bool_]) -> None:
    """Write configurations.

    Args:
        space, tree: The robot on its feet.
        x: Points, shape (n, size).
        q: Result, shape (n, nq).
        reached: Result: whether every foot can be kept, shape (n,).
    """
    base_R = np.empty((3, 3))
    for k in range(x.shape[0]):
        reached[k] = configuration(space, tree, x[k], q[k], base_R)
