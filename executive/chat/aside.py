"""Calls that may take a while, made beside the conversation, so that a stop never waits for them."""

from __future__ import annotations

import queue
import threading
from collections.abc import Callable
from typing import TypeVar

from executive.errors import UserError
from robots.live.wire.errors import LiveError

T = TypeVar("T")
_Done = Callable[[], None]


class Aside:
    """Makes calls in threads of their own; what they return is taken when it is asked for."""

    def __init__(self) -> None:
        self._done: queue.SimpleQueue[_Done] = queue.SimpleQueue()
        self._awaited = 0

    @property
    def is_idle(self) -> bool:
        """Whether every call has returned, and that was taken."""
        return self._awaited == 0

    def do(self, call: Callable[[], T], then: Callable[[T], None], wrong: Callable[[str], None]) -> None:
        """Make a call.

        Args:
            call: What is called, in another thread.
            then: Takes what it returns, in the thread that calls ``settle``.
            wrong: Takes why the robot, or whoever was called, did not answer; likewise.
        """
        self._awaited += 1

        def make() -> None:
            try:
                returned = call()
            except (LiveError, UserError) as gone:
                reason = str(gone)
                self._done.put(lambda: wrong(reason))
            else:
                self._done.put(lambda: then(returned))

        threading.Thread(target=make, name="aside of the chat", daemon=True).start()

    def settle(self) -> None:
        """Take what has been returned since."""
        while True:
            try:
                done = self._done.get_nowait()
            except queue.Empty:
                return
            self._awaited -= 1
            done()
