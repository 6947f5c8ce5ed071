"""How a suite is run whose episodes give records with faults: progress, table, document, and verdict."""

from __future__ import annotations

import json
from collections.abc import Callable, Hashable, Mapping, Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any, Protocol, TypeVar

from rich.console import Console
from rich.table import Table

from tools.evaluate.harness.execution import Execution, run_each
from tools.evaluate.records import Bar

_SHOWN = 25


class Judged(Protocol):
    """One record."""

    @property
    def faults(self) -> tuple[str, ...]:
        """Which demands it broke."""
        ...


class Counted(Protocol):
    """What many records say together, as demands and numbers."""

    def bars(self) -> list[Bar]:
        """The demands."""
        ...

    def figures(self) -> Mapping[str, float]:
        """Numbers worth knowing."""
        ...


class Summarised(Counted, Protocol):
    """The same, and as the evaluation's document."""

    def to_json(self) -> dict[str, Any]:
        """The evaluation's document."""
        ...


Order = TypeVar("Order", bound=Hashable)
Record = TypeVar("Record", bound=Judged)


def run_record_suite(
    title: str,
    orders: Sequence[Order],
    run: Callable[[Order], Sequence[Record]],
    died: Callable[[Order], Sequence[Record]],
    summarise: Callable[[Sequence[Record]], Summarised],
    *,
    line: Callable[[Record], str],
    place: Callable[[Record], tuple[float, ...]],
    execution: Execution,
    document: Path | None,
    messages: Console,
) -> int:
    """Run every order; 0 when every demand is met, 1 when not.

    Args:
        title: Of the table, without the count.
        orders: What to run.
        run: Runs one order; importable by name.
        died: The records of an order whose process died.
        summarise: Makes the summary of all records.
        line: What is told of a record, when it comes and, if it has faults, at the end.
        place: Sorts the records.
        execution: Where, and what is kept.
        document: Where the JSON goes, or None.
        messages: Takes the progress.
    """
    records: list[Record] = []
    for found in run_each(orders, execution, run, died):
        for record in found:
            records.append(record)
            messages.print(f"{len(records)}: {line(record)}", markup=False, soft_wrap=True)
        bad = sum(bool(record.faults) for record in records)
        messages.print(f"{len(records)} records of {len(orders)} runs, {bad} with a fault")
    records.sort(key=place)
    summary = summarise(records)
    if document is not None:
        document.write_text(json.dumps(summary.to_json(), indent=1) + "\n", "utf-8")
    console = Console()
    console.print(_table(f"{title}: {len(records)}", summary))
    bad_ones = [record for record in records if record.faults]
    for record in bad_ones[:_SHOWN]:
        console.print(line(record)[:600], markup=False, soft_wrap=True)
    if len(bad_ones) > _SHOWN:
        console.print(f"and {len(bad_ones) - _SHOWN} more, all in the JSON")
    return 0 if all(bar.met for bar in summary.bars()) else 1


def document_of(suite: str, summary: Counted, records: Sequence[Any]) -> dict[str, Any]:
    """A summary of pictures as an evaluation's document.

    Args:
        suite: Its name.
        summary: What the records say together.
        records: Them, dataclasses.
    """
    return {
        "suite": suite,
        "bars": [asdict(bar) for bar in summary.bars()],
        "figures": summary.figures(),
        "records": [asdict(record) for record in records],
    }


def _table(title: str, summary: Summarised) -> Table:
    table = Table("", "measured", "demanded", "", title=title)
    for bar in summary.bars():
        table.add_row(bar.name, bar.value, bar.limit, "ok" if bar.met else "MISSED")
    table.add_section()
    for name, value in summary.figures().items():
        table.add_row(name.replace("_", " "), f"{value:g}", "", "")
    return table
