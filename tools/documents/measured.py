"""``python -m tools.documents.measured RECORDS FOLDER``: write a page for each suite that was measured.

``RECORDS`` holds JSON files as ``python -m tools.evaluate SUITE --json FILE`` wrote them. Those of one
suite, with and without faults, become one page; a row is called as its file is. Pages of other suites stay
as they are.
"""

from __future__ import annotations

import argparse
import importlib.metadata
import json
import sys
from collections import defaultdict
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from tools.documents.markdown import table
from tools.evaluate.harness.statistics import interval

FOLDER = Path(__file__).parents[2] / "docs" / "measured"
_INDEX = "index.md"
_MANY = 1000
# Fewer episodes than this leave intervals too wide to compare with a demand of 97 %.
SHORT = 100
_NEEDED = ("suite", "episodes")
_COUNTS = {
    "false_success": "claimed, and not so",
    "false_failure": "so, and not claimed",
    "falls": "falls",
    "unwanted_contacts": "furniture or people touched",
}

_PAGE_HEAD = """\
# Measured: {suite}

Made by `make evaluate` with version {version}; do not edit. *Good* is an episode in which the simulator's
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

One page for each suite, with its present result. `make evaluate` and `make benchmark` write them; nobody
edits them, and earlier results are in git. How an episode is drawn and judged:
[honesty](../understand/honesty.md). How to run a suite:
[contributing](../../CONTRIBUTING.md#how-to-measure).
"""


def suite_page(records: Mapping[str, Mapping[str, Any]]) -> str:
    """The page of one suite.

    Args:
        records: The suite's documents, by the name of their rows.
    """
    suite = next(iter(records.values()))["suite"]
    head = _PAGE_HEAD.format(suite=suite, version=importlib.metadata.version("humanoid-executive"))
    short = any(_judged(record) < SHORT for record in records.values())
    told = {key: name for key, name in _COUNTS.items() if any(key in record for record in records.values())}
    rows = [
        (name, str(_judged(record)), _good(record), *(str(record.get(key, "")) for key in told))
        for name, record in records.items()
    ]
    demands = [
        (name, bar["name"], bar["value"], bar["limit"], "met" if bar["met"] else "**missed**")
        for name, record in records.items()
        for bar in record.get("bars", ())
    ]
    parts = [head]
    if short:
        parts.append(_SHORT_RUN.format(short=SHORT))
    parts.append(table(("run", "episodes", "good", *told.values()), rows))
    if demands:
        parts += ["## Demands\n", table(("run", "what", "measured", "demanded", ""), demands)]
    return "\n".join(parts)


def _good(record: Mapping[str, Any]) -> str:
    """How many were good, with the interval of their share; a dash where a fault left nothing to be done."""
    if "success_rate" not in record:
        return ""
    judged = _judged(record)
    good = round(record["success_rate"] * judged)
    if (
        record.get("fault") is not None
        and not good
        and not any(map(_recoverable, record.get("episodes_detail", ())))
    ):
        return "–"
    low, high = interval(good, judged)
    digits = 0 if judged < _MANY else 2
    return f"{good} ({100 * low:.{digits}f}–{100 * high:.{digits}f} %)"


def _judged(record: Mapping[str, Any]) -> int:
    """Episodes, or the texts that they are made of."""
    return int(record.get("texts", record["episodes"]))


def _recoverable(episode: Mapping[str, Any]) -> bool:
    """Whether what was asked for could still be done; suites that do not say ask for what can be."""
    return bool(episode.get("recoverable", True))


def read_records(folder: Path) -> dict[str, dict[str, dict[str, Any]]]:
    """The documents of a folder, by suite and then by the file's name without its suffix.

    Raises:
        ValueError: A file is no record of episodes; the line names it and what it lacks.
    """
    suites: dict[str, dict[str, dict[str, Any]]] = defaultdict(dict)
    for file in sorted(folder.glob("*.json")):
        record = json.loads(file.read_text("utf-8"))
        lacking = [key for key in _NEEDED if key not in record]
        if lacking:
            raise ValueError(f"{file} is no record of episodes: it lacks {', '.join(lacking)}")
        suites[record["suite"]][file.stem] = record
    return suites


def measured_index(folder: Path = FOLDER) -> str:
    """The page that lists the others of a folder, each by its first heading."""
    titles = {
        file.name: file.read_text("utf-8").partition("\n")[0].removeprefix("# ").removeprefix("Measured: ")
        for file in sorted(folder.glob("*.md"))
        if file.name != _INDEX
    }
    return "\n".join([_INDEX_HEAD, *(f"- [{title}]({name})" for name, title in titles.items()), ""])


def main(arguments: Sequence[str] | None = None) -> int:
    """Write the pages; 2 for records that are none."""
    parser = argparse.ArgumentParser(prog="python -m tools.documents.measured", description=__doc__)
    parser.add_argument("records", type=Path)
    parser.add_argument("folder", type=Path)
    options = parser.parse_args(arguments)
    try:
        suites = read_records(options.records)
    except ValueError as wrong:
        print(f"error: {wrong}", file=sys.stderr)
        return 2
    for suite, records in suites.items():
        (options.folder / f"{suite}.md").write_text(suite_page(records), "utf-8")
    (options.folder / _INDEX).write_text(measured_index(options.folder), "utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
