"""The decorator under which every compiled function of this package stands."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar, cast

import numba
from numba.core import caching

from kinematics.kernel import cache

_caching: Any = caching
F = TypeVar("F", bound=Callable[..., Any])


def compiled(function: F) -> F:
    """Compile at the first call, or load from the folder of the present sources.

    Without fast-math, so that the same inputs give the same bits; a division by zero gives inf or
    nan, as in numpy.
    """
    return _compiled(function, forceinline=False)


def inlined(function: F) -> F:
    """As ``compiled``, and made part of whoever calls it.

    For what is small or called from one place: a call copies every array of a tuple that it is given,
    which takes longer than many of these functions do.
    """
    return _compiled(function, forceinline=True)


def _compiled(function: F, forceinline: bool) -> F:
    made: Any = numba.njit(error_model="numpy", forceinline=forceinline)(function)
    if cache.folder() is not None and hasattr(made, "_cache"):
        made._cache = _Kept(function)
    return cast(F, made)


class _Locator(_caching._CacheLocator):  # type: ignore[misc]
    """Finds what was compiled by the content of the sources, wherever and whenever they were written."""

    def __init__(self, source: Path, line: int) -> None:
        self._py_file = str(source)
        self._source, self._line = source, line

    @classmethod
    def from_function(cls, py_func: Any, _py_file: str) -> _Locator:
        """Of a function in a file."""
        return cls(Path(inspect.getfile(py_func)), py_func.__code__.co_firstlineno)

    def get_cache_path(self) -> str:
        """One folder for each package: file names repeat."""
        return str(cast(Path, cache.place_of(self._source.parent)))

    def get_source_stamp(self) -> str:
        """What must be the same for code to be found; the kernel's own sources name its folder."""
        return cache.stamp_of(self._source.parent)

    def get_disambiguator(self) -> str:
        """Tells functions of one name apart."""
        return str(self._line)


class _Implementation(_caching.CompileResultCacheImpl):  # type: ignore[misc]
    _locator_classes = (_Locator,)


class _Kept(_caching.FunctionCache):  # type: ignore[misc]
    _impl_class = _Implementation
