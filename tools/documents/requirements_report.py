"""``python -m tools.documents.requirements_report``: which requirements are proven by a test, and which
are not.

The rows are those of ``docs/reference/requirements.md``. A row is proven when at least one test that carries
its id ran and every one that ran passed; skipped tests prove nothing. Those beside other programs run after
the others, one at a time: a browser or a node waits for a robot in real time.
"""

from __future__ import annotations

import argparse
import re
import sys
from collections import defaultdict
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path

import pytest
from rich.console import Console
from rich.table import Table

ROOT = Path(__file__).parents[2]
REQUIREMENTS, PEERS = ROOT / "docs" / "reference" / "requirements.md", ROOT / "tests" / "peers"
_ROW = re.compile(r"^\| (?P<id>[A-Z]+\d+) \| (?P<text>.+?) \|(?: (?P<more>.+?) \|)?$")


@dataclass(frozen=True, slots=True)
class Verdict:
    """What the tests say of one row.

    Attributes:
        name: The row's id.
        text: What the row demands.
        passed, failed, skipped: Numbers of tests that carry the id.
    """

    name: str
    text: str
    passed: int
    failed: int
    skipped: int

    @property
    def proven(self) -> bool:
        """Whether the row is shown to hold."""
        return self.passed > 0 and self.failed == 0

    @property
    def state(self) -> str:
        """In one word."""
        if self.failed:
            return "FAILS"
        if self.passed:
            return "proven"
        return "skipped" if self.skipped else "open"


class Collector:
    """A pytest plugin that counts the outcomes of tests by requirement."""

    def __init__(self) -> None:
        self.counts: dict[str, dict[str, int]] = defaultdict(lambda: {"passed": 0, "failed": 0, "skipped": 0})

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        """Count a test once: its call, or what went wrong around it."""
        if report.when == "call" or (report.when in ("setup", "teardown") and not report.passed):
            for key, name in report.user_properties:
                if key == "requirement":
                    self.counts[str(name)][report.outcome] += 1


def requirement_rows(text: str) -> dict[str, str]:
    """Ids and texts of the tables' rows, in order."""
    rows = {}
    for line in text.splitlines():
        match = _ROW.match(line)
        if match:
            rows[match["id"]] = match["text"] + (f": {match['more']}" if match["more"] else "")
    return rows


def verdicts(rows: Mapping[str, str], counts: Mapping[str, Mapping[str, int]]) -> list[Verdict]:
    """One verdict a row; ids that no row has come last, as failures of the marks themselves."""
    unknown = dict.fromkeys(sorted(set(counts) - set(rows)), "(no such requirement)")
    nothing = {"passed": 0, "failed": 0, "skipped": 0}
    found = [Verdict(name, text, **counts.get(name, nothing)) for name, text in rows.items()]
    return found + [Verdict(name, text, 0, 1, 0) for name, text in unknown.items()]


def print_table(found: Iterable[Verdict], console: Console) -> None:
    """Print the table and a closing line."""
    table = Table("id", "state", "tests", "requirement")
    shown = list(found)
    for verdict in shown:
        tests = verdict.passed + verdict.failed + verdict.skipped
        table.add_row(verdict.name, verdict.state, str(tests or ""), _shorten(verdict.text))
    console.print(table)
    proven = sum(verdict.proven for verdict in shown)
    console.print(f"{proven} of {len(shown)} requirements proven")


def _shorten(text: str, length: int = 90) -> str:
    return text if len(text) <= length else text[: length - 1].rsplit(" ", 1)[0] + " …"


def main() -> int:
    """Run the marked tests; 1 when one of them fails."""
    parser = argparse.ArgumentParser(
        prog="python -m tools.documents.requirements_report", description=__doc__
    )
    parser.add_argument("--jobs", type=int, default=2, help="processes that run tests")
    options = parser.parse_args()
    collector = Collector()
    usual = ["-q", "-m", "requirement", "--tb=line"]
    pytest.main([*usual, "-n", str(options.jobs), "--dist", "worksteal"], plugins=[collector])
    pytest.main([*usual, "--peers", str(PEERS)], plugins=[collector])
    found = verdicts(requirement_rows(REQUIREMENTS.read_text("utf-8")), collector.counts)
    print_table(found, Console(width=140))
    return 1 if any(verdict.failed for verdict in found) else 0


if __name__ == "__main__":
    sys.exit(main())
