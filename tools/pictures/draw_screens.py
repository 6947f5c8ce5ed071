"""``python -m tools.pictures.draw_screens``: pictures of the terminal for the docs, and the snapshots of
its tests.
"""

from __future__ import annotations

import io
import json
from pathlib import Path
from typing import Any

from rich.console import Console
from rich.text import Text

from executive.dialogue.clarification import OpenQuestion
from executive.screens.display import drawing
from executive.screens.rows import text_of
from executive.screens.screen import ScreenState, screen
from trees.snapshot import NodeSnapshot, TreeSnapshot

ROOT = Path(__file__).parents[2]
PICTURES, SNAPSHOTS = ROOT / "docs" / "pictures", ROOT / "tests" / "executive" / "screens" / "screens"
RECORDED = Path(__file__).with_name("screens.json")
"""What was shown in real runs, written by ``python -m tools.pictures.record_screens``."""

SMALL, WIDE = (80, 24), (160, 50)
SIZES = (SMALL, WIDE)
SHOWN = (
    ("running", SMALL, False),
    ("running", SMALL, True),
    ("stopped", WIDE, False),
    ("asking", SMALL, False),
)
"""Pictures in the guide: which screen, how large, and whether without colour."""


def _node(said: dict[str, Any]) -> NodeSnapshot:
    return NodeSnapshot(**{**said, "children": tuple(map(_node, said["children"]))})


def _state(said: dict[str, Any]) -> ScreenState:
    """What was shown, read back."""
    tree, question = said["tree"], said["question"]
    if question is not None:
        question = OpenQuestion(**{**question, "choices": tuple(question["choices"])})
    shown = TreeSnapshot(**{**tree, "root": _node(tree["root"])})
    return ScreenState(**{**said, "tree": shown, "question": question, "log": tuple(said["log"])})


EXAMPLES = {name: _state(said) for name, said in json.loads(RECORDED.read_text("utf-8")).items()}
RUNNING, ASKING, STOPPED = (EXAMPLES[name] for name in ("running", "asking", "stopped"))


def main() -> None:
    """Write pictures and snapshots."""
    SNAPSHOTS.mkdir(parents=True, exist_ok=True)
    for name, state in EXAMPLES.items():
        for width, height in SIZES:
            text = text_of(screen(state, width, height)) + "\n"
            (SNAPSHOTS / f"{name}_{width}x{height}.txt").write_text(text, "utf-8")
    for name, (width, height), plain in SHOWN:
        suffix = "_plain" if plain else ""
        picture = PICTURES / f"screen_{name}_{width}x{height}{suffix}.svg"
        picture.write_text(_picture(name, width, height, plain), "utf-8")
    print(f"wrote {len(EXAMPLES)} screens in {len(SIZES)} sizes, {len(SHOWN)} pictures")


def _picture(name: str, width: int, height: int, plain: bool) -> str:
    """One screen as SVG, in colour or without."""
    console = Console(
        file=io.TextIOWrapper(io.BytesIO(), "utf-8"),
        record=True,
        width=width,
        height=height,
        force_terminal=True,
        color_system="truecolor",
    )
    state = EXAMPLES[name]
    console.print(Text(text_of(screen(state, width, height))) if plain else drawing(state, console))
    return console.export_svg(title="executive run", unique_id=name)


if __name__ == "__main__":
    main()
