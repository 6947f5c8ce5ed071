"""Somebody at a terminal, or a pipe: answers are lines of standard input."""

from __future__ import annotations

import io
import select
from collections.abc import Callable
from typing import IO

from executive.attendant import Stoppable
from executive.clarification import OpenQuestion
from robots.toml_text import BYTE_ORDER_MARK

ANSWER_TIMEOUT_S = 60.0
"""A question that nobody answers for so long stays open, and ends the run; nothing moves meanwhile."""


class TerminalAttendant:
    """Shows a question, and waits for a line.

    Args:
        stdin: Where answers come from; at its end nobody answers any more.
        show: Shows a line to the person.
        timeout_s: Wall time that an answer may take.
    """

    def __init__(
        self, stdin: IO[str], show: Callable[[str], None], timeout_s: float = ANSWER_TIMEOUT_S
    ) -> None:
        self._stdin, self._show, self._timeout_s = stdin, show, timeout_s

    def begin(self, _session: Stoppable) -> None:
        """Nothing to prepare."""

    def answer(self, question: OpenQuestion) -> str | None:
        """Put the question; None when no line comes in time."""
        for line in question.lines():
            self._show(line)
        if question.choices:
            self._show("answer with a number or words, or 'never mind':")
        return self._line()

    def attend(self, _session: Stoppable) -> None:
        """Nothing comes in between the questions."""

    def _line(self) -> str | None:
        try:
            ready, _, _ = select.select([self._stdin], [], [], self._timeout_s)
        except (io.UnsupportedOperation, ValueError, TypeError):
            ready = [self._stdin]  # no file of the operating system: it has all its lines already
        if not ready:
            return None
        try:
            line = self._stdin.readline()
        except (OSError, ValueError):
            return None
        return line.removeprefix(BYTE_ORDER_MARK).strip() if line else None
