"""What was said in a conversation, by whom."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from executive.screens.rows import Style

Speaker = Literal["you", "robot"]


@dataclass(frozen=True, slots=True)
class Utterance:
    """Something that one side said.

    Attributes:
        who: Which side.
        lines: What, a line each; choices of a question are lines of their own.
        style: What it is like: an answer, a question, a failure, an alarm.
    """

    who: Speaker
    lines: tuple[str, ...]
    style: Style = ""
