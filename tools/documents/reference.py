"""``python -m tools.documents.reference``: write every page of the docs that is made from the code."""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping
from pathlib import Path
from types import MappingProxyType

from tools.documents.cli_page import cli_page
from tools.documents.decisions_page import decisions_page
from tools.documents.events_page import events_page
from tools.documents.node_kinds_page import node_kinds_page
from tools.documents.policy_page import policy_page
from tools.documents.report_page import report_page
from tools.documents.rooms_page import rooms_page
from tools.pictures.draw_rooms import picture

DOCS = Path(__file__).parents[2] / "docs"

PAGES: Mapping[str, Callable[[], str]] = MappingProxyType(
    {
        "reference/cli.md": cli_page,
        "reference/events.md": events_page,
        "reference/policy.md": policy_page,
        "reference/report.md": report_page,
        "reference/node-kinds.md": node_kinds_page,
        "understand/rooms.md": rooms_page,
        "pictures/rooms.svg": picture,
        "adr/index.md": decisions_page,
    }
)
"""Pages by their place under ``docs``, and what makes each."""


def main() -> int:
    """Write the pages that changed, and tell which."""
    for name, make in PAGES.items():
        file, text = DOCS / name, make()
        if not file.exists() or file.read_text("utf-8") != text:
            file.write_text(text, "utf-8")
            print(f"wrote docs/{name}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
