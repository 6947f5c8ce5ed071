"""Where compiled code is kept: one folder for each state of the sources that it was made from.

Numba notices that a compiled function's own file changed, not that a function it calls did. The hash
of every source that compiled code is made from (see ``compiled_sources``), and of the compiler's version,
is therefore the folder's name: code that was compiled from other sources is never found. What counts is
the sources' content, not their place or time: a second checkout and an installed copy find what the
first one compiled.
"""

from __future__ import annotations

import contextlib
import importlib.metadata
import json
import platform
import shutil
from functools import cache
from hashlib import sha256
from pathlib import Path

from kinematics.compiled.compiled_sources import CompiledSources, package_of
from kinematics.whole_file import has_its_end, read_whole, write_whole

_PACKAGE = package_of(Path(__file__))
_COMPILER = Path(__file__).with_name("compiler.py")
_MARKER = "complete"
_CODE = "*.nb[ci]"
# Folders of other sources that are left: of other versions or checkouts in use.
_KEPT = 12


@cache
def source_key() -> str:
    """Hash of all sources of compiled code in this package's folders, and of what compiles them."""
    digest = sha256()
    for version in (
        platform.python_version(),
        *map(importlib.metadata.version, ("numba", "llvmlite", "numpy")),
    ):
        digest.update(version.encode() + b"\0")
    digest.update(_sources(_PACKAGE).digest(_covered()).encode())
    return digest.hexdigest()[:16]


@cache
def _sources(package: Path) -> CompiledSources:
    """Those of a package and of this one."""
    return CompiledSources({package, _PACKAGE}, _COMPILER)


@cache
def _covered() -> frozenset[Path]:
    return frozenset(_sources(_PACKAGE).compiled())


@cache
def folder() -> Path | None:
    """The folder of the present sources, made when it is not there; None when it cannot be written."""
    try:
        place = Path.home() / ".cache" / "humanoid-executive" / f"kernel-{source_key()}"
        place.mkdir(parents=True, exist_ok=True)
        probe = place / ".probe"
        probe.write_text("")
        probe.unlink(missing_ok=True)
    except (OSError, RuntimeError):
        return None
    return place


def place_of(source: Path) -> Path | None:
    """Where the code compiled from a source is kept; None when nothing can be written.

    Code of other packages has a place for each state of its source, so that two checkouts with the same
    kernel do not take each other's code away.
    """
    place = folder()
    if place is None:
        return None
    if source in _covered():
        return place / ".".join(source.parent.relative_to(_PACKAGE.parent).parts)
    return place / f"{source.parent.name}-{stamp_of(source)[:16]}"


@cache
def stamp_of(source: Path) -> str:
    """What must be the same for code compiled from a source to be found: a hash of all it is made from."""
    if source in _covered():
        return source_key()
    return _sources(package_of(source)).digest([source])


def mark_complete() -> None:
    """Note that everything that the present sources need is in the folder; drop the oldest folders."""
    place = folder()
    if place is None:
        return
    files = [file.relative_to(place).as_posix() for file in place.glob(f"{_PACKAGE.name}*/{_CODE}")]
    with contextlib.suppress(OSError):
        write_whole(place / _MARKER, json.dumps({"processor": _processor(), "files": sorted(files)}).encode())
    others = [other for other in place.parent.glob("kernel-*") if other != place]
    for old in sorted(others, key=lambda other: other.stat().st_mtime)[:-_KEPT]:
        shutil.rmtree(old, ignore_errors=True)


def is_complete() -> bool:
    """Tell whether everything was compiled for the present sources, on this kind of processor.

    Every file must be there, as long as it was written. What is in them is looked at when they are loaded:
    a function whose file is damaged is compiled anew.
    """
    place = folder()
    noted = None if place is None else read_whole(place / _MARKER)
    if place is None or noted is None:
        return False
    marker = json.loads(noted)
    return bool(
        marker["processor"] == _processor() and all(has_its_end(place / name) for name in marker["files"])
    )


def damaged() -> list[Path]:
    """Files of the present sources' folder that are not as they were written, or are gone; reads them all."""
    place = folder()
    if place is None:
        return []
    noted = read_whole(place / _MARKER)
    files = {place / name for name in json.loads(noted)["files"]} if noted else set()
    return sorted(file for file in files | set(place.glob(f"*/{_CODE}")) if read_whole(file) is None)


def drop_damaged() -> None:
    """Take away the files that are damaged, so that what they held counts as not compiled."""
    for file in damaged():
        with contextlib.suppress(OSError):
            file.unlink(missing_ok=True)


def _processor() -> str:
    """Whom the code was compiled for."""
    from llvmlite import binding

    return f"{binding.get_host_cpu_name()} {binding.get_host_cpu_features().flatten()}"
