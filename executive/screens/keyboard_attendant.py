"""Somebody at a drawing terminal: keys cancel, stop and pause; questions are answered by key or in words."""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol

from executive.dialogue.attendant import Stoppable
from executive.dialogue.clarification import OpenQuestion
from executive.screens.terminal_attendant import ANSWER_TIMEOUT_S, LOOK_EVERY_S, never

_TICK_S = 0.02
"""A paused robot stands and balances in simulated time: as long as a tick of it, a key is waited for."""


class Keys(Protocol):
    """Where keys come from."""

    def key(self, timeout_s: float | None = 0.0) -> str:
        """The next key, or nothing in time."""
        ...

    def line(self, timeout_s: float, interrupted: Callable[[], bool] = never) -> str | None:
        """A typed line, or None when none comes in time, or the run was cancelled."""
        ...


class Screen(Protocol):
    """Where questions and pauses are shown."""

    def ask(self, question: OpenQuestion | None) -> None:
        """Show a question, or take it away."""
        ...

    def pause(self, paused: bool) -> None:
        """Show whether time is held."""
        ...

    def close(self) -> None:
        """Give the terminal back, for a line to be typed."""
        ...


class KeyboardAttendant:
    """An attendant at the keyboard: listens to keys between two ticks.

    Args:
        keys: The keyboard.
        screen: The display.
        timeout_s: Wall time that an answer may take.
        interrupted: Whether the run was cancelled meanwhile: then no answer is waited for.
    """

    def __init__(
        self,
        keys: Keys,
        screen: Screen,
        timeout_s: float = ANSWER_TIMEOUT_S,
        interrupted: Callable[[], bool] = never,
    ) -> None:
        self._keys, self._screen, self._timeout_s = keys, screen, timeout_s
        self._interrupted = interrupted
        self._session: Stoppable | None = None
        self._paused = False

    def begin(self, session: Stoppable) -> None:
        """Know whom to stop."""
        self._session = session

    def attend(self, session: Stoppable) -> None:
        """Do what the pressed key says; while paused, at the pace of the clock on the wall at most."""
        key = self._keys.key(_TICK_S if self._paused else 0.0)
        if key == "p" and not self._paused:
            session.pause("paused from the keyboard")
            self._show_pause(True)
        elif self._paused and key in ("p", "c", "e"):
            session.resume()
            self._show_pause(False)
        if key == "c":
            session.cancel("cancelled from the keyboard")
        elif key == "e":
            session.emergency_stop("stopped from the keyboard")

    def _show_pause(self, paused: bool) -> None:
        self._paused = paused
        self._screen.pause(paused)

    def answer(self, question: OpenQuestion) -> str | None:
        """Show the question; a digit chooses, "a" takes words, "c" withdraws, "e" stops."""
        self._screen.ask(question)
        try:
            while True:
                match self._key():
                    case "":
                        return None
                    case "e":
                        if self._session is not None:
                            self._session.emergency_stop("stopped from the keyboard")
                        return None
                    case "c":
                        return "never mind"
                    case "a":
                        self._screen.close()
                        return self._keys.line(self._timeout_s, self._interrupted)
                    case digit if digit.isdecimal():
                        return digit
        finally:
            self._screen.ask(None)

    def _key(self) -> str:
        """The next key, or nothing when none comes in time, or the run was cancelled."""
        for _ in range(max(1, round(self._timeout_s / LOOK_EVERY_S))):
            if self._interrupted():
                return ""
            if key := self._keys.key(LOOK_EVERY_S):
                return key
        return ""
