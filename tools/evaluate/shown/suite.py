"""Suite ``shown``: packages that were shown to the robot, and what they are called on tables afterwards."""

from __future__ import annotations

import argparse
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from rich.console import Console

from robots.models.description import load_robot
from tools.evaluate.record_suite import document_of, run_record_suite
from tools.evaluate.records import Bar
from tools.evaluate.shown.judge import SCENES_A_SET, NameRecord, judged, stock, told

SHOWN_SUITE = "shown"
LEAST_RIGHT, MOST_WRONG = 0.90, 0.01


@dataclass(frozen=True, slots=True)
class ShownOrder:
    """Some tables with the packages of one set.

    Attributes:
        seed: Of the set and of the first table; the others follow.
        count: How many tables.
        robot: Who looks.
    """

    seed: int
    count: int
    robot: str


@dataclass(frozen=True, slots=True)
class TableRecord:
    """One table.

    Attributes:
        seed: Of the table.
        names: What its things were called.
        broken: What broke, or empty.
    """

    seed: int
    names: tuple[NameRecord, ...] = ()
    broken: str = ""

    @property
    def faults(self) -> tuple[str, ...]:
        """What is wrong with what was told."""
        wrong = {
            "broken": bool(self.broken),
            "wrong name": any(one.told and one.told != (one.name,) for one in self.names),
        }
        return tuple(name for name, is_so in wrong.items() if is_so)


@dataclass(frozen=True, slots=True)
class ShownSummary:
    """What many tables say together."""

    records: Sequence[TableRecord]

    def bars(self) -> list[Bar]:
        """The demands."""
        shares = self.figures()
        broken = sum(bool(record.broken) for record in self.records)
        right, wrong = shares["right"], shares["wrong"]
        return [
            Bar("right", f"{right:.1%}", f"≥ {LEAST_RIGHT:.0%}", right >= LEAST_RIGHT),
            Bar("wrong", f"{wrong:.2%}", f"≤ {MOST_WRONG:.0%}", wrong <= MOST_WRONG),
            Bar("broken tables", str(broken), "0", broken == 0),
        ]

    def figures(self) -> dict[str, float]:
        """Numbers worth knowing."""
        return told([one for record in self.records for one in record.names])

    def to_json(self) -> dict[str, Any]:
        """The evaluation's document."""
        return document_of(SHOWN_SUITE, self, self.records)


def run_shown(options: argparse.Namespace, messages: Console) -> int:
    """Judge tables, a new set of packages after each few; 0 when every demand is met, 1 when not."""
    orders = [
        ShownOrder(options.seed + i, min(SCENES_A_SET, options.episodes - i), options.robot)
        for i in range(0, options.episodes, SCENES_A_SET)
    ]
    return run_record_suite(
        "tables with packages that were shown",
        orders,
        judge_tables,
        lambda order: [_broken(order, "the process died")],
        ShownSummary,
        line=_line,
        place=lambda record: (record.seed,),
        execution=options.execution,
        document=options.json,
        messages=messages,
    )


def judge_tables(order: ShownOrder) -> list[TableRecord]:
    """The records of the tables of one set; what breaks becomes one."""
    try:
        robot = load_robot(order.robot)
        with tempfile.TemporaryDirectory() as place:
            shelf = stock(robot, order.seed, Path(place))
            return [
                TableRecord(seed, tuple(judged(robot, shelf, seed)))
                for seed in range(order.seed, order.seed + order.count)
            ]
    except Exception as broken:
        return [_broken(order, repr(broken))]


def _broken(order: ShownOrder, why: str) -> TableRecord:
    return TableRecord(order.seed, broken=why)


def _line(record: TableRecord) -> str:
    faults = f" {', '.join(record.faults).upper()}" if record.faults else ""
    right = sum(bool(one.name) and one.told == (one.name,) for one in record.names)
    count = sum(bool(one.name) for one in record.names)
    return f"seed {record.seed}:{faults} {record.broken} {right} of {count} named"
