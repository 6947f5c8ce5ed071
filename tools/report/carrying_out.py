"""Carries one run of the report out, in a process of its own; what was there of it before is gone on with."""

from __future__ import annotations

import json
import math
import shlex
import subprocess
import sys
import threading
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from statistics import fmean
from typing import Any

from executive.errors import UserError
from robots.clock import WallClock
from tools.documents.episode_document import EpisodeDocument
from tools.evaluate.harness.journal import episodes_of
from tools.report import record as records
from tools.report.machine import ROOT, Place
from tools.report.record import MeasuredRecord, record_of
from tools.report.runs import Run

QUICK_WITHIN_S = 300.0
"""A run that is cut short to one episode is given up after this."""
_ENDS_WITHIN_S = 30.0
_LOOKS_EVERY_S = 0.5
_JUDGED = (0, 1)
"""Exit codes of a suite that ran: every demand met, or not."""


@dataclass(frozen=True, slots=True)
class Settings:
    """How all runs of a report are carried out.

    Attributes:
        work: Folder for journals, logs and what is through already; that of these sources alone.
        place: Where they are run.
        jobs: Number of processes of a run that takes several.
        quick: Whether each is cut short to one episode.
        seed: Of the first episode.
        episodes: Number of episodes instead of a run's own, or None.
        ending: Set when everything has to end: what is under way is ended tidily.
    """

    work: Path
    place: Place
    jobs: int = 1
    quick: bool = False
    seed: int = 0
    episodes: int | None = None
    ending: threading.Event = field(default_factory=threading.Event)


class NotMeasuredError(Exception):
    """A run that could not be carried out, with the reason that it gave."""


def carry_out(run: Run, settings: Settings) -> MeasuredRecord:
    """Run it, unless its record is there already; a journal that a kill has left is gone on with.

    Raises:
        NotMeasuredError: It ended without a result.
    """
    command = told_command(run, settings)
    before = settings.work / "records" / f"{run.name}.json"
    if before.exists():
        there = records.read(before)
        if there.command == command and there.quick == settings.quick:
            return there
    result, journal = settings.work / f"{run.name}.json", settings.work / f"{run.name}.jsonl"
    more = ["--json", str(result)]
    if run.kind == "episodes":
        more += ["--jobs", str(settings.jobs), "--failed", str(settings.work / "failed" / run.name)]
    if not run.is_in_a_row:
        more += ["--journal", str(journal), "--resume"]
    result.unlink(missing_ok=True)
    _run([sys.executable, *shlex.split(command)[1:], *more], settings, run.name, result)
    document = json.loads(result.read_text("utf-8"))
    cost = cost_in(journal) if not run.is_in_a_row and journal.exists() else {}
    found = record_of(run, command, document, cost, settings.place, quick=settings.quick)
    records.write(found, settings.work / "records")
    return found


def told_command(run: Run, settings: Settings) -> str:
    """The command of a run as anybody gives it, from the folder of the sources."""
    if run.kind == "scaling":
        return f"python -m tools.benchmark.scaling --repeats {1 if settings.quick else run.options[-1]}"
    if run.kind == "benchmark":
        return f"python -m tools.benchmark {run.suite}{' --quick' if settings.quick else ''}"
    count = 1 if settings.quick else settings.episodes or run.episodes
    told = [run.suite, "--episodes", str(count), "--seed", str(settings.seed), *run.options]
    return f"python -m tools.evaluate {shlex.join(told)}"


def cost_in(journal: Path) -> Mapping[str, float]:
    """Processor seconds an episode, and the most memory of a worker in MB, as a journal tells them.

    Raises:
        UserError: It is no journal.
    """
    costs = [line.cost for line in _lines(journal) if line.cost.processor_s > 0.0]
    if not costs:
        return {}
    return {
        "processor_s": round(fmean(cost.processor_s for cost in costs), 1),
        "memory_mb": round(max(cost.memory_mb for cost in costs), 1),
    }


def _lines(journal: Path) -> list[EpisodeDocument]:
    return list(episodes_of(journal))


def _run(command: list[str], settings: Settings, name: str, result: Path) -> None:
    settings.work.mkdir(parents=True, exist_ok=True)
    log = settings.work / f"{name}.log"
    within_s = QUICK_WITHIN_S if settings.quick else math.inf
    with log.open("wb") as out, subprocess.Popen(command, cwd=ROOT, stdout=out, stderr=out) as process:
        try:
            code = _waited_for(process, within_s, settings.ending)
        finally:
            if process.poll() is None:
                _end(process)
    if code is None:
        raise NotMeasuredError(f"not through after {within_s:.0f} s (see {log})")
    if code not in _JUDGED or not result.exists():
        raise NotMeasuredError(f"{_last_line(log)} (exit code {code}, see {log})")


def _waited_for(process: subprocess.Popen[Any], within_s: float, ending: threading.Event) -> int | None:
    """The exit code; None when it was not through in time, or everything is to end."""
    clock = WallClock()
    while clock.now_s() < within_s and not ending.is_set():
        try:
            return process.wait(_LOOKS_EVERY_S)
        except subprocess.TimeoutExpired:
            continue
    return None


def _end(process: subprocess.Popen[Any]) -> None:
    """End it tidily: what it began goes with it, what it kept stays."""
    process.terminate()
    try:
        process.wait(_ENDS_WITHIN_S)
    except subprocess.TimeoutExpired:
        process.kill()


def _last_line(log: Path) -> str:
    lines = log.read_text("utf-8", errors="replace").strip().splitlines()
    return lines[-1] if lines else "it said nothing"


def known_records(folder: Path) -> dict[str, MeasuredRecord]:
    """The records of a folder by their names, in order; empty when it is not there.

    Raises:
        UserError: A file of it is no record.
    """
    found = {record.name: record for record in records.read_all(folder)} if folder.is_dir() else {}
    if any(file.stem not in found for file in folder.glob("*.json")):
        raise UserError(f"{folder}: a record is called otherwise than its file")
    return dict(sorted(found.items()))
