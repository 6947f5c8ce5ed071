"""``python -m tools.pictures.draw_screens``: pictures of the terminal for the docs, and the snapshots of
its tests.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from executive.dialogue.clarification import OpenQuestion
from executive.screens.rows import Row
from executive.screens.screen import ScreenState, screen
from tools.pictures.screen_pictures import (
    SIZES,
    SMALL,
    TESTS,
    WIDE,
    node_from,
    write_pictures,
    write_snapshots,
)
from trees.snapshot import TreeSnapshot

RECORDED = Path(__file__).with_name("screens.json")
"""What was shown in real runs, written by ``python -m tools.pictures.record_screens``."""

SHOWN = (
    ("running", SMALL, False),
    ("running", SMALL, True),
    ("stopped", WIDE, False),
    ("asking", SMALL, False),
)
"""Pictures in the guide: which screen, how large, and whether without colour."""


def _state(said: dict[str, Any]) -> ScreenState:
    """What was shown, read back."""
    tree, question = said["tree"], said["question"]
    if question is not None:
        question = OpenQuestion(**{**question, "choices": tuple(question["choices"])})
    shown = TreeSnapshot(**{**tree, "root": node_from(tree["root"])})
    return ScreenState(**{**said, "tree": shown, "question": question, "log": tuple(said["log"])})


EXAMPLES = {name: _state(said) for name, said in json.loads(RECORDED.read_text("utf-8")).items()}
RUNNING, ASKING, STOPPED = (EXAMPLES[name] for name in ("running", "asking", "stopped"))


def main() -> None:
    """Write pictures and snapshots."""
    write_snapshots(TESTS / "screens" / "screens", EXAMPLES, _laid)
    write_pictures("screen", "executive run", SHOWN, _laid)
    print(f"wrote {len(EXAMPLES)} screens in {len(SIZES)} sizes, {len(SHOWN)} pictures")


def _laid(name: str, width: int, height: int) -> list[Row]:
    return screen(EXAMPLES[name], width, height)


if __name__ == "__main__":
    main()
