"""Arrays at the doors: numbers of one kind in one piece, and values that nobody can change any more.

Compiled code reads memory: it takes float64 in the machine's byte order, without gaps, and writeable, for to
its compiler a read-only array is another type, for which everything would be compiled anew. Whoever calls it
passes what he was given through ``as_float64``. A frozen value keeps what it holds through ``sealed``, a
private copy on memory that cannot be written.
"""

from __future__ import annotations

import functools
from dataclasses import fields
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kinematics.errors import InvalidArrayError

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

_FLOAT64 = np.dtype(np.float64)
_ARRAY_TYPES = frozenset({"Array", "Transform", "poses.Transform", "NDArray[np.float64]"})


def as_float64(values: ArrayLike, shape: tuple[int | None, ...] | None = None, what: str = "array") -> Array:
    """The same numbers as compiled code takes them: float64, in one piece, aligned, writeable.

    Args:
        values: Real numbers of any type and layout.
        shape: What the array has to have; None stands for any length. Any shape when left out.
        what: Names the array in an error.

    Returns:
        What was given, where it is so already; else a copy.

    Raises:
        InvalidArrayError: They are no real numbers, or have another shape.
    """
    if type(values) is np.ndarray and values.dtype is _FLOAT64 and values.flags.carray:
        found = values
    else:
        found = np.array(_real(values, what), _FLOAT64, order="C")
    if shape is not None and not _fits(found.shape, shape):
        wanted = ", ".join("n" if length is None else str(length) for length in shape)
        raise InvalidArrayError(what, f"has shape {found.shape}, not ({wanted}{',' * (len(shape) == 1)})")
    return found


def sealed(values: ArrayLike, what: str = "array") -> Array:
    """A private copy in float64 that nobody can change, its holder included.

    It lies on the memory of a ``bytes`` object, so that it can be made writeable neither by
    ``setflags`` nor through ``base``. What is sealed already is given back as it is.

    Raises:
        InvalidArrayError: They are no real numbers.
    """
    if type(values) is np.ndarray and values.dtype is _FLOAT64 and values.flags.c_contiguous:
        owner: object = values.base
        if type(owner) is bytes:
            return values
    found = np.asarray(_real(values, what), _FLOAT64)
    return np.ndarray(found.shape, _FLOAT64, found.tobytes())


class Sealed:
    """Base of frozen dataclasses that hold arrays of floats: each one is ``sealed`` when it is put in.

    What is annotated as ``Array`` or ``Transform``, or as one of them or None, is sealed. A class with a
    ``__post_init__`` of its own calls the one of this class first.
    """

    __slots__ = ()

    def __post_init__(self) -> None:
        kind: Any = type(self)
        for name in _array_fields(kind):
            value = getattr(self, name)
            if value is not None:
                object.__setattr__(self, name, sealed(value, name))

    def __reduce__(self) -> tuple[Any, ...]:
        """Made anew wherever it is sent or copied to: arrays that are read from a pickle are writeable."""
        kind: Any = type(self)
        return kind, tuple(getattr(self, field.name) for field in fields(kind) if field.init)


class InFloat64:
    """Base of frozen dataclasses that are made anew each control period: their arrays are ``as_float64``.

    They go to compiled code many times a period, and are not copied: who makes one lets its arrays alone.
    """

    __slots__ = ()

    def __post_init__(self) -> None:
        kind: Any = type(self)
        for name in _array_fields(kind):
            value = getattr(self, name)
            # nearly always it is so already, and this runs at 500 Hz
            if type(value) is np.ndarray and value.dtype is _FLOAT64 and value.flags.carray:
                continue
            if value is not None:
                object.__setattr__(self, name, as_float64(value, what=name))


@functools.cache
def _array_fields(kind: Any) -> tuple[str, ...]:
    return tuple(
        field.name
        for field in fields(kind)
        if isinstance(field.type, str) and field.type.removesuffix(" | None") in _ARRAY_TYPES
    )


def _real(values: ArrayLike, what: str) -> NDArray[Any]:
    try:
        found = np.asarray(values)
    except (TypeError, ValueError) as error:
        raise InvalidArrayError(what, f"is no array: {error}") from error
    if not np.can_cast(found.dtype, _FLOAT64, "same_kind"):
        raise InvalidArrayError(what, f"holds {found.dtype}, not real numbers")
    return found


def _fits(actual: tuple[int, ...], wanted: tuple[int | None, ...]) -> bool:
    return len(actual) == len(wanted) and all(
        length is None or length == found for found, length in zip(actual, wanted, strict=True)
    )
