"""Who attends to a run: answers its questions, and may cancel, stop or pause it.

A terminal is one, a replayed run's recorded inputs are another, and nobody is a third.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Protocol

from executive.clarification import OpenQuestion
from executive.events import InputTaken

_ROUNDING_S = 1e-6


class Stoppable(Protocol):
    """What an attendant may do to a session."""

    @property
    def now_s(self) -> float:
        """Simulated time."""
        ...

    def cancel(self, reason: str) -> None:
        """Ask for the running task to be halted."""
        ...


class Attendant(Protocol):
    """Somebody at a run."""

    def answer(self, question: OpenQuestion) -> str | None:
        """Answer a question, or None: nobody did."""
        ...

    def attend(self, session: Stoppable) -> None:
        """Called after each tick: do what has been asked for since."""
        ...


class Nobody:
    """Leaves every question open."""

    def answer(self, _question: OpenQuestion) -> str | None:
        """Give no answer."""
        return None

    def attend(self, _session: Stoppable) -> None:
        """Let it go on."""


class RecordedAttendant:
    """Gives the recorded inputs again, each at its simulated time."""

    def __init__(self, inputs: Iterable[InputTaken]) -> None:
        taken = list(inputs)
        self._answers = [item for item in taken if item.what == "answer"]
        self._others = [item for item in taken if item.what != "answer"]

    def answer(self, _question: OpenQuestion) -> str | None:
        """Give the next recorded answer."""
        return (self._answers.pop(0).value or None) if self._answers else None

    def attend(self, session: Stoppable) -> None:
        """Cancel when it was cancelled."""
        while self._others and self._others[0].t_s <= session.now_s + _ROUNDING_S:
            taken = self._others.pop(0)
            if taken.what == "cancel":
                session.cancel(taken.value)
