"""Where compiled code is kept: one folder for each state of this package's sources.

Numba notices that a compiled function's own file changed, not that a function it calls did. The hash
of every source of the package, and of the compiler's version, is therefore the folder's name: code
that was compiled from other sources is never found.
"""

from __future__ import annotations

import hashlib
import importlib.metadata
import json
import platform
import shutil
from functools import cache
from pathlib import Path

_SOURCES = Path(__file__).parent
# Folders of other sources that are left: of other versions or checkouts in use.
_KEPT = 5


@cache
def source_key() -> str:
    """Hash of this package's sources and of what compiles them."""
    digest = hashlib.sha256()
    for version in (
        platform.python_version(),
        *map(importlib.metadata.version, ("numba", "llvmlite", "numpy")),
    ):
        digest.update(version.encode() + b"\0")
    for source in sorted(_SOURCES.glob("*.py")):
        digest.update(source.name.encode() + b"\0" + source.read_bytes() + b"\0")
    return digest.hexdigest()[:16]


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


def mark_complete() -> None:
    """Note that everything that the present sources need is in the folder; drop the oldest folders."""
    place = folder()
    if place is None:
        return
    _marker(place).write_text(json.dumps(_stamp()))
    others = [other for other in place.parent.glob("kernel-*") if other != place]
    for old in sorted(others, key=lambda other: other.stat().st_mtime)[:-_KEPT]:
        shutil.rmtree(old, ignore_errors=True)


def is_complete() -> bool:
    """Tell whether everything was compiled for the present sources, on this kind of processor."""
    place = folder()
    if place is None:
        return False
    try:
        return bool(json.loads(_marker(place).read_text()) == _stamp())
    except (OSError, ValueError):
        return False


def _marker(place: Path) -> Path:
    """One for each place of the sources: an installed copy must not unmake a checkout's."""
    return place / f"complete-{hashlib.sha256(str(_SOURCES.resolve()).encode()).hexdigest()[:12]}.json"


def _stamp() -> dict[str, object]:
    """What numba compares beside the sources: their place and times, and the processor."""
    from llvmlite import binding

    files = {source.name: source.stat().st_mtime for source in sorted(_SOURCES.glob("*.py"))}
    features = binding.get_host_cpu_features().flatten()
    return {
        "place": str(_SOURCES.resolve()),
        "files": files,
        "processor": f"{binding.get_host_cpu_name()} {features}",
    }
