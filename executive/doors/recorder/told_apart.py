"""How a run in lockstep tells the process that records it what goes on: frames through a pipe.

A frame is one byte that says what it holds, four that say how long it is, low byte first, and that. A state
is a row of 64-bit floats in the machine's byte order; everything else is JSON.
"""

from __future__ import annotations

import json
import struct
from collections.abc import Iterator
from typing import IO, Any

import numpy as np

from kinematics.arrays import Array

STATE, EVENT, TREE, WORLD = b"S", b"E", b"T", b"W"
_HEAD = struct.Struct("<cI")


def state_frame(row: Array) -> bytes:
    """The frame of a state."""
    return _HEAD.pack(STATE, row.nbytes) + row.tobytes()


def json_frame(kind: bytes, value: object) -> bytes:
    """The frame of anything else."""
    text = json.dumps(value).encode()
    return _HEAD.pack(kind, len(text)) + text


def frames(stream: IO[bytes]) -> Iterator[tuple[bytes, Any]]:
    """What comes through a pipe until it ends: what each frame holds, and that; half a frame is left out."""
    while len(head := stream.read(_HEAD.size)) == _HEAD.size:
        kind, size = _HEAD.unpack(head)
        content = stream.read(size)
        if len(content) < size:
            return
        yield kind, np.frombuffer(content) if kind == STATE else json.loads(content)
