"""Bytes on a stream, cut into frames: a header of eight bytes, then what it says.

The header is ``b"HX"``, the protocol's version, the kind of frame, and the length of the payload as a
big-endian 32-bit number. A frame of another version, of an unknown kind or longer than its kind may be
is an error before any of it is stored.
"""

from __future__ import annotations

import struct
from collections.abc import Mapping
from dataclasses import dataclass
from enum import IntEnum

from robots.live.wire.errors import ProtocolError

VERSION = 1
MAGIC = b"HX"
_HEADER = struct.Struct(">2sBBI")


class FrameKind(IntEnum):
    """What the payload of a frame is: a message, a document."""

    MESSAGE = 0
    DOCUMENT = 1


MAX_BYTES: Mapping[FrameKind, int] = {FrameKind.MESSAGE: 65_536, FrameKind.DOCUMENT: 16_000_000}
"""A message has a few hundred bytes; a document holds half a minute of a humanoid's motion."""


@dataclass(frozen=True, slots=True)
class Frame:
    """One frame: its kind and its payload."""

    kind: FrameKind
    payload: bytes


def encode_frame(kind: FrameKind, payload: bytes) -> bytes:
    """The bytes of a frame.

    Raises:
        ProtocolError: The payload is longer than its kind may be.
    """
    if len(payload) > MAX_BYTES[kind]:
        raise ProtocolError(f"a {kind.name.lower()} of {len(payload)} bytes; at most {MAX_BYTES[kind]}")
    return _HEADER.pack(MAGIC, VERSION, kind, len(payload)) + payload


class FrameDecoder:
    """Puts frames together from what arrives; holds at most one unfinished frame.

    Args:
        documents: Whether documents may come; where they may not, no memory is spent on them.
    """

    def __init__(self, documents: bool = False) -> None:
        self.documents = documents
        self._buffer = bytearray()

    def feed(self, data: bytes) -> None:
        """Take what has arrived."""
        self._buffer += data

    def next(self) -> Frame | None:
        """The next complete frame, or None.

        Raises:
            ProtocolError: What arrived is no frame; the rest cannot be understood either.
        """
        buffer = self._buffer
        if len(buffer) < _HEADER.size:
            if not MAGIC.startswith(bytes(buffer[:2])):
                raise ProtocolError("no frame begins like that")
            return None
        magic, version, number, length = _HEADER.unpack_from(buffer)
        if magic != MAGIC:
            raise ProtocolError("no frame begins like that")
        if version != VERSION:
            raise ProtocolError(f"protocol version {version}; this side speaks {VERSION}")
        if number not in FrameKind.__members__.values():
            raise ProtocolError(f"no kind of frame has the number {number}")
        kind = FrameKind(number)
        if kind is FrameKind.DOCUMENT and not self.documents:
            raise ProtocolError("documents are for the commander alone")
        if length > MAX_BYTES[kind]:
            raise ProtocolError(f"a {kind.name.lower()} of {length} bytes; at most {MAX_BYTES[kind]}")
        if len(buffer) < _HEADER.size + length:
            return None
        payload = bytes(buffer[_HEADER.size : _HEADER.size + length])
        del buffer[: _HEADER.size + length]
        return Frame(kind, payload)
