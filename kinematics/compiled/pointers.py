"""Arrays on memory that someone else keeps.

A view of an ordinary array counts its users with atomic instructions, also in compiled code; in the
inner loops that costs more than the arithmetic. An array made from an address has no count.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numba
from numba import types
from numba.extending import intrinsic

from kinematics.arrays import Array, Indices
from kinematics.compiled.compiler import inlined


def _pointer_to(item: Any) -> Callable[..., Any]:
    pointer_type: Any = types.CPointer

    def pointer(_context: Any, _address: Any) -> tuple[Any, Callable[..., Any]]:
        def emit(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
            return builder.inttoptr(arguments[0], context.get_value_type(signature.return_type))

        return pointer_type(item)(types.uintp), emit

    made: Callable[..., Any] = intrinsic(pointer)
    return made


_numba: Any = numba
carray = _numba.carray
_float_pointer = _pointer_to(types.float64)
_int_pointer = _pointer_to(types.int64)
_BYTES = 8


@inlined
def floats1(address: int, row: Indices) -> Array:
    """The array of one dimension whose begin and length are in a row."""
    view: Array = carray(_float_pointer(address + _BYTES * row[0]), (row[1],))
    return view


@inlined
def floats2(address: int, row: Indices) -> Array:
    """The array of two dimensions whose begin and lengths are in a row."""
    view: Array = carray(_float_pointer(address + _BYTES * row[0]), (row[1], row[2]))
    return view


@inlined
def floats3(address: int, row: Indices) -> Array:
    """The array of three dimensions whose begin and lengths are in a row."""
    view: Array = carray(_float_pointer(address + _BYTES * row[0]), (row[1], row[2], row[3]))
    return view


@inlined
def ints1(address: int, row: Indices) -> Indices:
    """As ``floats1``."""
    view: Indices = carray(_int_pointer(address + _BYTES * row[0]), (row[1],))
    return view


@inlined
def ints2(address: int, row: Indices) -> Indices:
    """As ``floats2``."""
    view: Indices = carray(_int_pointer(address + _BYTES * row[0]), (row[1], row[2]))
    return view


@inlined
def ints3(address: int, row: Indices) -> Indices:
    """As ``floats3``."""
    view: Indices = carray(_int_pointer(address + _BYTES * row[0]), (row[1], row[2], row[3]))
    return view
