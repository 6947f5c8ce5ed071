"""An MCAP file that is written while things happen, and can be read as far as it goes whenever that ends."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from pathlib import Path

from mcap.writer import CompressionType, Writer

from executive.doors.ros.definitions import Message, definition_of

ABOUT = "executive"
"""Name of the metadata that tell whose run it is."""
_CHUNK_BYTES, _CHUNK_NS = 16 * 1024, 50_000_000
"""A chunk is written when it is so large or so old: what is not yet written is lost with the process.

A humanoid's is full sooner, a bare arm's takes half a second.
"""


class McapLog:
    """Messages of ROS 2, each at its topic and time.

    Args:
        path: Of the file; it is not there yet.
        about: Whose run it is.

    Raises:
        OSError: It cannot be made.
    """

    def __init__(self, path: Path, about: Mapping[str, str]) -> None:
        self._file = path.open("xb")
        self._writer = Writer(self._file, _CHUNK_BYTES, CompressionType.ZSTD)
        self._chunk_from_ns: int | None = None
        self._writer.start("ros2", "humanoid-executive")
        self._writer.add_metadata(ABOUT, dict(about))
        self._file.flush()
        self._written = self._file.tell()
        self._schemas: dict[str, int] = {}
        self._channels: dict[str, int] = {}
        self._counts: Counter[str] = Counter()

    def write(self, topic: str, message: Message, at_ns: int) -> None:
        """Write a message; each chunk that is full or old is handed to the operating system.

        Args:
            topic: Where ROS would have it.
            message: It, always of the same kind at one topic.
            at_ns: When, since 1970.

        Raises:
            OSError: The disk is full, or has gone.
        """
        channel = self._channels.get(topic)
        if channel is None:
            channel = self._channels[topic] = self._channel(topic, type(message))
        self._counts[topic] += 1
        if self._chunk_from_ns is None:
            self._chunk_from_ns = at_ns
        self._writer.add_message(channel, at_ns, message.serialize(), at_ns, self._counts[topic])
        if at_ns - self._chunk_from_ns >= _CHUNK_NS:
            # the library ends a chunk for its size alone, and has no way to ask for it
            self._writer._Writer__finalize_chunk()  # type: ignore[attr-defined]
        if (written := self._file.tell()) != self._written:
            self._written, self._chunk_from_ns = written, None
            self._file.flush()

    def close(self) -> None:
        """Write the index, by which a reader finds its way, and end.

        Raises:
            OSError: The disk is full, or has gone.
        """
        with self._file:
            self._writer.finish()  # type: ignore[no-untyped-call]

    def _channel(self, topic: str, kind: type[Message]) -> int:
        name, text = definition_of(kind)
        if name not in self._schemas:
            self._schemas[name] = self._writer.register_schema(name, "ros2msg", text.encode())
        return self._writer.register_channel(topic, "cdr", self._schemas[name])
