"""``python -m tools.documents.lifecycle_table [FILE]``: renders the state machine's tables into its
document.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path

from executive.session.lifecycle import COMMANDS, TRANSITIONS, LifecycleState

DOCUMENT = Path("docs/understand/safety.md")
BEGIN, END = "<!-- state machine: begin -->", "<!-- state machine: end -->"


def markdown() -> str:
    """The tables as they stand in the document."""
    lines = ["| from | when | to |", "| --- | --- | --- |"]
    lines += [
        f"| {before.value} | {trigger.value} | {after.value} |"
        for (before, trigger), after in TRANSITIONS.items()
    ]
    lines += ["", "| state | commands are |", "| --- | --- |"]
    lines += [f"| {state.value} | {COMMANDS[state]} |" for state in LifecycleState]
    return "\n".join(lines)


def rendered(document: str) -> str:
    """A document with the present tables between its marks.

    Raises:
        ValueError: It has no marks.
    """
    before, _, rest = document.partition(BEGIN)
    _, found, after = rest.partition(END)
    if not found:
        raise ValueError(f"the document has no {BEGIN} … {END}")
    return f"{before}{BEGIN}\n{markdown()}\n{END}{after}"


def main(arguments: Sequence[str] | None = None) -> int:
    """Bring the document up to date."""
    given = list(sys.argv[1:] if arguments is None else arguments)
    path = Path(given[0]) if given else DOCUMENT
    path.write_text(rendered(path.read_text("utf-8")), "utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
