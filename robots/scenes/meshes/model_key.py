"""The digest by which an object is known to be made of a mesh as it is now, in the way that is said."""

from __future__ import annotations

import hashlib
from pathlib import Path

from robots.scenes.meshes.up_axis import Up, name_of

VERSION = 1
"""Of the way in which objects are made: another one makes others of the same mesh."""


def digest_of(mesh: Path) -> str:
    """Of a mesh file.

    Raises:
        OSError: It cannot be read.
    """
    return hashlib.sha256(mesh.read_bytes()).hexdigest()


def model_key(digest: str, scale: float, up: Up, turn_rad: float) -> str:
    """Digest of a mesh and of what was said of it; as files round numbers."""
    told = (VERSION, digest, round(scale, 6), _rounded(name_of(up)), round(turn_rad, 6))
    return hashlib.sha256(repr(told).encode()).hexdigest()[:24]


def _rounded(up: str | list[float]) -> str | list[float]:
    return up if isinstance(up, str) else [round(value, 4) for value in up]
