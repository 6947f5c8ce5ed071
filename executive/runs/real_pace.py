"""Simulated time that passes no faster than time does: for somebody who watches."""

from __future__ import annotations

from typing import Protocol

from executive.session.lockstep import PERIODS_A_TICK
from robots.control.period import PERIOD_S


class Wall(Protocol):
    """A clock that can wait."""

    def now_s(self) -> float:
        """Seconds since it was made."""
        ...

    def sleep(self, seconds: float) -> None:
        """Let time pass."""
        ...


class RealPace:
    """Lets simulated time pass no faster than time does: waits once a tick for what is left of the tick.

    A machine that is too slow is not waited for: nothing that was lost is made up for later.
    """

    def __init__(self, wall: Wall) -> None:
        self._wall = wall
        self._periods = 0
        self._due_s: float | None = None

    def __call__(self) -> None:
        """Wait, if this period ends a tick that was computed too soon."""
        self._periods += 1
        if self._periods % PERIODS_A_TICK:
            return
        now_s = self._wall.now_s()
        due_s = now_s if self._due_s is None else max(self._due_s + PERIODS_A_TICK * PERIOD_S, now_s)
        self._wall.sleep(due_s - now_s)
        self._due_s = due_s
