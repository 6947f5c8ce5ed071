"""Where compiled code is kept: one folder for each state of this package's sources.

Numba notices that a compiled function's own file changed, not that a function it calls did. The hash
of every source of the package that compiled code is made from, and of the compiler's version, is
therefore the folder's name: code that was compiled from other sources is never found. What counts is
the sources' content, not their place or time: a second checkout and an installed copy find what the
first one compiled.
"""

from __future__ import annotations

import hashlib
import importlib.metadata
import json
import platform
import re
import shutil
from functools import cache
from pathlib import Path

_SOURCES = Path(__file__).parent
_MARKER = "complete.json"
# What a source with compiled code imports.
_COMPILES = b"kernel.compiler import"
_IMPORTED = re.compile(rb"^ *from kinematics\.kernel\.(\w+) import", re.MULTILINE)
# Folders of other sources that are left: of other versions or checkouts in use.
_KEPT = 12


@cache
def source_key() -> str:
    """Hash of this package's sources and of what compiles them."""
    digest = hashlib.sha256()
    for version in (
        platform.python_version(),
        *map(importlib.metadata.version, ("numba", "llvmlite", "numpy")),
    ):
        digest.update(version.encode() + b"\0")
    for source in _compiled_sources():
        digest.update(source.name.encode() + b"\0" + source.read_bytes() + b"\0")
    return digest.hexdigest()[:16]


def _compiled_sources() -> list[Path]:
    """Sources of this package with compiled code, and all that they import from it, in order of name."""
    content = {source.stem: source.read_bytes() for source in _SOURCES.glob("*.py")}
    needed: set[str] = set()
    more = {name for name, text in content.items() if _COMPILES in text}
    while more:
        needed |= more
        found = {match.decode() for name in more for match in _IMPORTED.findall(content[name])}
        more = (found & content.keys()) - needed
    return [_SOURCES / f"{name}.py" for name in sorted(needed)]


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


def place_of(package: Path) -> Path | None:
    """Where the code compiled from one folder of sources is kept; None when nothing can be written.

    Code beside the kernel has a place for each state of its sources, so that two checkouts with the same
    kernel do not take each other's code away.
    """
    place = folder()
    if place is None:
        return None
    return place / (package.name if package == _SOURCES else f"{package.name}-{stamp_of(package)[:16]}")


def mark_complete() -> None:
    """Note that everything that the present sources need is in the folder; drop the oldest folders."""
    place, beside = folder(), place_of(_SOURCES.parent)
    if place is None or beside is None:
        return
    beside.mkdir(parents=True, exist_ok=True)
    (beside / _MARKER).write_text(json.dumps(_stamp()))
    _keep_few(place.parent, "kernel-*", place)
    _keep_few(place, f"{_SOURCES.parent.name}-*", beside)


def _keep_few(parent: Path, pattern: str, present: Path) -> None:
    """Drop the oldest folders but some and the present one."""
    others = [other for other in parent.glob(pattern) if other != present]
    for old in sorted(others, key=lambda other: other.stat().st_mtime)[:-_KEPT]:
        shutil.rmtree(old, ignore_errors=True)


def is_complete() -> bool:
    """Tell whether everything was compiled for the present sources, on this kind of processor."""
    beside = place_of(_SOURCES.parent)
    if beside is None:
        return False
    try:
        return bool(json.loads((beside / _MARKER).read_text()) == _stamp())
    except (OSError, ValueError):
        return False


@cache
def stamp_of(folder_of_sources: Path) -> str:
    """Hash of all sources in a folder that hold compiled code: one may call what another defines."""
    digest = hashlib.sha256()
    for source in sorted(folder_of_sources.glob("*.py")):
        content = source.read_bytes()
        if _COMPILES in content:
            digest.update(source.name.encode() + b"\0" + content + b"\0")
    return digest.hexdigest()


def _stamp() -> dict[str, object]:
    """Whom the code was compiled for, and the sources outside of this package that were compiled, too."""
    from llvmlite import binding

    features = binding.get_host_cpu_features().flatten()
    return {
        "beside": stamp_of(_SOURCES.parent),
        "processor": f"{binding.get_host_cpu_name()} {features}",
    }
