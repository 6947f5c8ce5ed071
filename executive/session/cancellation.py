"""A request's cancel, kept in one place from the moment it is asked for to the end of the request.

A request is a sentence, a script or a ticket: it may carry out several tasks, and wait for answers between
them. Whatever it does when the cancel comes, it ends there, and nothing else of it is begun.
"""

from __future__ import annotations

from executive.session.events import EventSink, InputTaken
from trees.failures import Failure, FailureKind


class Cancellation:
    """Whether one request is to be halted, and why; the first reason that was given stays."""

    def __init__(self) -> None:
        self._reason: str | None = None
        self._told = False

    @property
    def asked(self) -> bool:
        """Whether somebody has asked for it."""
        return self._reason is not None

    def ask(self, reason: str) -> None:
        """Have the request halted; safe to call from another thread or a signal handler."""
        if self._reason is None:
            self._reason = reason

    def taken(self, now_s: float, sink: EventSink) -> Failure | None:
        """What the request ends with, or None while nobody has asked.

        Args:
            now_s: Simulated time.
            sink: Told of the cancel, once.
        """
        if self._reason is None:
            return None
        if not self._told:
            self._told = True
            sink(InputTaken(now_s, "cancel", self._reason))
        return Failure(FailureKind.CANCELED, self._reason)
