"""Keeps a process that builds one world after the other small.

Building a world reads and prepares some 50 MB of meshes: what that takes in passing stays with the C library,
which would use it for the next one, and the simulator keeps the prepared meshes to be quicker then. A process
that runs for long, beside others of its kind, gives both back. And half a compiler stays resident that only
loaded what was compiled before.
"""

from __future__ import annotations

import ctypes
import gc
import mmap
from pathlib import Path

import mujoco

_ARENA_MAX, _MMAP_THRESHOLD, _TRIM_THRESHOLD = -8, -3, -1
"""Of ``mallopt`` in the GNU C library."""
_LARGE_BYTES = 131_072
"""What is larger is asked of the system, and goes back to it at once; unless told, the C library raises that
by itself to 32 MB."""
_MAPS = Path("/proc/self/maps")
_COMPILERS = ("libllvmlite", "libLLVM")
"""Of the kernels, and of the shaders where OpenGL has no graphics card."""


def be_frugal() -> None:
    """From now on keep no prepared meshes, and give large memory back at once.

    A world takes 0.15 s longer to build then. It counts for the whole process; to call it again changes
    nothing. Other C libraries than the GNU one keep their own ways.
    """
    cache = mujoco.mj_getCache()
    mujoco.mj_clearCache(cache)
    mujoco.mj_setCacheCapacity(cache, 0)
    library = _c_library()
    if hasattr(library, "mallopt"):
        library.mallopt(_ARENA_MAX, 1)  # meshes are prepared by threads, each of which would keep its own
        library.mallopt(_MMAP_THRESHOLD, _LARGE_BYTES)
        library.mallopt(_TRIM_THRESHOLD, _LARGE_BYTES)


def give_back(*, garbage: bool = False) -> None:
    """Give the system what nobody uses.

    Args:
        garbage: Whether to look first for what only refers to itself, such as a world that has ended: that
            takes a tenth of a second.
    """
    if garbage:
        gc.collect()
    library = _c_library()
    if hasattr(library, "malloc_trim"):
        library.malloc_trim(0)


def make_room() -> None:
    """Before another world: give back the one that ended, and the compilers' pages."""
    let_go_of_compilers()
    give_back(garbage=True)  # a world that nobody holds any more is in no hurry to go by itself


def let_go_of_compilers() -> None:
    """Give the pages back that hold compilers' code, 50 MB each: they have done or loaded what was wanted.

    They are the file's own, unchanged, so that whoever calls a compiler again finds them there. Nothing
    happens where none is loaded, or the system has no list of mappings.
    """
    if not _MAPS.exists():
        return
    advise = _c_library().madvise
    for line in _MAPS.read_text().splitlines():
        where, allowed, *_, file = line.split(maxsplit=5)
        if allowed == "r-xp" and any(compiler in file for compiler in _COMPILERS):
            first, end = (int(address, 16) for address in where.split("-"))
            advise(ctypes.c_void_p(first), ctypes.c_size_t(end - first), mmap.MADV_DONTNEED)


def _c_library() -> ctypes.CDLL:
    return ctypes.CDLL(None)
