"""The page of the decisions: number, title and status of each record, read from the records."""

from __future__ import annotations

import re
from pathlib import Path

from tools.documents.markdown import table

FOLDER = Path(__file__).parents[2] / "docs" / "adr"

_HEAD = """\
# Decisions

Records of decisions that would surprise a newcomer: context, decision, consequences, status. A record tells
of its day; what holds now is told by the [guides](../index.md). To add one, take the next free number and
write `NNNN-title.md`.
"""
_TITLE = re.compile(r"^# (?:ADR )?0*(\d+)[.:]? +(.+)$", re.MULTILINE)
_STATUS = re.compile(r"^(?:## Status\s+|\*\*Status:?\*\*:? *)(.+?)(?:\n\n|\Z)", re.MULTILINE | re.DOTALL)


def decisions_page(folder: Path = FOLDER) -> str:
    """The page.

    Raises:
        ValueError: A record has no numbered title, or no status.
    """
    rows = []
    for file in sorted(folder.glob("[0-9]*.md")):
        text = file.read_text("utf-8")
        title, status = _TITLE.search(text), _STATUS.search(text)
        if title is None or status is None:
            raise ValueError(f"{file.name} needs a first line '# NUMBER. TITLE' and a part '## Status'")
        told = " ".join(status[1].split())
        rows.append((title[1], f"[{title[2]}]({file.name})", told[:1].upper() + told[1:]))
    return "\n".join([_HEAD, table(("", "decision", "status"), rows)])
