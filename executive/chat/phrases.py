"""What a typed line asks of the chat itself, as opposed to a sentence for the robot."""

from __future__ import annotations

import importlib.resources
import re
from collections.abc import Mapping
from enum import StrEnum
from functools import cache

from executive.meaning import StopCommand
from robots.toml_text import read_toml

_WORD = re.compile(r"[\w?]+(?:['\-][\w]+)*")
_MOST_CHARACTERS = 200
"""Of a line that may ask something of the chat; a longer one is a sentence."""


class Ask(StrEnum):
    """What can be asked of the chat; the names are those of ``phrases.toml``."""

    CANCEL = "cancel"
    STOP = "stop"
    PAUSE = "pause"
    GO_ON = "go_on"
    RESET = "reset"
    WHY = "why"
    SEEN = "seen"
    STANDING = "standing"
    HELP = "help"
    END = "end"


IN_BETWEEN = (Ask.STOP, Ask.CANCEL, Ask.PAUSE, Ask.GO_ON)
"""What is heeded as soon as it is read, whatever was typed before it."""


def asked_of_chat(line: str) -> Ask | None:
    """Find out what a line asks of the chat; None where it is for the robot.

    Whatever the command language understands as a stop ("don't move", "whoa") is one here as well.
    """
    words = _WORD.findall(line[: _MOST_CHARACTERS + 1].lower().replace("’", "'").strip().lstrip("/"))
    if not words or len(line) > _MOST_CHARACTERS:
        return None
    known = _phrases()
    for plain in (" ".join(words), " ".join(words).replace("?", "").strip()):
        asked = known.get(plain) or known.get(" ".join(word for word in plain.split() if word != "please"))
        if asked is not None:
            return asked
    return Ask.STOP if _is_spoken_stop(line) else None


def _is_spoken_stop(line: str) -> bool:
    from executive.understanding.command_parser import parse

    commands = parse(line).commands
    return len(commands) == 1 and isinstance(commands[0], StopCommand)


@cache
def _phrases() -> Mapping[str, Ask]:
    file = importlib.resources.files("executive.chat") / "phrases.toml"
    return {
        phrase: Ask(asked) for asked, said in read_toml(file.read_text("utf-8")).items() for phrase in said
    }
