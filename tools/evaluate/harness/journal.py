"""The file of a suite's records: a line for each episode as it ends, never written over.

A kill loses at most the line that was being written: whoever goes on leaves half a line out. A line says all
that is needed to read it alone; its JSON schema is published (``schemas/episode.schema.json``).
"""

from __future__ import annotations

import argparse
import dataclasses
import enum
import json
import os
from collections.abc import Callable, Hashable, Iterator, Mapping, Sequence
from functools import partial
from pathlib import Path
from types import MappingProxyType
from typing import Any, Generic, TypeVar, get_type_hints

from pydantic import TypeAdapter, ValidationError

from executive.errors import UserError
from tools.documents.episode_document import EPISODE_FORMAT, EpisodeDocument
from tools.evaluate.harness.worker_pool import Cost

_TOLD: Mapping[str, object] = MappingProxyType(
    {
        "robot": "talos",
        **dict.fromkeys(("fault", "scene", "course", "perception", "light", "own")),
        "cameras": 1,
    }
)
"""Options of which another value than the usual one makes other episodes."""

Order = TypeVar("Order", bound=Hashable)
Record = TypeVar("Record")


class Journal(Generic[Order, Record]):
    """The records of one run of a suite.

    Args:
        file: Where they are kept; made when the first one comes.
        suite: Name of the suite.
        version: Version of the product, told in each line.
        run: What runs an order: its return type tells how a record is read again.
    """

    def __init__(self, file: Path, suite: str, version: str, run: Callable[[Order], Record]) -> None:
        self._file, self._suite, self._version = file, suite, version
        self._reader: TypeAdapter[Record] = TypeAdapter(_answer_of(run))

    def past(self, orders: Sequence[Order]) -> Iterator[tuple[Order, Record]]:
        """The records that the file holds of some orders, each once.

        Raises:
            UserError: The file cannot be read, or is no journal of this suite.
        """
        wanted = {_key(order): order for order in orders}
        for number, line in enumerate(episodes_of(self._file) if self._file.exists() else (), 1):
            if line.suite != self._suite:
                raise UserError(
                    f"{self._file}, episode {number}: of suite {line.suite}; expected one of {self._suite}"
                )
            order = wanted.pop(json.dumps(line.order, sort_keys=True), None)
            if order is None:
                continue
            try:
                yield order, self._reader.validate_python(line.record)
            except ValidationError as wrong:
                first = wrong.errors()[0]
                place = ".".join(map(str, first["loc"]))
                raise UserError(f"{self._file}, episode {number}: record.{place}: {first['msg']}") from None

    def add(self, order: Order, record: Record, cost: Cost) -> None:
        """Keep a record: one write of one line, so that a kill never mixes two."""
        line = {
            "format": EPISODE_FORMAT,
            "suite": self._suite,
            "version": self._version,
            "order": _plain(order),
            "good": is_good(record),
            "record": _plain(record),
            "cost": _plain(cost),
        }
        self._file.parent.mkdir(parents=True, exist_ok=True)
        # half a line that a kill has left ends here
        start = "" if not self._file.exists() or self._ends_whole() else "\n"
        with self._file.open("ab", buffering=0) as out:
            out.write(f"{start}{json.dumps(line)}\n".encode())

    def _ends_whole(self) -> bool:
        with self._file.open("rb") as file:
            if file.seek(0, os.SEEK_END) == 0:
                return True
            file.seek(-1, os.SEEK_END)
            return file.read() == b"\n"


def episodes_of(file: Path) -> Iterator[EpisodeDocument]:
    """The episodes that a journal holds, in the order in which they came; a line that a kill has cut is none.

    Raises:
        UserError: It cannot be read, or is no journal.
    """
    try:
        rows = file.read_text("utf-8", errors="replace").splitlines()
    except OSError as wrong:
        raise UserError(f"cannot read {file}: {wrong.strerror}") from None
    for number, row in enumerate(rows, 1):
        try:
            line = json.loads(row)
        except json.JSONDecodeError:
            continue
        try:
            yield EpisodeDocument.model_validate(line)
        except ValidationError as wrong:
            first = wrong.errors()[0]
            place = ".".join(map(str, first["loc"])) or "it"
            raise UserError(
                f"{file}, line {number}: {place}: {first['msg']}; expected a line of {EPISODE_FORMAT}"
            ) from None


def is_good(record: object) -> bool:
    """Whether a record, or each of several, met every demand on its episode."""
    if isinstance(record, Sequence):
        return all(map(is_good, record))
    if hasattr(record, "faults"):
        return not record.faults
    if hasattr(record, "bad"):
        return not record.bad
    return not getattr(record, "broken", "")


def journal_of(options: argparse.Namespace) -> Path:
    """The file of a suite with these options: the one that is named, or one whose name tells them."""
    if options.journal is not None:
        return Path(options.journal)
    told = [options.suite, f"seed{options.seed}", f"x{options.episodes}"]
    for name, usual in _TOLD.items():
        value = getattr(options, name)
        if value != usual:
            told.append(f"{name}-{Path(value).stem if name == 'scene' else value}")
    return Path(options.failed) / ("-".join(told) + ".jsonl")


def set_aside(file: Path) -> Path | None:
    """Call a file that is there by a name of its own, ``NAME.1.jsonl`` and so on; its new name, if any."""
    if not file.exists():
        return None
    number = 1
    while (aside := file.with_suffix(f".{number}{file.suffix}")).exists():
        number += 1
    file.rename(aside)
    return aside


def _answer_of(run: Callable[..., Any]) -> Any:
    while isinstance(run, partial):
        run = run.func
    return get_type_hints(run)["return"]


def _key(order: Hashable) -> str:
    return json.dumps(_plain(order), sort_keys=True)


def _plain(value: Any) -> Any:
    """As JSON holds a value of dataclasses; ``json`` writes infinities and NaN as Python reads them."""
    if dataclasses.is_dataclass(value) and not isinstance(value, type):
        return {field.name: _plain(getattr(value, field.name)) for field in dataclasses.fields(value)}
    if isinstance(value, enum.Enum):
        return _plain(value.value)
    if isinstance(value, Mapping):
        return {str(key): _plain(item) for key, item in value.items()}
    if isinstance(value, Sequence) and not isinstance(value, str):
        return [_plain(item) for item in value]
    if hasattr(value, "item"):  # a number of numpy
        return value.item()
    if isinstance(value, Path):
        return str(value)
    return value
