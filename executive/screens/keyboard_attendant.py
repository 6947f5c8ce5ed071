"""Somebody at a drawing terminal: keys cancel, stop and pause; questions are answered by key or in words."""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol

from executive.dialogue.attendant import Stoppable
from executive.dialogue.clarification import OpenQuestion
from executive.manual.console import JogConsole
from executive.manual.keys import JogKeys
from executive.manual.words import Ending, JogFeed, JogWord
from executive.screens.jog_screen import JogScreen, jog_lines
from executive.screens.terminal_attendant import ANSWER_TIMEOUT_S, LOOK_EVERY_S, never
from trees.failures import Failure

_TICK_S = 0.02
"""A paused robot stands and balances in simulated time: as long as a tick of it, a key is waited for."""


_OFFERED_S = 20.0
"""Wall time in which a person may take over what has failed; the robot stands meanwhile."""


class Keys(Protocol):
    """Where keys come from."""

    def key(self, timeout_s: float | None = 0.0) -> str:
        """The next key, or nothing in time."""
        ...

    def keys(self, timeout_s: float = 0.0) -> tuple[str, ...]:
        """The keys that have come, by name."""
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

    def jog(self, lines: tuple[str, ...]) -> None:
        """Show what a person who jogs has to know."""
        ...

    def offer(self, offered: bool) -> None:
        """Show that a person may take over, or no more."""
        ...

    @property
    def width(self) -> int:
        """Columns."""
        ...


class KeyboardAttendant:
    """An attendant at the keyboard: listens to keys between two ticks.

    Args:
        keys: The keyboard.
        screen: The display.
        timeout_s: Wall time that an answer may take.
        interrupted: Whether the run was cancelled meanwhile: then no answer is waited for.
        jog_keys: What keys mean while a person jogs the robot; without them nobody takes over.
    """

    def __init__(
        self,
        keys: Keys,
        screen: Screen,
        timeout_s: float = ANSWER_TIMEOUT_S,
        interrupted: Callable[[], bool] = never,
        jog_keys: JogKeys | None = None,
    ) -> None:
        self._jogging = None if jog_keys is None else _Jogging(jog_keys, screen)
        self._keys, self._screen, self._timeout_s = keys, screen, timeout_s
        self._interrupted = interrupted
        self._session: Stoppable | None = None
        self._paused = False

    def begin(self, session: Stoppable) -> None:
        """Know whom to stop, and who may be taken over."""
        self._session = session
        if self._jogging is not None:
            session.hands.offer = self._offered

    def attend(self, session: Stoppable) -> None:
        """Do what the pressed key says; while paused, at the pace of the clock on the wall at most."""
        if self._jogging is not None and session.hands.feed.active:
            self._jogging.attend(session, self._keys.keys(_TICK_S))
            return
        key = self._keys.key(_TICK_S if self._paused else 0.0)
        if key == "t" and self._jogging is not None and not self._paused:
            session.hands.feed.take_over()
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

    def _offered(self, _failure: Failure) -> bool:
        """Whether the person takes over what has failed; the screen says what it was."""
        self._screen.offer(True)
        try:
            return self._key(_OFFERED_S) == "t"
        finally:
            self._screen.offer(False)

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

    def _key(self, timeout_s: float | None = None) -> str:
        """The next key, or nothing when none comes in time, or the run was cancelled."""
        within_s = self._timeout_s if timeout_s is None else timeout_s
        for _ in range(max(1, round(within_s / LOOK_EVERY_S))):
            if self._interrupted():
                return ""
            if key := self._keys.key(LOOK_EVERY_S):
                return key
        return ""


class _Jogging:
    """The keyboard while a person has the robot."""

    def __init__(self, keys: JogKeys, screen: Screen) -> None:
        self._keys, self._screen = keys, screen
        self._console: JogConsole | None = None

    def attend(self, session: Stoppable, keys: tuple[str, ...]) -> None:
        """Tell the robot what the keys say, and show how it goes."""
        feed = session.hands.feed
        if self._console is None:
            self._console = JogConsole(self._keys, _Fed(feed, session))
        console = self._console
        for key in dict.fromkeys(keys):
            console.press(key, session.now_s)
        if console.given_back is not None:
            self._console = None
            self._screen.jog(())
            return
        lines = jog_lines(JogScreen("", console.jogged, feed.told, ending=console.ending), self._screen.width)
        self._screen.jog(tuple(lines[1:]))


class _Fed:
    """A person's words on their way into a session's feed."""

    def __init__(self, feed: JogFeed, session: Stoppable) -> None:
        self._feed, self._session = feed, session

    def say(self, word: JogWord | None, may_touch: bool) -> None:
        """Say a word; None brakes."""
        self._feed.may_touch = may_touch
        if word is None:
            self._feed.brake()
        else:
            self._feed.say(word, self._session.now_s)

    def hand_back(self, ending: Ending) -> None:
        """Give the robot back."""
        self._feed.hand_back(ending)
