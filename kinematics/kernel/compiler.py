"""The decorator under which every compiled function of this package stands."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar, cast

import numba

from kinematics.kernel import cache

_config: Any = numba.config
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
    folder = cache.folder()
    options: dict[str, Any] = {"error_model": "numpy", "forceinline": forceinline}
    if folder is None:
        return cast(F, numba.njit(**options)(function))
    before = _config.CACHE_DIR
    _config.CACHE_DIR = str(folder)
    try:
        return cast(F, numba.njit(cache=True, **options)(function))
    finally:
        _config.CACHE_DIR = before
