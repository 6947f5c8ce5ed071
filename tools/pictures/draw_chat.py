"""``python -m tools.pictures.draw_chat``: pictures of the chat's screen for the docs, and the snapshots of
its tests.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from executive.chat.chat_screen import ChatView, chat_screen
from executive.chat.robot_watch import RobotStanding
from executive.chat.utterance import Utterance
from executive.screens.rows import Row
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

RECORDED = Path(__file__).with_name("chat.json")
"""What was shown in a real conversation, written by ``python -m tools.pictures.record_chat``."""

SHOWN = (
    ("asking", SMALL, False),
    ("working", WIDE, False),
    ("stopped", SMALL, False),
    ("stopped", SMALL, True),
)
"""Pictures in the guide: which screen, how large, and whether without colour."""


def _view(said: dict[str, Any]) -> ChatView:
    """What was shown, read back."""
    now = said["now"]
    tree = now["tree"] and TreeSnapshot(**{**now["tree"], "root": node_from(now["tree"]["root"])})
    uttered = tuple(Utterance(one["who"], tuple(one["lines"]), one["style"]) for one in said["said"])
    standing = RobotStanding(**{**now, "tree": tree})
    return ChatView(**{**said, "now": standing, "said": uttered, "log": tuple(said["log"])})


EXAMPLES = {name: _view(said) for name, said in json.loads(RECORDED.read_text("utf-8")).items()}


def main() -> None:
    """Write pictures and snapshots."""
    write_snapshots(TESTS / "chat" / "screens", EXAMPLES, _laid)
    write_pictures("chat", "executive chat", SHOWN, _laid, of="chat-")
    print(f"wrote {len(EXAMPLES)} screens in {len(SIZES)} sizes, {len(SHOWN)} pictures")


def _laid(name: str, width: int, height: int) -> Sequence[Row]:
    return chat_screen(EXAMPLES[name], width, height)


if __name__ == "__main__":
    main()
