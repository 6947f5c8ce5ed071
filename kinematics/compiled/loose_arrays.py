"""Compiled: arrays without a count of their users, see ``kernel.pointers``: who calls keeps them alive.

They are found again by address and shape alone: who calls makes sure that they are ``in_one_piece``.
"""

from __future__ import annotations

import functools
from typing import Any, get_type_hints

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array, Indices
from kinematics.compiled.compiler import inlined
from kinematics.compiled.pointers import floats1, floats2, floats3, ints1, ints2

_FLOATS, _INTS = np.dtype(np.float64), np.dtype(np.int64)


def in_one_piece(*values: object) -> None:
    """Refuse arrays that would be read as others than they are, also inside of tuples.

    An array has no gaps, holds float64, or int64 where a named tuple declares ``Indices``, and can be
    written: to the compiler, one that cannot is of another type.

    Raises:
        ValueError: One is not like that.
    """
    for value in values:
        if isinstance(value, tuple):
            # the arrays of a named tuple at once: a check asks for fifty
            for part, item in zip(value, _declared(type(value)) or (_FLOATS,) * len(value), strict=True):
                if isinstance(part, np.ndarray):
                    if part.dtype is not item or not part.flags.carray:
                        _refuse(part, item)
                elif isinstance(part, tuple):
                    in_one_piece(part)
        elif isinstance(value, np.ndarray) and (value.dtype is not _FLOATS or not value.flags.carray):
            _refuse(value, _FLOATS)


def _refuse(value: NDArray[Any], item: np.dtype[Any]) -> None:
    """Say what is wrong with an array, if something is."""
    if not value.flags.c_contiguous:
        raise ValueError(f"an array of shape {value.shape} has gaps")
    if value.dtype != item:
        raise ValueError(f"an array of shape {value.shape} holds {value.dtype}, not {item}")
    if not value.flags.carray:
        raise ValueError(f"an array of shape {value.shape} is read-only or not aligned")


@functools.cache
def _declared(kind: type) -> tuple[np.dtype[Any], ...]:
    """What the arrays of a named tuple hold; nothing of a plain tuple."""
    hints = get_type_hints(kind)
    return tuple(_INTS if hints[name] == Indices else _FLOATS for name in getattr(kind, "_fields", ()))


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
