"""Who attends to a run: answers its questions, and may cancel, stop or pause it.

A terminal is one, a replayed run's recorded inputs are another, and nobody is a third.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Protocol

from executive.dialogue.clarification import OpenQuestion
from executive.manual.word_text import read_word
from executive.manual.words import ENDINGS, JogFeed, TakenOver
from executive.session.by_hand import ByHand
from executive.session.cancellation import Cancellation
from executive.session.events import InputTaken

_ROUNDING_S = 1e-6


class Stoppable(Protocol):
    """What an attendant may do to a session."""

    @property
    def now_s(self) -> float:
        """Simulated time."""
        ...

    @property
    def hands(self) -> ByHand:
        """Lets a person take a task over."""
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
    """Whoever answers a run's questions and may cancel, stop or pause it."""

    def begin(self, session: Stoppable) -> None:
        """Called once, before the first task begins."""
        ...

    def answer(self, question: OpenQuestion) -> str | None:
        """Answer a question, or None: nobody did, or the run was cancelled or stopped meanwhile."""
        ...

    def attend(self, session: Stoppable) -> None:
        """Called after each tick: do what has been asked for since."""
        ...


class Nobody:
    """An attendant who leaves every question open and never interrupts."""

    def begin(self, _session: Stoppable) -> None:
        """Nothing to prepare."""

    def answer(self, _question: OpenQuestion) -> str | None:
        """Give no answer."""
        return None

    def attend(self, _session: Stoppable) -> None:
        """Let it go on."""


class RecordedAttendant:
    """Gives the recorded inputs again, each at its simulated time.

    Args:
        inputs: What was recorded, in its order.
        cancellation: The run's cancel, for what was cancelled before there was a robot.
    """

    def __init__(self, inputs: Iterable[InputTaken], cancellation: Cancellation) -> None:
        self._inputs = list(inputs)
        self._cancellation = cancellation
        self._session: Stoppable | None = None

    def begin(self, session: Stoppable) -> None:
        """Have an eye on each control period: an emergency stop does not wait for a tick."""
        self._session = session
        if any(item.what == "take_over" for item in self._inputs):
            session.hands.offer = lambda _failure: self._takes_over("after its failure", session.now_s)
        if any(item.what == "emergency_stop" for item in self._inputs):
            session.watch_periods(lambda: self._stop_when_due(session))
        if (cancel := self._next("cancel", 0.0)) is not None:  # while the robot was being put together
            self._cancellation.ask(cancel.value)

    def answer(self, _question: OpenQuestion) -> str | None:
        """Give the next recorded answer, or do what ended the question."""
        now_s = 0.0 if self._session is None else self._session.now_s
        ends = ("cancel", "emergency_stop")
        first = self._next_of(("answer", *ends), now_s)
        if first is not None and first.what == "answer":
            if first.value:
                return first.value
            first = self._next_of(ends, now_s)
        if first is not None and first.what == "cancel":
            self._cancellation.ask(first.value)
        elif first is not None and self._session is not None:
            _stop(self._session, first.value)
        return None

    def attend(self, session: Stoppable) -> None:
        """Cancel, pause and resume when that was done; jog as it was jogged."""
        feed = session.hands.feed
        if feed.active:
            self._jog(feed, session.now_s)
        elif self._takes_over("in its middle", session.now_s):
            feed.take_over()
        while (item := self._next_of(("pause", "resume"), session.now_s)) is not None:
            if item.what == "pause":
                session.pause(item.value)
            else:
                session.resume()
        if any(abs(item.t_s - session.now_s) < _ROUNDING_S for item in self._inputs if item.what == "answer"):
            return  # a question comes first, and the cancel, if there is one, while it was open
        while (item := self._next("cancel", session.now_s)) is not None:
            session.cancel(item.value)

    def _takes_over(self, when: TakenOver, now_s: float) -> bool:
        """Whether a person has taken over so, and now."""
        first = next((item for item in self._inputs if item.what == "take_over"), None)
        return first is not None and first.value == when and self._next("take_over", now_s) is not None

    def _jog(self, feed: JogFeed, now_s: float) -> None:
        while (item := self._next_of(("jog", "hand_back"), now_s)) is not None:
            if item.what == "hand_back":
                feed.hand_back(next(ending for ending in ENDINGS if ending == item.value))
                continue
            word, feed.may_touch = read_word(item.value)
            if word is None:
                feed.brake()
            else:
                feed.say(word, now_s)

    def _stop_when_due(self, session: Stoppable) -> None:
        while (item := self._next("emergency_stop", session.now_s)) is not None:
            _stop(session, item.value)

    def _next(self, what: str, now_s: float) -> InputTaken | None:
        return self._next_of((what,), now_s)

    def _next_of(self, kinds: tuple[str, ...], now_s: float) -> InputTaken | None:
        """Take the next input of some kinds, once its time has come."""
        first = next((item for item in self._inputs if item.what in kinds), None)
        if first is None or first.t_s > now_s + _ROUNDING_S:
            return None
        self._inputs.remove(first)
        return first


def _stop(session: Stoppable, recorded: str) -> None:
    category, _, reason = recorded.partition(" ")
    session.emergency_stop(reason, int(category))
