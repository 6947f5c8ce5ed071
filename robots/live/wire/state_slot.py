"""The newest state of the robot, in a file that both sides map into their memory.

A queue that is full keeps what is old and rejects what is new; a slot holds what is newest, however slowly
anybody reads. Layout, in the machine's byte order: eight bytes ``HXSTATE1``, a 64-bit counter that is odd
while the slot is being written, the number of the values that follow, then these values as 64-bit floats.
A reader copies the values and takes them when the counter was even and is the same afterwards.
"""

from __future__ import annotations

import mmap
import os
import struct
from pathlib import Path

import numpy as np

from kinematics.arrays import Array
from robots.live.wire.errors import ProtocolError

_MAGIC = b"HXSTATE1"
_HEAD = struct.Struct("=8sQQ")
_COUNTER = struct.Struct("=Q")
_COUNTER_AT = 8
_TRIES = 100
_MOST = 100_000


class StateSlotWriter:
    """The writing side of the shared state; one process has it."""

    def __init__(self, path: Path, count: int) -> None:
        """Make the slot for so many values, readable by this user alone."""
        path.unlink(missing_ok=True)
        size = _HEAD.size + 8 * count
        descriptor = os.open(path, os.O_CREAT | os.O_EXCL | os.O_RDWR | os.O_CLOEXEC, 0o600)
        try:
            os.ftruncate(descriptor, size)
            self._memory = mmap.mmap(descriptor, size)
        finally:
            os.close(descriptor)
        self._count = count
        self._counter = 0
        self._memory[: _HEAD.size] = _HEAD.pack(_MAGIC, 0, count)
        self._path = path

    def write(self, values: Array) -> None:
        """Put new values, shape (count,), in the place of the old ones."""
        if values.shape != (self._count,):
            raise ValueError(f"the slot holds {self._count} values, not {values.shape}")
        memory = self._memory
        _COUNTER.pack_into(memory, _COUNTER_AT, self._counter + 1)
        memory[_HEAD.size :] = values.tobytes()
        self._counter += 2
        _COUNTER.pack_into(memory, _COUNTER_AT, self._counter)

    def close(self) -> None:
        """Take the slot away."""
        self._memory.close()
        self._path.unlink(missing_ok=True)


class StateSlotReader:
    """The reading side of the shared state; there may be many."""

    def __init__(self, path: Path) -> None:
        """Map a slot.

        Raises:
            ProtocolError: There is none.
        """
        try:
            with path.open("rb") as file:
                self._memory = mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ)
        except (OSError, ValueError):
            raise ProtocolError(f"there is no state slot {path}") from None
        whole = len(self._memory) >= _HEAD.size
        magic, _, count = _HEAD.unpack_from(self._memory) if whole else (b"", 0, 0)
        if magic != _MAGIC or count > _MOST or len(self._memory) != _HEAD.size + 8 * count:
            raise ProtocolError(f"{path} is no state slot of this version")
        self._seen = 0

    def newest(self) -> Array | None:
        """The newest values, or None when there are none that were not read before."""
        memory = self._memory
        for _ in range(_TRIES):
            before = _COUNTER.unpack_from(memory, _COUNTER_AT)[0]
            if before == self._seen:
                return None
            if before % 2:
                continue
            copied = memory[_HEAD.size :]
            if _COUNTER.unpack_from(memory, _COUNTER_AT)[0] == before:
                self._seen = before
                return np.frombuffer(copied, dtype=np.float64)
        return None

    def close(self) -> None:
        """Let go of it."""
        self._memory.close()
