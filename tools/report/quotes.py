"""What the README quotes of the report: a block between two marks, made from the records."""

from __future__ import annotations

import re
from collections.abc import Sequence

from tools.documents.markdown import table
from tools.report.pages import share
from tools.report.record import MeasuredRecord

BEGIN, END = "<!-- made by make report: begin -->", "<!-- made by make report: end -->"
QUOTED = ("pick", "pick-clutter", "place", "hand_over", "open", "flat_bring", "gpsr", "stop")
"""The runs that the README shows, in its order."""
_BLOCK = re.compile(f"{re.escape(BEGIN)}\n.*?{re.escape(END)}\n", re.DOTALL)
_FIGURE = re.compile(r"\b\d+ of \d+\b|\d(?:\.\d+)?\s?%")
"""What looks like a result: so many of so many, or a share."""


def quoted(records: Sequence[MeasuredRecord]) -> str:
    """The block: those of the quoted runs that were measured.

    Args:
        records: Of one report.
    """
    by_name = {record.name: record for record in records}
    rows = [
        (
            f"[{record.name}](docs/measured/{record.suite}.md)",
            str(record.judged),
            share(record),
            str(record.counts.get("false_success", "")),
            str(record.counts.get("falls", "")),
        )
        for record in (by_name[name] for name in QUOTED if name in by_name)
    ]
    head = ("suite", "episodes", "good (95 %)", "claimed, and not so", "falls")
    return f"{BEGIN}\n{table(head, rows)}{END}\n"


def with_quotes(text: str, records: Sequence[MeasuredRecord]) -> str:
    """A page with its block made anew; one without the marks stays as it is."""
    block = quoted(records)
    return _BLOCK.sub(lambda _: block, text)


def figures_beside(text: str) -> list[str]:
    """Results that a page tells outside of the block, where nothing holds them."""
    return _FIGURE.findall(_BLOCK.sub("", text))
