"""Where a run was made: the version and its sources, the machine, the libraries that decide."""

from __future__ import annotations

import hashlib
import importlib.metadata
import os
import platform
from pathlib import Path

from tools.documents.published import Published

ROOT = Path(__file__).parents[2]
_JUDGED = ("kinematics", "robots", "trees", "executive", "tools/evaluate", "tools/benchmark")
_SUFFIXES = frozenset({".py", ".toml", ".lark"})
_DIGITS = 12
_LIBRARIES = ("mujoco", "pin", "numpy")


class Place(Published):
    """Where a run was made."""

    version: str
    """Version of the product."""
    sources: str
    """The first digits of a digest of product and suites; empty where it was not kept."""
    machine: str
    """Kind of processor, and how many cores."""
    libraries: str
    """Versions of Python and of the libraries that decide."""


def here() -> Place:
    """This machine, with these sources."""
    versions = [f"Python {platform.python_version()}"]
    versions += [f"{name} {importlib.metadata.version(name)}" for name in _LIBRARIES]
    return Place(
        version=importlib.metadata.version("humanoid-executive"),
        sources=sources_digest(),
        machine=f"{_processor()}, {os.cpu_count()} cores",
        libraries=", ".join(versions),
    )


def sources_digest(root: Path = ROOT) -> str:
    """Digits that change when the product or a suite does.

    Args:
        root: Folder of the sources.
    """
    digest = hashlib.sha256()
    for package in _JUDGED:
        for file in sorted((root / package).rglob("*")):
            if file.suffix in _SUFFIXES and file.is_file():
                digest.update(f"{file.relative_to(root)}\0".encode())
                digest.update(file.read_bytes())
    return digest.hexdigest()[:_DIGITS]


def _processor() -> str:
    """What the system calls the processor."""
    info = Path("/proc/cpuinfo")
    if info.exists():
        for line in info.read_text("utf-8", errors="replace").splitlines():
            key, _, value = line.partition(":")
            if key.strip() == "model name" and value.strip():
                return " ".join(value.split())
    return platform.machine()
