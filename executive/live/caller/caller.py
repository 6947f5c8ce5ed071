"""Calls a served robot from another process: one question, one answer; or a sentence and its feedback."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from robots.clock import WallClock
from robots.live.wire.connection import Connection
from robots.live.wire.errors import LiveError
from robots.live.wire.messages import read_object
from robots.live.wire.unix_socket import connect_to

ANSWER_WITHIN_S = 5.0


class NoAnswerError(LiveError):
    """The other side does not answer, or has ended the connection."""


class SilentError(NoAnswerError):
    """The other side has said nothing for as long as it was waited for; the connection still stands."""


def ask_at(path: Path, message: bytes, within_s: float = ANSWER_WITHIN_S) -> dict[str, Any]:
    """Ask one thing there, hear the answer, and hang up.

    Raises:
        NotServedError: Nobody listens there.
        NoAnswerError: None came in time.
    """
    caller = Caller(path)
    try:
        return caller.ask(message, within_s)
    finally:
        caller.close()


class Caller:
    """A connection to a served robot for somebody who asks, and reads the answers."""

    def __init__(self, path: Path) -> None:
        """Connect.

        Raises:
            NotServedError: Nobody listens there.
        """
        self._connection = Connection(connect_to(path))
        self._wall = WallClock()

    @property
    def peer_pid(self) -> int:
        """The process that listens there."""
        return self._connection.peer.pid

    def send(self, message: bytes) -> None:
        """Send without waiting."""
        self._connection.send(message)

    def ask(self, message: bytes, within_s: float = ANSWER_WITHIN_S) -> dict[str, Any]:
        """Send a message and wait for the first answer.

        Raises:
            NoAnswerError: None came in time.
        """
        self.send(message)
        answers: list[dict[str, Any]] = []

        def take(answer: dict[str, Any]) -> bool:
            answers.append(answer)
            return True

        self.listen(take, within_s)
        return answers[0]

    def listen(self, take: Callable[[dict[str, Any]], bool], within_s: float | None = None) -> None:
        """Take answers until one ends it.

        Args:
            take: Called with each answer; true when it was the last one.
            within_s: Wall time to wait for the whole, or None.

        Raises:
            SilentError: The time ended before.
            NoAnswerError: The connection did.
        """
        until_s = None if within_s is None else self._wall.now_s() + within_s
        while True:
            for frame in self._connection.receive(1):
                if take(read_object(frame.payload)):
                    return
            if self._connection.more:
                continue
            if self._connection.closed:
                raise NoAnswerError("the connection ended before the answer")
            left_s = 0.5 if until_s is None else until_s - self._wall.now_s()
            if left_s <= 0.0:
                raise SilentError(f"no answer within {within_s:g} s")
            self._connection.flush()
            self._connection.wait(min(left_s, 0.5))

    def poll(self) -> list[dict[str, Any]]:
        """Messages that have arrived since the last look, without waiting.

        Raises:
            NoAnswerError: The connection has ended.
        """
        frames = self._connection.receive()
        self._connection.flush()
        if self._connection.closed and not frames:
            raise NoAnswerError("the connection ended")
        return [read_object(frame.payload) for frame in frames]

    def arrived(self, kind: str) -> list[dict[str, Any]]:
        """Messages of one type that have arrived since the last look; others are dropped.

        Raises:
            NoAnswerError: The connection has ended.
        """
        found: list[dict[str, Any]] = []
        while True:
            frames = self._connection.receive()
            found += [read_object(frame.payload) for frame in frames]
            if self._connection.closed:
                raise NoAnswerError("the connection ended")
            if not frames:
                return [message for message in found if message["type"] == kind]

    def close(self) -> None:
        """End the connection."""
        self._connection.close("")
