"""Somebody at a terminal, or a pipe: answers are lines of standard input."""

from __future__ import annotations

import io
import select
from collections.abc import Callable
from typing import IO

from executive.dialogue.attendant import Stoppable
from executive.dialogue.clarification import OpenQuestion
from robots.toml_text import BYTE_ORDER_MARK

ANSWER_TIMEOUT_S = 60.0
"""A question that nobody answers for so long stays open, and ends the run; nothing moves meanwhile."""
LOOK_EVERY_S = 0.1
"""Wall time after which who waits for an answer looks whether there is a run to answer for."""


def never() -> bool:
    """Say no: nothing interrupts."""
    return False


class TerminalAttendant:
    """An attendant at a terminal without single keys: shows a question, and waits for a line.

    Args:
        stdin: Where answers come from; at its end nobody answers any more.
        show: Shows a line to the person.
        timeout_s: Wall time that an answer may take.
        interrupted: Whether the run was cancelled meanwhile: then no answer is waited for.
    """

    def __init__(
        self,
        stdin: IO[str],
        show: Callable[[str], None],
        timeout_s: float = ANSWER_TIMEOUT_S,
        interrupted: Callable[[], bool] = never,
    ) -> None:
        self._stdin, self._show, self._timeout_s = stdin, show, timeout_s
        self._interrupted = interrupted

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
        if not self._arrives():
            return None
        try:
            line = self._stdin.readline()
        except (OSError, ValueError):
            return None
        return line.removeprefix(BYTE_ORDER_MARK).strip() if line else None

    def _arrives(self) -> bool:
        """Wait for something to read; False when nothing comes in time, or the run was cancelled."""
        looks = max(1, round(self._timeout_s / LOOK_EVERY_S))
        for _ in range(looks):
            if self._interrupted():
                return False
            try:
                ready, _, _ = select.select([self._stdin], [], [], self._timeout_s / looks)
            except (io.UnsupportedOperation, ValueError, TypeError):
                return True  # no file of the operating system: it has all its lines already
            if ready:
                return True
        return False
