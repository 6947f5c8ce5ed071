"""Reads MCAP files as far as they go, and gives one that was cut off the end that every program expects."""

from __future__ import annotations

import os
import shutil
import struct
import tempfile
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import IO

import zstandard
from mcap.exceptions import McapError
from mcap.records import Channel, Footer, McapRecord, Message, Metadata, Schema
from mcap.stream_reader import CRCValidationError, StreamReader
from mcap.writer import CompressionType, Writer

from executive.errors import UserError


class UnreadableRecordingError(UserError):
    """A file that should hold the motion of a run, and does not."""

    def __init__(self, path: Path, why: str) -> None:
        super().__init__(f"{path}: {why}; a recording is an MCAP file, as `--record` and `export` make it")


def records(path: Path) -> Iterator[McapRecord]:
    """The records of a file in the order in which they were written, up to where it was cut off.

    Raises:
        UnreadableRecordingError: It cannot be read, or is no MCAP file.
    """
    try:
        with path.open("rb") as file:
            yield from _whole(file, path)
    except OSError as failed:
        raise UnreadableRecordingError(path, failed.strerror or str(failed)) from failed


def _whole(file: IO[bytes], path: Path) -> Iterator[McapRecord]:
    reader = StreamReader(file, validate_crcs=True, record_size_limit=path.stat().st_size)
    begun = False
    try:
        for record in reader.records:
            begun = True
            yield record
    except (McapError, CRCValidationError, ValueError, struct.error, zstandard.ZstdError) as cut_off:
        if not begun:
            raise UnreadableRecordingError(path, "it is no MCAP file") from cut_off


def mend(path: Path) -> bool:
    """Write the end of a file that has none; returns whether that was so.

    Raises:
        UnreadableRecordingError: It is no MCAP file.
        OSError: The mended file cannot be written.
    """
    kept = list(records(path))
    if any(isinstance(one, Footer) for one in kept):
        return False
    # another process may mend it at the same time
    number, name = tempfile.mkstemp(prefix=f".{path.name}.", suffix=".mended", dir=path.parent)
    whole = Path(name)
    try:
        with os.fdopen(number, "wb") as file:
            _write(kept, file)
        shutil.copymode(path, whole)
        whole.replace(path)
    except BaseException:
        whole.unlink(missing_ok=True)
        raise
    return True


def _write(kept: Iterable[McapRecord], file: IO[bytes]) -> None:
    """Write records anew, with the end that belongs behind them."""
    writer = Writer(file, compression=CompressionType.ZSTD)
    writer.start("ros2", "humanoid-executive")
    schemas: dict[int, int] = {}
    channels: dict[int, int] = {}
    for one in kept:
        if isinstance(one, Metadata):
            writer.add_metadata(one.name, one.metadata)
        elif isinstance(one, Schema) and one.id not in schemas:
            schemas[one.id] = writer.register_schema(one.name, one.encoding, one.data)
        elif isinstance(one, Channel) and one.id not in channels:
            schema = schemas[one.schema_id]
            channels[one.id] = writer.register_channel(one.topic, one.message_encoding, schema)
        elif isinstance(one, Message):
            writer.add_message(
                channels[one.channel_id], one.log_time, one.data, one.publish_time, one.sequence
            )
    writer.finish()  # type: ignore[no-untyped-call]
