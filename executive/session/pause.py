"""A pause of the request under way: asked for at any time, begun and ended between two ticks."""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol

from executive.session.events import EventSink, InputTaken


class Pausable(Protocol):
    """What can hold the robot in the middle of what it does: the control loop, or a client of one."""

    def pause(self, reason: str) -> None:
        """Brake and hold; what is under way stays under way."""
        ...

    def resume(self) -> None:
        """Go on with it."""
        ...


class Pause:
    """Holds the robot while a pause is asked for.

    Args:
        pausing: Holds the robot; without one, what it is doing goes on to its end.
        sink: Told when a pause begins, and when it ends.
        now_s: Simulated time.

    Attributes:
        held: Whether a task is held now.
    """

    def __init__(self, pausing: Pausable | None, sink: EventSink, now_s: Callable[[], float]) -> None:
        self._pausing, self._sink, self._now_s = pausing, sink, now_s
        self._reason: str | None = None
        self.held = False

    def ask(self, reason: str) -> None:
        """Ask for a pause; safe to call from a signal handler."""
        self._reason = reason

    def withdraw(self) -> None:
        """Ask for no pause any more; safe to call from a signal handler."""
        self._reason = None

    def follow(self) -> bool:
        """Begin or end the pause as asked for; tells whether there is one."""
        reason = self._reason
        if (reason is not None) != self.held:
            self.held = reason is not None
            self._sink(InputTaken(self._now_s(), "pause" if self.held else "resume", reason or ""))
            if self._pausing is not None:
                if reason is not None:
                    self._pausing.pause(reason)
                else:
                    self._pausing.resume()
        return self.held

    def end(self) -> None:
        """End the pause with the task that it held.

        One that was asked for in the task's last moment, and has not begun, holds the next task.
        """
        if self.held:
            self.withdraw()
            self.follow()
