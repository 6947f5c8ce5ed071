"""A motion as a file that somebody hands in: read whole, within bounds, told by its path when it is wrong."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TypeVar

from executive.errors import TrajectoryFileError
from kinematics.errors import TrajectoryDocumentError

Motion = TypeVar("Motion")


def read_motion_file(path: Path, most_bytes: int, read: Callable[[str], Motion]) -> Motion:
    """Read a document of a motion; a pipe is read as a file is.

    Args:
        path: Where it is.
        most_bytes: What is longer is not read.
        read: Makes the motion of the text, or raises ``TrajectoryDocumentError``.

    Raises:
        TrajectoryFileError: File, place and reason.
    """
    try:
        if path.stat().st_size > most_bytes:
            raise TrajectoryFileError(path, f"has more than {most_bytes} bytes")
        with path.open("rb") as file:
            content = file.read(most_bytes + 1)
    except OSError as failed:
        raise TrajectoryFileError(path, failed.strerror or "cannot be read") from failed
    if len(content) > most_bytes:  # a pipe has no size beforehand
        raise TrajectoryFileError(path, f"has more than {most_bytes} bytes")
    try:
        return read(content.decode("utf-8"))
    except UnicodeDecodeError as broken:
        raise TrajectoryFileError(path, "is not UTF-8 text") from broken
    except TrajectoryDocumentError as broken:
        raise TrajectoryFileError(path, str(broken)) from broken
