"""Suite ``people-seen``: pictures of people, and what was told of them."""

from __future__ import annotations

import argparse
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any

from rich.console import Console

from robots.models.description import load_robot
from tools.evaluate.people_seen.judge import PersonRecord, judged, told
from tools.evaluate.record_suite import document_of, run_record_suite
from tools.evaluate.records import Bar

PEOPLE_SEEN_SUITE = "people-seen"
BARS: Mapping[str, float] = MappingProxyType(
    {"found": 0.95, "posture right": 0.90, "gesture right": 0.90, "clothes right of told": 0.85}
)
"""Least shares."""


@dataclass(frozen=True, slots=True)
class PeopleOrder:
    """One scene: its seed, and who looks."""

    seed: int
    robot: str


@dataclass(frozen=True, slots=True)
class PeopleRecord:
    """One picture.

    Attributes:
        seed: Of the scene.
        people: Those in it, and those who were told and are not there.
        broken: What broke, or empty.
    """

    seed: int
    people: tuple[PersonRecord, ...] = ()
    broken: str = ""

    @property
    def faults(self) -> tuple[str, ...]:
        """What is wrong with what was told."""
        wrong = {
            "broken": bool(self.broken),
            "not found": any(one.name and one.shown and not one.found for one in self.people),
            "somebody who is not there": any(not one.name for one in self.people),
        }
        return tuple(name for name, is_so in wrong.items() if is_so)


@dataclass(frozen=True, slots=True)
class PeopleSummary:
    """What many pictures say together."""

    records: Sequence[PeopleRecord]

    def bars(self) -> list[Bar]:
        """The demands."""
        shares = self.figures()
        broken = sum(bool(record.broken) for record in self.records)
        return [
            *(
                Bar(name, f"{shares[name]:.1%}", f"≥ {least:.0%}", shares[name] >= least)
                for name, least in BARS.items()
            ),
            Bar("broken pictures", str(broken), "0", broken == 0),
        ]

    def figures(self) -> dict[str, float]:
        """Numbers worth knowing."""
        return told([one for record in self.records for one in record.people])

    def to_json(self) -> dict[str, Any]:
        """The evaluation's document."""
        return document_of(PEOPLE_SEEN_SUITE, self, self.records)


def run_people_seen(options: argparse.Namespace, messages: Console) -> int:
    """Judge pictures; 0 when every demand is met, 1 when not."""
    return run_record_suite(
        "pictures of people",
        [PeopleOrder(options.seed + i, options.robot) for i in range(options.episodes)],
        judge_people,
        lambda order: [PeopleRecord(order.seed, broken="the process died")],
        PeopleSummary,
        line=_line,
        place=lambda record: (record.seed,),
        execution=options.execution,
        document=options.json,
        messages=messages,
    )


def judge_people(order: PeopleOrder) -> list[PeopleRecord]:
    """The record of one picture; what breaks becomes it."""
    try:
        return [PeopleRecord(order.seed, tuple(judged(load_robot(order.robot), order.seed)[0]))]
    except Exception as broken:
        return [PeopleRecord(order.seed, broken=repr(broken))]


def _line(record: PeopleRecord) -> str:
    faults = f" {', '.join(record.faults).upper()}" if record.faults else ""
    found = sum(one.found and bool(one.name) for one in record.people)
    count = sum(bool(one.name) for one in record.people)
    return f"seed {record.seed}:{faults} {record.broken} {found} of {count} people"
