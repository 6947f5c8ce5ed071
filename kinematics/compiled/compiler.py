"""The decorator under which every compiled function of this package stands."""

from __future__ import annotations

import contextlib
import inspect
import pickle
from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar, cast

import numba
from numba.core import caching

from kinematics.compiled import cache
from kinematics.whole_file import read_whole, write_whole

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
        return str(cast(Path, cache.place_of(self._source)))

    def get_source_stamp(self) -> str:
        """What must be the same for code to be found."""
        return cache.stamp_of(self._source)

    def get_disambiguator(self) -> str:
        """Tells functions of one name apart."""
        return str(self._line)


class _Implementation(_caching.CompileResultCacheImpl):  # type: ignore[misc]
    _locator_classes = (_Locator,)


class _WholeFiles(_caching.IndexDataCacheFile):  # type: ignore[misc]
    """An index and its files of code, each with a checksum: what is damaged counts as not there."""

    def save(self, key: Any, data: Any) -> None:
        """Keep code with what it is for: two processes may give two overloads the same file at once."""
        super().save(key, (key, data))

    def load(self, key: Any) -> Any:
        """The code for a key, or None; what another process put in its place counts as not there."""
        found = super().load(key)
        return found[1] if found is not None and found[0] == key else None

    def _load_index(self) -> dict[Any, str]:
        content = read_whole(Path(self._index_path))
        version, stamp, overloads = pickle.loads(content) if content is not None else (None, None, {})
        return overloads if (version, stamp) == (self._version, self._source_stamp) else {}

    def _save_index(self, overloads: dict[Any, str]) -> None:
        content = self._dump((self._version, self._source_stamp, overloads))
        write_whole(Path(self._index_path), content)

    def _load_data(self, name: str) -> Any:
        content = read_whole(Path(self._data_path(name)))
        return None if content is None else pickle.loads(content)

    def _save_data(self, name: str, data: Any) -> None:
        write_whole(Path(self._data_path(name)), self._dump(data))


class _Kept(_caching.FunctionCache):  # type: ignore[misc]
    _impl_class = _Implementation

    def __init__(self, function: Any) -> None:
        super().__init__(function)
        place = self._impl.locator
        self._cache_file = _WholeFiles(
            place.get_cache_path(), self._impl.filename_base, place.get_source_stamp()
        )

    def save_overload(self, sig: Any, data: Any) -> None:
        """Keep what was compiled; a full disk is no reason not to use it."""
        with contextlib.suppress(OSError):
            super().save_overload(sig, data)
