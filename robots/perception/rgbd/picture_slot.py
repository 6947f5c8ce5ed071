"""The newest picture of a robot's camera, in a file, for programs that show it.

A picture takes the place of the one before in one step, so that a reader has a whole one, however slowly
it reads. Layout: one line of JSON with ``frame``, ``focal_px``, ``width_px``, ``height_px`` and ``stamp_s``;
then red, green and blue of each pixel, 8 bits each, row by row; then the depths, millimetres in 16 bits, low
byte first, 0 where nothing came back; then the end that every whole file has. Nothing is written that nobody
wants: who wants pictures holds a shared lock on a file beside, which ends with its process, however that
ends.
"""

from __future__ import annotations

import contextlib
import fcntl
import json
import os
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Sealed
from kinematics.whole_file import read_whole, write_whole
from robots.perception.rgbd.picture import Colors, Picture

_MOST_MM = 65535
_BYTES_A_PIXEL = 5
_HEAD_AT_MOST = 1000


@dataclass(frozen=True, slots=True)
class ShownPicture(Sealed):
    """A picture as it is shown.

    Attributes:
        frame: The camera's optical frame (z forward, x right, y down).
        focal_px: Focal length; pixels are square, and the axis goes through the middle.
        stamp_s: Control time when it was taken.
        color: Red, green, blue, shape (height, width, 3).
        depth_mm: Depth along the optical axis, 0 where nothing came back, shape (height, width).
    """

    frame: str
    focal_px: float
    stamp_s: float
    color: Colors
    depth_mm: NDArray[np.uint16]


class PictureSlotWriter:
    """The writing side; the process that draws has it.

    Args:
        path: Of the slot; a picture that was left there is taken away.
    """

    def __init__(self, path: Path) -> None:
        self._path = path
        path.unlink(missing_ok=True)

    def show(self, picture: Picture) -> None:
        """Put a picture in the slot, if somebody wants it and there is room."""
        if not self._is_wanted():
            return
        height, width = picture.depth_m.shape
        head = {
            "frame": picture.camera.frame,
            "focal_px": picture.camera.focal_px,
            "width_px": width,
            "height_px": height,
            "stamp_s": picture.stamp_s,
        }
        depth_mm = np.clip(np.rint(picture.depth_m * 1000.0), 0, _MOST_MM).astype("<u2")
        content = b"".join((json.dumps(head).encode(), b"\n", picture.color.tobytes(), depth_mm.tobytes()))
        with contextlib.suppress(OSError):  # who looks gets the next one
            write_whole(self._path, content)

    def close(self) -> None:
        """Take the slot away."""
        self._path.unlink(missing_ok=True)

    def _is_wanted(self) -> bool:
        try:
            lock = os.open(_wanted(self._path), os.O_RDONLY | os.O_CLOEXEC | os.O_NOFOLLOW)
        except OSError:
            return False
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            return True
        finally:
            os.close(lock)
        return False


class PictureSlotReader:
    """The reading side; there may be many, and the slot need not be there yet.

    Args:
        path: Of the slot.
    """

    def __init__(self, path: Path) -> None:
        self._path = path
        self._lock: int | None = None
        self._seen: tuple[int, int] | None = None

    def want(self, wanted: bool) -> None:
        """Say whether pictures are to be written.

        Raises:
            OSError: It cannot be said there.
        """
        if wanted and self._lock is None:
            flags = os.O_CREAT | os.O_RDONLY | os.O_CLOEXEC | os.O_NOFOLLOW
            self._lock = os.open(_wanted(self._path), flags, 0o600)
            fcntl.flock(self._lock, fcntl.LOCK_SH)
        elif not wanted and self._lock is not None:
            os.close(self._lock)
            self._lock = None

    def newest(self) -> ShownPicture | None:
        """The newest picture; None when there is none that was not read before, or it is not whole."""
        try:
            found = self._path.stat()
        except OSError:
            return None
        if (found.st_ino, found.st_mtime_ns) == self._seen:
            return None
        self._seen = found.st_ino, found.st_mtime_ns
        content = read_whole(self._path)
        return None if content is None else _picture(content)


def _wanted(path: Path) -> Path:
    return path.with_name(f"{path.name}.wanted")


def _picture(content: bytes) -> ShownPicture | None:
    end = content.find(b"\n", 0, _HEAD_AT_MOST)
    try:
        head = json.loads(content[: max(end, 0)])
        width, height = int(head["width_px"]), int(head["height_px"])
        frame, focal_px, stamp_s = str(head["frame"]), float(head["focal_px"]), float(head["stamp_s"])
    except (ValueError, KeyError, TypeError):
        return None
    pixels = width * height
    if min(width, height) < 1 or len(content) != end + 1 + _BYTES_A_PIXEL * pixels:
        return None
    color = np.frombuffer(content, np.uint8, 3 * pixels, end + 1).reshape(height, width, 3)
    depth_mm = np.frombuffer(content, "<u2", pixels, end + 1 + 3 * pixels).reshape(height, width)
    return ShownPicture(frame, focal_px, stamp_s, color, depth_mm)
