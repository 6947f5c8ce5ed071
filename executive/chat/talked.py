"""The robot that is talked to, and a task that it was given: a served one, or a test's double."""

from __future__ import annotations

from typing import Any, Protocol

from executive.doors.served_robot import TaskStatus


class Begun(Protocol):
    """A task that was begun."""

    @property
    def ended(self) -> bool:
        """Whether it has ended."""
        ...

    def status(self) -> TaskStatus:
        """How it stands."""
        ...

    def news(self, seen: int) -> tuple[tuple[str, ...], int]:
        """Lines of feedback since so many were read, and how many there are now."""
        ...


class Talked(Protocol):
    """The robot that is talked to; as a door sees it."""

    def begin(self, text: str) -> Begun:
        """Begin a task."""
        ...

    def scene(self) -> list[dict[str, Any]]:
        """What it believes to be around it."""
        ...

    def answer(self, text: str) -> bool:
        """Answer its question."""
        ...

    def cancel(self, reason: str) -> bool:
        """End what is under way."""
        ...

    def pause(self, reason: str) -> bool:
        """Hold it."""
        ...

    def resume(self) -> bool:
        """Go on with it."""
        ...

    def stop(self, reason: str) -> None:
        """The emergency stop."""
        ...
