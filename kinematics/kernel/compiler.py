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
    folder = cache.folder()
    if folder is None:
        return cast(F, numba.njit(error_model="numpy")(function))
    before = _config.CACHE_DIR
    _config.CACHE_DIR = str(folder)
    try:
        return cast(F, numba.njit(error_model="numpy", cache=True)(function))
    finally:
        _config.CACHE_DIR = before
