"""Kept files that tell whether they are whole: a checksum at the end of what was written.

A file that is kept from one process to the next can be cut short by a power failure or a full disk, or be
changed by somebody else. Whoever keeps one here gets back what was written, or nothing, and makes it anew.
"""

from __future__ import annotations

import contextlib
import os
import struct
import tempfile
import zlib
from pathlib import Path

_SEAL = struct.Struct("<8sQI")
_MAGIC = b"HXWHOLE1"


def write_whole(file: Path, content: bytes) -> None:
    """Put a file in its place, all of it or nothing.

    Raises:
        OSError: It cannot be written; nothing is left behind.
    """
    number, partial = tempfile.mkstemp(prefix=f".{file.name}.", suffix=".tmp", dir=file.parent)
    try:
        with os.fdopen(number, "wb") as out:
            out.write(content)
            out.write(_SEAL.pack(_MAGIC, len(content), zlib.crc32(content)))
        Path(partial).replace(file)
    except OSError:
        with contextlib.suppress(OSError):
            Path(partial).unlink()
        raise


def read_whole(file: Path) -> bytes | None:
    """What ``write_whole`` was given; None when the file is not there, cannot be read, or is damaged."""
    try:
        content = file.read_bytes()
    except OSError:
        return None
    size = len(content) - _SEAL.size
    if size < 0:
        return None
    magic, written, checksum = _SEAL.unpack_from(content, size)
    body = content[:size]
    return body if magic == _MAGIC and written == size and zlib.crc32(body) == checksum else None


def has_its_end(file: Path) -> bool:
    """Tell whether a file is there and as long as it was written, without reading the rest of it."""
    try:
        with file.open("rb") as opened:
            size = opened.seek(0, os.SEEK_END) - _SEAL.size
            if size < 0:
                return False
            opened.seek(size)
            magic, written, _ = _SEAL.unpack(opened.read())
    except (OSError, struct.error):
        return False
    return bool(magic == _MAGIC and written == size)
