"""The conversation on a terminal with a screen: what is said, the tree, and the line that is typed."""

from __future__ import annotations

import codecs
from collections import deque
from collections.abc import Callable, Sequence
from typing import Protocol

from rich.console import Console
from rich.live import Live

from executive.chat.chat_screen import ChatView, chat_screen
from executive.chat.input_line import InputLine, Wish
from executive.chat.robot_watch import RobotStanding
from executive.chat.talk import Talk
from executive.chat.utterance import Utterance
from executive.screens.display import painted
from executive.screens.rows import Row
from robots.clock import WallClock

_DRAWN_EVERY_S = 0.1
_LOOK_EVERY_S = 0.03
_KEPT_LINES = 200
_KEPT_SAID = 500
_SCROLLED_BY = 5


class Typing(Protocol):
    """Where keys come from."""

    def typed(self, timeout_s: float) -> bytes | None:
        """What has been typed; None once nobody types any more."""
        ...


class ScreenChat:
    """Draws, and takes keys.

    Args:
        console: The terminal.
        keyboard: Its keys.
        place: Robot and scene, in a few words.
        standing: How the robot stands now.
        history: Lines that were typed in chats before.

    Attributes:
        said: The conversation.
        line: What is being typed, with the lines before it.
    """

    def __init__(
        self,
        console: Console,
        keyboard: Typing,
        place: str,
        standing: Callable[[], RobotStanding],
        history: Sequence[str] = (),
    ) -> None:
        self._console, self._keyboard, self._place = console, keyboard, place
        self._standing = standing
        self.said: deque[Utterance] = deque(maxlen=_KEPT_SAID)
        self._log: deque[str] = deque(maxlen=_KEPT_LINES)
        self.line = InputLine(history)
        self._back = 0
        self._decoder = codecs.getincrementaldecoder("utf-8")("replace")
        self._has_gone = False

    def show(self, said: Utterance) -> None:
        """Keep what was said; the newest is in sight again."""
        self.said.append(said)
        self._back = 0

    def log(self, line: str) -> None:
        """Keep a line of feedback."""
        self._log.append(line)

    def clear_line(self) -> bool:
        """Forget what is typed; whether there was something."""
        return self.line.clear()

    def run(self, talk: Talk, each: Callable[[], None]) -> None:
        """Talk until it is over; the terminal is left as it was found.

        Args:
            talk: The conversation.
            each: Called again and again: signals.
        """
        wall, drawn_s, before = WallClock(), -_DRAWN_EVERY_S, None
        with Live(console=self._console, screen=True, auto_refresh=False, redirect_stderr=False) as live:
            while not talk.is_over:
                each()
                self.take_keys(talk, _LOOK_EVERY_S)
                talk.poll()
                now_s, view = wall.now_s(), self.view(talk)
                is_typed = before is not None and (view.text, view.cursor) != (before.text, before.cursor)
                if is_typed or now_s - drawn_s >= _DRAWN_EVERY_S:
                    drawn_s, before = now_s, view
                    live.update(painted(self.rows(view)), refresh=True)

    def rows(self, view: ChatView) -> list[Row]:
        """What is drawn."""
        unicode = self._console.encoding.lower().startswith("utf")
        return chat_screen(view, self._console.width, self._console.height, unicode)

    def view(self, talk: Talk) -> ChatView:
        """What is shown now."""
        return ChatView(
            self._place,
            self._standing(),
            talk.under_way,
            talk.question is not None,
            len(talk.waiting),
            tuple(self.said),
            tuple(self._log),
            self.line.text,
            self.line.cursor,
            self._back,
        )

    def take_keys(self, talk: Talk, within_s: float) -> None:
        """Do what was typed."""
        typed = b"" if self._has_gone else self._keyboard.typed(within_s)
        if typed is None:
            self._has_gone = True
            talk.end("the terminal has gone")
            return
        for one in self.line.feed(self._decoder.decode(typed)):
            match one:
                case Wish.STOP:
                    talk.stop()
                case Wish.PAUSE:
                    talk.pause()
                case Wish.END:
                    talk.end_of_input()
                case Wish.BACK:
                    self._back += _SCROLLED_BY
                case Wish.FORTH:
                    self._back = max(self._back - _SCROLLED_BY, 0)
                case str():
                    talk.hear(one)
