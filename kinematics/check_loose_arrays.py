"""Compiled: arrays without a count of their users, see ``kernel.pointers``: who calls keeps them alive.

They are found again by address and shape alone: who calls makes sure that they are ``in_one_piece``.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from kinematics.kernel.compiler import inlined
from kinematics.kernel.pointers import floats1, floats2, floats3, ints1, ints2
from kinematics.kernel.solids import Solids

Array = NDArray[np.float64]
Indices = NDArray[np.int64]


def in_one_piece(*values: object) -> None:
    """Refuse arrays with gaps, also inside of tuples: they would be read as others than they are.

    Raises:
        ValueError: There is one.
    """
    for value in values:
        if isinstance(value, tuple):
            in_one_piece(*value)
        elif isinstance(value, np.ndarray) and not value.flags.c_contiguous:
            raise ValueError(f"an array of shape {value.shape} has gaps")


@inlined
def loose1(a: Array) -> Array:
    """One dimension."""
    return floats1(a.ctypes.data, np.array([0, a.shape[0]]))


@inlined
def loose2(a: Array) -> Array:
    """Two dimensions."""
    return floats2(a.ctypes.data, np.array([0, a.shape[0], a.shape[1]]))


@inlined
def loose3(a: Array) -> Array:
    """Three dimensions."""
    return floats3(a.ctypes.data, np.array([0, a.shape[0], a.shape[1], a.shape[2]]))


@inlined
def loose_ints1(a: Indices) -> Indices:
    """One dimension of integers."""
    return ints1(a.ctypes.data, np.array([0, a.shape[0]]))


@inlined
def loose_ints2(a: Indices) -> Indices:
    """Two dimensions of integers."""
    return ints2(a.ctypes.data, np.array([0, a.shape[0], a.shape[1]]))


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
