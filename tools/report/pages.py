"""The pages of ``docs/measured``, made from records alone: the same records give the same bytes."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from itertools import groupby

from tools.benchmark.document import in_page_order, page
from tools.benchmark.scaling_page import Course, scaling_page
from tools.documents.markdown import table
from tools.evaluate.harness.statistics import interval
from tools.report.record import COUNTS, MeasuredRecord
from tools.report.runs import RUNS, SCALING

SHORT = 100
"""Fewer episodes than this leave intervals too wide to compare with a demand of 97 %."""
_MANY = 1000
INDEX = "index.md"
BENCHMARKS = "benchmarks.md"
_UNKNOWN = "not kept"
NO_CLAIM = "**A quick run**, to see that everything runs: no claim of anything.\n"

_HEAD = """\
# Measured: {suite}

Made by `make report`; do not edit. *Good* is an episode in which the simulator's
truth says that what was asked for was done; in suites of stops, faults and doors, one that met every demand;
of hostile text, a text that was answered as it may be. A dash: the fault left nothing to be done, and what
counts is that nothing was claimed. In brackets: the 95 % interval of the share (Wilson). Other counts are
numbers of episodes.
"""
_SHORT_RUN = """\
**Short runs** of fewer than {short} episodes are among them: read the interval, not the share.
"""
_INDEX_HEAD = """\
# What was measured

Made by `make report`; do not edit. It runs every suite and makes these pages from the records beside them;
earlier results are in git. How an episode is drawn and judged: [honesty](../understand/honesty.md). How to
run a suite: [contributing](../../CONTRIBUTING.md#how-to-measure). In brackets: the 95 % interval of the share
(Wilson).
"""
_PICTURE = """\
![shares of good episodes with their intervals, a row for each run]({picture})
"""


def pages(records: Sequence[MeasuredRecord]) -> dict[str, str]:
    """Every page, by the name of its file.

    Args:
        records: Of one report.
    """
    made = {}
    episodes = [record for record in records if record.kind == "episodes"]
    by_suite = sorted(episodes, key=lambda record: (record.suite, record.name))
    for suite, rows in groupby(by_suite, key=lambda record: record.suite):
        made[f"{suite}.md"] = suite_page(suite, list(rows))
    benchmarks = [record for record in records if record.kind == "benchmark"]
    if benchmarks:
        told = _how([*benchmarks])
        made[BENCHMARKS] = "\n".join([page(in_page_order(one.figures for one in benchmarks)), told])
    for record in records:
        if record.kind == "scaling":
            text = scaling_page(
                [Course(**one) for one in record.figures["courses"]], record.figures["repeats"]
            )
            made[f"{SCALING}.md"] = "\n".join([text, _how([record])])
    made[INDEX] = index_page(by_suite, sorted(made)) + _left(records)
    return dict(sorted(made.items()))


def suite_page(suite: str, records: Sequence[MeasuredRecord]) -> str:
    """The page of one suite.

    Args:
        suite: Its name.
        records: Its runs.
    """
    parts = [_HEAD.format(suite=suite)]
    if any(record.quick for record in records):
        parts.append(NO_CLAIM)
    elif any(record.judged < SHORT for record in records):
        parts.append(_SHORT_RUN.format(short=SHORT))
    parts.append(_results(records, COUNTS))
    demands = [
        (record.name, bar.name, bar.value, bar.limit, "met" if bar.met else "**missed**")
        for record in records
        for bar in record.bars
    ]
    if demands:
        parts += ["## Demands\n", table(("run", "what", "measured", "demanded", ""), demands)]
    figures = [
        (record.name, key.replace("_", " "), f"{value:.4g}")
        for record in records
        for key, value in record.figures.items()
        if isinstance(value, int | float)
    ]
    if figures:
        parts += ["## Other numbers\n", table(("run", "what", "value"), figures)]
    failures = [(record.name, kind, str(n)) for record in records for kind, n in record.failures.items()]
    if failures:
        parts += ["## What went wrong\n", table(("run", "kind", "episodes"), failures)]
    return "\n".join([*parts, _how(records)])


def index_page(records: Sequence[MeasuredRecord], names: Sequence[str]) -> str:
    """The page that has every run in one table, and leads to the others.

    Args:
        records: Of suites of episodes.
        names: Of the other pages.
    """
    parts = [_INDEX_HEAD]
    if any(record.quick for record in records):
        parts.append(NO_CLAIM)
    if records:
        counts = {key: COUNTS[key] for key in ("false_success", "falls")}
        parts += [_PICTURE.format(picture="pictures/good.svg"), _results(records, counts, links=True)]
    others = [name for name in names if name in (BENCHMARKS, f"{SCALING}.md")]
    titles = {BENCHMARKS: "Benchmarks", f"{SCALING}.md": "How times grow"}
    parts.append("\n".join(f"- [{titles[name]}]({name})" for name in others))
    return "\n".join(parts).rstrip() + "\n"


def _left(records: Sequence[MeasuredRecord]) -> str:
    """The runs of a report that have no record yet."""
    there = {record.name for record in records}
    left = [run.name for run in RUNS if run.name not in there]
    return f"\nNot measured: {', '.join(left)}.\n" if left else ""


def _results(records: Sequence[MeasuredRecord], counts: Mapping[str, str], *, links: bool = False) -> str:
    told = {key: name for key, name in counts.items() if any(key in record.counts for record in records)}
    rows = [
        (
            f"[{record.name}]({record.suite}.md)" if links else record.name,
            str(record.judged),
            share(record),
            *(str(record.counts.get(key, "")) for key in told),
        )
        for record in records
    ]
    return table(("run", "episodes", "good", *told.values()), rows)


def share(record: MeasuredRecord) -> str:
    """How many were good, with the interval of their share; a dash where a fault left nothing to be done."""
    if record.good is None or not record.judged:
        return "–" if "false_success" in record.counts else ""
    low, high = interval(record.good, record.judged)
    digits = 0 if record.judged < _MANY else 2
    return f"{record.good} ({100 * low:.{digits}f}–{100 * high:.{digits}f} %)"


def _how(records: Iterable[MeasuredRecord]) -> str:
    """Where each run was made, with which command, seeds and cost."""
    head = (
        "run",
        "command",
        "seeds",
        "version",
        "sources",
        "machine",
        "processor time",
        "memory of a worker",
    )
    return "\n".join(["## How it was measured\n", table(head, map(_made, records))])


def _made(record: MeasuredRecord) -> tuple[str, ...]:
    place, cost = record.place, record.cost
    return (
        record.name,
        f"`{record.command}`",
        "–" if record.kind != "episodes" else _seeds(record),
        place.version,
        place.sources or _UNKNOWN,
        f"{place.machine}; {place.libraries}" if place.machine else _UNKNOWN,
        f"{cost['processor_s']:.0f} s an episode" if "processor_s" in cost else "",
        f"{cost['memory_mb']:.0f} MB" if "memory_mb" in cost else "",
    )


def _seeds(record: MeasuredRecord) -> str:
    if record.seeds is None:
        return _UNKNOWN
    first, last = record.seeds
    return str(first) if first == last else f"{first} to {last}"
