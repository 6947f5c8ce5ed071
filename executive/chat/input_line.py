"""A line that is being typed: keys come in as a terminal sends them, lines and wishes come out."""

from __future__ import annotations

import re
from collections.abc import Sequence
from enum import Enum

MOST_REMEMBERED = 500
_LONGEST = 2_000
"""Characters of a line."""
_ESCAPE = re.compile(r"\x1b(?:[\[O][0-9;]*[A-Za-z~])?")
_UNFINISHED = re.compile(r"\x1b(?:[\[O][0-9;]*)?$")


class Wish(Enum):
    """What a key asks for beside the line."""

    STOP = "stop"
    PAUSE = "pause"
    END = "end"
    BACK = "back"
    FORTH = "forth"


_WISHES = {"\x18": Wish.STOP, "\x10": Wish.PAUSE, "\x1b[5~": Wish.BACK, "\x1b[6~": Wish.FORTH}
_KEYS = {
    "\x1b[D": "left", "\x1bOD": "left", "\x02": "left",
    "\x1b[C": "right", "\x1bOC": "right", "\x06": "right",
    "\x1b[H": "home", "\x1bOH": "home", "\x1b[1~": "home", "\x01": "home",
    "\x1b[F": "last", "\x1bOF": "last", "\x1b[4~": "last", "\x05": "last",
    "\x1b[A": "older", "\x1bOA": "older",
    "\x1b[B": "newer", "\x1bOB": "newer",
    "\x7f": "rub_out", "\x08": "rub_out", "\x1b[3~": "delete",
    "\x15": "clear", "\x17": "rub_out_word", "\x0b": "cut_end",
}  # fmt: skip


class InputLine:
    """The line, its cursor, and the lines before it, which the arrow keys bring back.

    Attributes:
        text: What is typed so far.
        cursor: Before which character the next one comes.
        history: Lines that were entered, the oldest first.
    """

    def __init__(self, history: Sequence[str] = ()) -> None:
        self.text, self.cursor = "", 0
        self.history = list(history)[-MOST_REMEMBERED:]
        self._at = len(self.history)
        self._draft = ""
        self._pending = ""

    def feed(self, typed: str) -> list[str | Wish]:
        """Take what a terminal sent; the lines that were entered and the wishes in it, in their order."""
        typed, self._pending = self._pending + typed, ""
        if (cut := _UNFINISHED.search(typed)) is not None and cut.group() != "\x1b":
            self._pending, typed = cut.group(), typed[: cut.start()]
        found: list[str | Wish] = []
        position = 0
        while position < len(typed):
            escape = _ESCAPE.match(typed, position)
            key = typed[position] if escape is None else escape.group()
            position += len(key)
            if key in ("\r", "\n"):
                found.append(self._entered())
            elif key == "\x04":
                found += [] if self.text else [Wish.END]
            elif key in _WISHES:
                found.append(_WISHES[key])
            elif key in _KEYS:
                getattr(self, f"_{_KEYS[key]}")()
            elif key.isprintable() and len(self.text) < _LONGEST:
                self._put(self.text[: self.cursor] + key, self.text[self.cursor :])
        return found

    def clear(self) -> bool:
        """Forget what is typed; whether there was something."""
        was = bool(self.text)
        self._clear()
        return was

    def _entered(self) -> str:
        line = self.text.strip()
        if line and self.history[-1:] != [line]:
            self.history = [*self.history, line][-MOST_REMEMBERED:]
        self._clear()
        return line

    def _put(self, before: str, behind: str) -> None:
        self.text, self.cursor = before + behind, len(before)

    def _clear(self) -> None:
        self._put("", "")
        self._at, self._draft = len(self.history), ""

    def _left(self) -> None:
        self.cursor = max(self.cursor - 1, 0)

    def _right(self) -> None:
        self.cursor = min(self.cursor + 1, len(self.text))

    def _home(self) -> None:
        self.cursor = 0

    def _last(self) -> None:
        self.cursor = len(self.text)

    def _rub_out(self) -> None:
        self._put(self.text[: max(self.cursor - 1, 0)], self.text[self.cursor :])

    def _delete(self) -> None:
        self._put(self.text[: self.cursor], self.text[self.cursor + 1 :])

    def _rub_out_word(self) -> None:
        kept = self.text[: self.cursor].rstrip()
        self._put(kept[: kept.rfind(" ") + 1], self.text[self.cursor :])

    def _cut_end(self) -> None:
        self._put(self.text[: self.cursor], "")

    def _older(self) -> None:
        self._show(self._at - 1)

    def _newer(self) -> None:
        self._show(self._at + 1)

    def _show(self, at: int) -> None:
        if not 0 <= at <= len(self.history):
            return
        if self._at == len(self.history):
            self._draft = self.text
        self._at = at
        self._put(self._draft if at == len(self.history) else self.history[at], "")
