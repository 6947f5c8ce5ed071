"""The conversation line by line: for pipes, and for terminals without a screen."""

from __future__ import annotations

import queue
import threading
from collections import deque
from collections.abc import Callable
from typing import IO

from executive.chat.phrases import IN_BETWEEN, Ask, asked_of_chat
from executive.chat.talk import Talk
from executive.chat.utterance import Utterance
from robots.clock import WallClock
from robots.toml_text import BYTE_ORDER_MARK

_LOOK_EVERY_S = 0.02
_LONGEST = 20_000
"""Characters of a line; the rest of a longer one is not read into it."""


class PlainChat:
    """Reads lines, and has them heard.

    Lines of a pipe are taken in their order, as a script's are: the next one when the robot is free, or asks.
    Only a stop, a cancel and a pause are heeded at once, and then nothing that stood before them is begun any
    more. What somebody types is heard as it is typed.

    Args:
        stdin: Where lines come from.
        write: Takes a line of the conversation.
        typed: Whether a person types them.
    """

    def __init__(self, stdin: IO[str], write: Callable[[str], None], typed: bool) -> None:
        self._stdin, self._write, self._typed = stdin, write, typed
        self._read: queue.SimpleQueue[str | None] = queue.SimpleQueue()
        self._unheard: deque[str] = deque()
        self._at_end = False

    def show(self, said: Utterance) -> None:
        """Write what was said; what a person types stands there already."""
        if said.who == "you" and self._typed:
            return
        first = "you:   " if said.who == "you" else "robot: "
        for number, line in enumerate(said.lines):
            self._write(f"{'       ' if number else first}{line}")

    def run(self, talk: Talk, each: Callable[[], None]) -> None:
        """Talk until it is over.

        Args:
            talk: The conversation.
            each: Called again and again: signals.
        """
        threading.Thread(target=self._read_all, name="lines of the chat", daemon=True).start()
        wall = WallClock()
        while not talk.is_over:
            each()
            self._take_in()
            self._hear(talk)
            talk.poll()
            if not talk.is_over:
                wall.sleep(_LOOK_EVERY_S)

    def _read_all(self) -> None:
        try:
            while line := self._stdin.readline(_LONGEST):
                self._read.put(line.removeprefix(BYTE_ORDER_MARK))
        except (OSError, ValueError):
            pass  # a closed standard input has ended
        self._read.put(None)

    def _take_in(self) -> None:
        while True:
            try:
                line = self._read.get_nowait()
            except queue.Empty:
                return
            if line is None:
                self._at_end = True
            elif line.strip():
                self._unheard.append(line.strip())

    def _hear(self, talk: Talk) -> None:
        while self._unheard and (self._typed or talk.is_ready):
            talk.hear(self._unheard.popleft())
            talk.poll()
        self._hear_in_between(talk)
        if self._at_end and not self._unheard:
            talk.end_of_input()

    def _hear_in_between(self, talk: Talk) -> None:
        for index, line in enumerate(list(self._unheard)):
            asked = asked_of_chat(line)
            if asked not in IN_BETWEEN:
                continue
            ends = asked in (Ask.STOP, Ask.CANCEL)
            passed_over = [self._unheard.popleft() for _ in range(index)]
            self._unheard.popleft()
            if not ends:
                self._unheard.extendleft(reversed(passed_over))
            elif passed_over:
                self._write(f"robot: Not begun: {', '.join(map(repr, passed_over))}.")
            talk.hear(line)
            return
