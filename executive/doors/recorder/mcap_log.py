"""An MCAP file that is written while things happen, and can be read as far as it goes whenever that ends."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from pathlib import Path

from mcap.writer import CompressionType, Writer

from executive.doors.ros.definitions import Message, definition_of

ABOUT = "executive"
"""Name of the metadata that tell whose run it is."""
_CHUNK_BYTES = 16 * 1024
"""A robot fills one in less than 0.1 s; what is not yet in one is lost where the process is killed."""


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
        self._writer.start("ros2", "humanoid-executive")
        self._writer.add_metadata(ABOUT, dict(about))
        self._file.flush()
        self._written = self._file.tell()
        self._schemas: dict[str, int] = {}
        self._channels: dict[str, int] = {}
        self._counts: Counter[str] = Counter()

    def write(self, topic: str, message: Message, at_ns: int) -> None:
        """Write a message; each chunk that is full is handed to the operating system.

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
        self._writer.add_message(channel, at_ns, message.serialize(), at_ns, self._counts[topic])
        if (written := self._file.tell()) != self._written:
            self._written = written
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
