"""``python -m tools.pictures.draw_chat``: pictures of the chat's screen for the docs, and the snapshots of
its tests.
"""

from __future__ import annotations

import io
import json
from pathlib import Path
from typing import Any

from rich.console import Console
from rich.text import Text

from executive.chat.chat_screen import ChatView, chat_screen
from executive.chat.robot_watch import RobotStanding
from executive.chat.utterance import Utterance
from executive.screens.display import painted
from executive.screens.rows import text_of
from trees.snapshot import NodeSnapshot, TreeSnapshot

ROOT = Path(__file__).parents[2]
PICTURES, SNAPSHOTS = ROOT / "docs" / "pictures", ROOT / "tests" / "executive" / "chat" / "screens"
RECORDED = Path(__file__).with_name("chat.json")
"""What was shown in a real conversation, written by ``python -m tools.pictures.record_chat``."""

SMALL, WIDE = (80, 24), (160, 50)
SIZES = (SMALL, WIDE)
SHOWN = (
    ("asking", SMALL, False),
    ("working", WIDE, False),
    ("stopped", SMALL, False),
    ("stopped", SMALL, True),
)
"""Pictures in the guide: which screen, how large, and whether without colour."""


def _node(said: dict[str, Any]) -> NodeSnapshot:
    return NodeSnapshot(**{**said, "children": tuple(map(_node, said["children"]))})


def _view(said: dict[str, Any]) -> ChatView:
    """What was shown, read back."""
    now = said["now"]
    tree = now["tree"] and TreeSnapshot(**{**now["tree"], "root": _node(now["tree"]["root"])})
    uttered = tuple(Utterance(one["who"], tuple(one["lines"]), one["style"]) for one in said["said"])
    standing = RobotStanding(**{**now, "tree": tree})
    return ChatView(**{**said, "now": standing, "said": uttered, "log": tuple(said["log"])})


EXAMPLES = {name: _view(said) for name, said in json.loads(RECORDED.read_text("utf-8")).items()}


def main() -> None:
    """Write pictures and snapshots."""
    SNAPSHOTS.mkdir(parents=True, exist_ok=True)
    for name, view in EXAMPLES.items():
        for width, height in SIZES:
            text = text_of(chat_screen(view, width, height)) + "\n"
            (SNAPSHOTS / f"{name}_{width}x{height}.txt").write_text(text, "utf-8")
    for name, (width, height), plain in SHOWN:
        suffix = "_plain" if plain else ""
        picture = PICTURES / f"chat_{name}_{width}x{height}{suffix}.svg"
        picture.write_text(picture_of(EXAMPLES[name], name, width, height, plain), "utf-8")


def picture_of(view: ChatView, name: str, width: int, height: int, plain: bool = False) -> str:
    """One screen as SVG, in colour or without."""
    console = Console(
        file=io.TextIOWrapper(io.BytesIO(), "utf-8"),
        record=True,
        width=width,
        height=height,
        force_terminal=True,
        color_system="truecolor",
    )
    rows = chat_screen(view, width, height)
    console.print(Text(text_of(rows)) if plain else painted(rows))
    return console.export_svg(title="executive chat", unique_id=f"chat-{name}")


if __name__ == "__main__":
    main()
