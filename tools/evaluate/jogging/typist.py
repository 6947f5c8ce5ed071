"""A scripted person at the keys: holds them down as a keyboard does, through the same keys as a terminal."""

from __future__ import annotations

from collections.abc import Iterator

from executive.manual.keys import JogKeys, keys_for
from executive.manual.words import Ending
from executive.session.assembly import Assembly
from executive.session.driver import driven
from executive.session.task_result import TaskResult
from trees.tasks import Task

REPEAT_S = 0.04
"""From one repeat of a key that is held down to the next."""
_OVER = "over"
Script = Iterator[str | None]
"""A key a tick of the repeat, None for none; each is asked for when the one before has been pressed."""


class Typist:
    """Presses the keys of a script while the robot is in a person's hands.

    Attributes:
        keys: What keys mean.
        pressed_s: Simulated time of the last key that said something, or None.
    """

    def __init__(self, assembly: Assembly) -> None:
        self._session, self._feed = assembly.session, assembly.session.hands.feed
        self.keys: JogKeys = keys_for(assembly.model.description)
        self.pressed_s: float | None = None

    def press(self, key: str) -> None:
        """Press a key now."""
        now_s = self._session.now_s
        pressed = self.keys.press(key, now_s)
        self._feed.may_touch = pressed.jogged.may_touch
        if pressed.brakes:
            self._feed.brake()
        elif pressed.word is not None:
            self._feed.say(pressed.word, now_s)
            self.pressed_s = now_s

    def carry_on(self, task: Task, script: Script, ending: Ending, by_hand: bool) -> TaskResult:
        """Carry a task out; a script has the robot once a person does.

        Args:
            task: The task.
            script: The keys.
            ending: What is said to be so when the script has ended.
            by_hand: Whether it begins in the person's hands; else after its failure.
        """
        next_s = 0.0

        def type_on() -> None:
            nonlocal next_s
            if not self._feed.active or self._feed.ending is not None or self._session.now_s < next_s - 1e-9:
                return
            next_s = self._session.now_s + REPEAT_S
            key = next(script, _OVER)
            if key == _OVER:
                self._feed.hand_back(ending)
                return
            if key is not None:
                self.press(key)

        return driven(self._session.task_steps(task, by_hand=by_hand), between=type_on)


def held(key: str, seconds: float) -> Script:
    """A key that is held down; the repeats' first wait is left out: it would only make for pauses."""
    yield from [key] * max(1, round(seconds / REPEAT_S))


def silent(seconds: float) -> Script:
    """No key."""
    yield from [None] * round(seconds / REPEAT_S)
