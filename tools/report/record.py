"""The record of a run, as ``docs/measured/records`` holds it: small, and all that the pages are made from."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, Literal

from pydantic import ValidationError

from executive.errors import UserError
from tools.documents.published import Published
from tools.report.machine import Place
from tools.report.runs import Kind, Run

FORMAT: Literal["humanoid-executive/measured/1"] = "humanoid-executive/measured/1"
COUNTS: Mapping[str, str] = {
    "false_success": "claimed, and not so",
    "false_failure": "so, and not claimed",
    "falls": "falls",
    "unwanted_contacts": "furniture or people touched",
}
"""Keys of a suite's document that are counts of episodes, and what a table calls them."""
_DIGITS = 5
_FAILED_SHOWN = 50


class BarRecord(Published):
    """One demand, and whether it was met."""

    name: str
    value: str
    limit: str
    met: bool


class MeasuredRecord(Published):
    """One run of the report."""

    format: Literal["humanoid-executive/measured/1"]
    """Says which form the record has."""
    name: str
    """What the row is called."""
    suite: str
    """Name of the suite; a page holds all runs of one."""
    kind: Kind
    """Episodes that are judged, a benchmark, or times as they grow."""
    command: str
    """What was run, from the folder of the sources."""
    quick: bool
    """Whether it was cut short to see that it runs: no claim."""
    place: Place
    """Where it was run."""
    seeds: tuple[int, int] | None
    """First and last seed, or None where it was not kept or there are none."""
    judged: int
    """Number of episodes, or of the texts or pictures that they are made of."""
    good: int | None
    """How many of them were good; None where a fault left nothing to be done, or the suite does not say."""
    counts: dict[str, int]
    """Numbers of episodes, by the key of ``COUNTS``."""
    failures: dict[str, int]
    """How many episodes failed for which kind of reason."""
    failed_seeds: list[Any]
    """Seeds of the first episodes that were not good."""
    bars: list[BarRecord]
    """The demands."""
    figures: dict[str, Any]
    """Other numbers; of a benchmark its whole document, of growing times their courses."""
    cost: dict[str, float]
    """Processor seconds an episode and the most memory of a worker, MB, where a journal tells them."""


def record_of(
    run: Run,
    command: str,
    document: Mapping[str, Any],
    cost: Mapping[str, float],
    place: Place,
    *,
    quick: bool,
) -> MeasuredRecord:
    """Sum a suite's document up.

    Args:
        run: What was run.
        command: As it was given.
        document: What the suite wrote by ``--json``.
        cost: What its journal tells of time and memory.
        place: Where it was run.
        quick: Whether it was cut short.
    """
    figures = dict(document.get("figures", {}) if run.kind == "episodes" else document)
    return MeasuredRecord(
        format=FORMAT,
        name=run.name,
        suite=run.suite,
        kind=run.kind,
        command=command,
        quick=quick,
        place=place,
        seeds=_seeds(document) if run.kind == "episodes" else None,
        judged=judged_in(document),
        good=good_in(document),
        counts={key: int(document[key]) for key in COUNTS if isinstance(document.get(key), int)},
        failures=document.get("failures", {}) if run.kind == "episodes" else {},
        failed_seeds=list(document.get("failed_seeds", ()))[:_FAILED_SHOWN],
        bars=[BarRecord(**bar) for bar in document.get("bars", ())],
        figures=_rounded(figures),
        cost=dict(cost),
    )


def _seeds(document: Mapping[str, Any]) -> tuple[int, int] | None:
    seed = document.get("seed")
    return None if seed is None else (seed, seed + max(int(document.get("episodes", 1)), 1) - 1)


def judged_in(document: Mapping[str, Any]) -> int:
    """Number of episodes that a document tells of, or of the texts or pictures that they are made of."""
    for key in ("texts", "pictures", "episodes"):
        if key in document:
            return int(document[key])
    return len(document.get("records", ()))


def good_in(document: Mapping[str, Any]) -> int | None:
    """How many were good; None where the suite does not say, or a fault left nothing to be done."""
    if "success_rate" not in document:
        records = document.get("records", ())
        if not records or not all("faults" in one for one in records):
            return None
        return sum(not one["faults"] for one in records)
    good = round(document["success_rate"] * judged_in(document))
    detail = document.get("episodes_detail", ())
    # suites that do not say ask for what can be done
    hopeless = not any(bool(one.get("recoverable", True)) for one in detail)
    return None if document.get("fault") is not None and not good and hopeless else good


def write(record: MeasuredRecord, folder: Path) -> Path:
    """Keep a record as ``NAME.json``; the same record gives the same bytes."""
    folder.mkdir(parents=True, exist_ok=True)
    file = folder / f"{record.name}.json"
    text = json.dumps(record.model_dump(mode="json"), sort_keys=True, ensure_ascii=False)
    beside = file.with_suffix(".part")  # a kill leaves the old one or the new one
    beside.write_text(text + "\n", "utf-8")
    beside.replace(file)
    return file


def read(file: Path) -> MeasuredRecord:
    """Read a record.

    Raises:
        UserError: It cannot be read, or is none; the line names the file and the place in it.
    """
    try:
        return MeasuredRecord.model_validate_json(file.read_text("utf-8"))
    except OSError as wrong:
        raise UserError(f"cannot read {file}: {wrong.strerror}") from None
    except ValidationError as wrong:
        first = wrong.errors()[0]
        place = ".".join(map(str, first["loc"])) or "it"
        raise UserError(f"{file}: {place}: {first['msg']}; expected a record of {FORMAT}") from None


def read_all(folder: Path) -> list[MeasuredRecord]:
    """The records of a folder, by name.

    Raises:
        UserError: One is none.
    """
    return [read(file) for file in sorted(folder.glob("*.json"))]


def _rounded(value: Any) -> Any:
    """Numbers to so many digits as anybody reads."""
    if isinstance(value, float):
        return float(f"{value:.{_DIGITS}g}")
    if isinstance(value, Mapping):
        return {key: _rounded(item) for key, item in value.items()}
    if isinstance(value, Sequence) and not isinstance(value, str):
        return [_rounded(item) for item in value]
    return value
