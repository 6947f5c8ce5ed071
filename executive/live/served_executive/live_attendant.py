"""Questions of a served executive: put to who gave the task, answered by anybody of the same user."""

from __future__ import annotations

from collections.abc import Callable

from executive.dialogue.attendant import Stoppable
from executive.dialogue.clarification import OpenQuestion
from executive.live.served_executive.desk import Desk

ANSWER_WITHIN_S = 60.0
"""Control time after which a question stays open; nothing moves meanwhile."""
_LOOK_EVERY_S = 0.02


class LiveAttendant:
    """Puts questions to whoever gave the order; satisfies ``executive.dialogue.attendant.Attendant``.

    Args:
        desk: Where answers come in.
        let_pass: Lets so many seconds of control time pass while the robot holds.
        interrupted: Whether the order was cancelled, or the robot stopped, while its question was open.
    """

    def __init__(
        self, desk: Desk, let_pass: Callable[[float], None], interrupted: Callable[[], bool]
    ) -> None:
        self._desk, self._let_pass, self._interrupted = desk, let_pass, interrupted

    def begin(self, _session: Stoppable) -> None:
        """Nothing to prepare."""

    def answer(self, question: OpenQuestion) -> str | None:
        """Put the question, and wait for ``executive answer``."""
        order = self._desk.current
        if order is None:
            return None
        order.ask(question)
        self._desk.given.clear()
        self._desk.question = question
        try:
            for _ in range(round(ANSWER_WITHIN_S / _LOOK_EVERY_S)):
                self._let_pass(_LOOK_EVERY_S)
                self._desk.poll()
                if self._interrupted():
                    return None
                if self._desk.given:
                    return self._desk.given.pop(0)
            return None
        finally:
            self._desk.question = None

    def attend(self, _session: Stoppable) -> None:
        """What comes in between is taken in while time passes."""
