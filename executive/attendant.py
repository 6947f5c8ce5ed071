"""Who attends to a run: answers its questions, and may cancel, stop or pause it.

A terminal is one, a replayed run's recorded inputs are another, and nobody is a third.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
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

    def emergency_stop(self, reason: str, category: int = 1) -> None:
        """Engage the emergency stop before the next control period."""
        ...

    def pause(self, reason: str) -> None:
        """Ask for the running task to be held where it is."""
        ...

    def resume(self) -> None:
        """Ask for a paused task to go on."""
        ...

    def watch_periods(self, call: Callable[[], None]) -> None:
        """Have something called after each control period."""
        ...


class Attendant(Protocol):
    """Somebody at a run."""

    def begin(self, session: Stoppable) -> None:
        """Called once, before the first task begins."""
        ...

    def answer(self, question: OpenQuestion) -> str | None:
        """Answer a question, or None: nobody did."""
        ...

    def attend(self, session: Stoppable) -> None:
        """Called after each tick: do what has been asked for since."""
        ...


class Nobody:
    """Leaves every question open."""

    def begin(self, _session: Stoppable) -> None:
        """Nothing to prepare."""

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
        self._cancels = [item for item in taken if item.what == "cancel"]
        self._stops = [item for item in taken if item.what == "emergency_stop"]
        self._pauses = [item for item in taken if item.what in ("pause", "resume")]

    def begin(self, session: Stoppable) -> None:
        """Have an eye on each control period: an emergency stop does not wait for a tick."""
        if self._stops:
            session.watch_periods(lambda: self._stop_when_due(session))

    def answer(self, _question: OpenQuestion) -> str | None:
        """Give the next recorded answer."""
        return (self._answers.pop(0).value or None) if self._answers else None

    def attend(self, session: Stoppable) -> None:
        """Cancel, pause and resume when that was done."""
        while self._pauses and self._pauses[0].t_s <= session.now_s + _ROUNDING_S:
            item = self._pauses.pop(0)
            if item.what == "pause":
                session.pause(item.value)
            else:
                session.resume()
        while self._cancels and self._cancels[0].t_s <= session.now_s + _ROUNDING_S:
            session.cancel(self._cancels.pop(0).value)

    def _stop_when_due(self, session: Stoppable) -> None:
        while self._stops and self._stops[0].t_s <= session.now_s + _ROUNDING_S:
            category, _, reason = self._stops.pop(0).value.partition(" ")
            session.emergency_stop(reason, int(category))
