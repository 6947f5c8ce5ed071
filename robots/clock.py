"""Time, injected. The only module that may read the wall clock."""

from __future__ import annotations

import time
from datetime import datetime
from typing import Protocol


class Clock(Protocol):
    """A source of seconds that never runs backwards."""

    def now_s(self) -> float:
        """Seconds since the clock's own start."""
        ...


class ManualClock:
    """A clock that moves only when it is told to: simulated time."""

    def __init__(self) -> None:
        self._ticks_ns = 0

    def now_s(self) -> float:
        """Seconds since the start."""
        return self._ticks_ns * 1e-9

    def advance(self, seconds: float) -> None:
        """Move forward; counted in whole nanoseconds so that sums stay exact.

        Raises:
            ValueError: ``seconds`` is negative.
        """
        if seconds < 0.0:
            raise ValueError(f"time cannot run backwards: {seconds} s")
        self._ticks_ns += round(seconds * 1e9)


class WallClock:
    """Monotonic wall time since it was made; for reports and live runs, never for decisions in lockstep."""

    def __init__(self) -> None:
        self._start_s = time.monotonic()

    def now_s(self) -> float:
        """Seconds since the clock was made."""
        return time.monotonic() - self._start_s

    def sleep(self, seconds: float) -> None:
        """Let wall time pass; nothing at all when ``seconds`` is not positive."""
        if seconds > 0.0:
            time.sleep(seconds)


class ProcessorClock:
    """Processor time of this process; for reports only: it does not count what other processes take."""

    def now_s(self) -> float:
        """Seconds that this process has computed."""
        return time.process_time()


def utc_timestamp() -> str:
    """The date and time of day in UTC, ISO 8601, for names of runs and reports."""
    return time.strftime("%Y-%m-%dT%H:%M:%SZ", time.gmtime())


def utc_ns() -> int:
    """Wall time since 1970 in nanoseconds, as other programs stamp what they say; for messages only."""
    return time.time_ns()


def local_time() -> datetime:
    """The date and time of day where this machine is, to the second, without a zone."""
    return datetime.fromtimestamp(int(time.time()))
