"""Keeps a loop in step with the wall clock, and says how late it is."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Protocol

MAX_CATCH_UP_S = 0.1
"""Of being late, so much is caught up with; beyond it the simulated world has stood still with us."""
CATCH_UP_SHARE = 0.2
"""And no more than this share of control time in the long run: a machine that is always late would let the
world go on under one setpoint most of the time. There it goes on slowly instead, and is commanded."""
_EDGES_PER_DECADE = 5
_LEAST_S, _DECADES = 1e-5, 6


class RealTime(Protocol):
    """Wall time that one can wait in."""

    def now_s(self) -> float:
        """Seconds since some start."""
        ...

    def sleep(self, seconds: float) -> None:
        """Let it pass."""
        ...


@dataclass(frozen=True, slots=True)
class Lateness:
    """How late the periods began, in ms of wall time.

    Attributes:
        periods: How many there were.
        late: How many began a whole period late or more.
        lost_s: Control time that was given up because nothing could catch up with it.
        held_s: Control time that stood still for a commander who got no processor.
        p50_ms, p99_ms, worst_ms: Percentiles (upper edges of the histogram's bins) and the worst.
        histogram: Upper edge in ms, and how many were below it and not below the one before.
    """

    periods: int
    late: int
    lost_s: float
    held_s: float
    p50_ms: float
    p99_ms: float
    worst_ms: float
    histogram: tuple[tuple[float, int], ...]


class Pacer:
    """Paces the control loop: waits until the next period is due in wall time.

    Args:
        wall: The wall clock.
        period_s: Control period.
        pace: Control time that passes in a second of wall time; 0 does not wait at all.

    Attributes:
        pace: The same, now.
    """

    def __init__(self, wall: RealTime, period_s: float, pace: float = 1.0) -> None:
        self._wall, self._period_s = wall, period_s
        self._counts = [0] * (_EDGES_PER_DECADE * _DECADES + 2)
        self._worst_s, self._late, self._lost_s, self._held_s = 0.0, 0, 0.0, 0.0
        self._step_s, self._due_s = 0.0, 0.0
        self._credit_s = MAX_CATCH_UP_S
        self.set_pace(pace)

    def set_pace(self, pace: float) -> None:
        """Go on at another pace from now on."""
        self.pace = pace
        self._step_s = self._period_s / pace if pace > 0.0 else 0.0
        self._due_s = self._wall.now_s() + self._step_s

    def wait(self) -> int:
        """Wait until the next period is due.

        Returns:
            How many whole periods have been missed and are to be caught up with: at most 0.1 s of them, and
            a fifth of control time in the long run.
        """
        if self._step_s == 0.0:
            return 0
        self._wall.sleep(self._due_s - self._wall.now_s())
        late_s = max(0.0, self._wall.now_s() - self._due_s)
        self._note(late_s)
        missed = int(late_s / self._step_s)
        self._credit_s = min(MAX_CATCH_UP_S, self._credit_s + CATCH_UP_SHARE * self._period_s)
        most = int(self._credit_s / self._period_s + 1e-6)
        if missed > most:
            self._lost_s += (missed - most) * self._period_s
            self._due_s += (missed - most) * self._step_s
            missed = most
        self._late += missed > 0
        self._credit_s -= missed * self._period_s
        self._due_s += (missed + 1) * self._step_s
        return missed

    def hold(self, seconds: float) -> None:
        """Let wall time pass that is none of control time's; the next period is due afterwards."""
        self._wall.sleep(seconds)
        self._held_s += seconds * self.pace
        self._due_s = self._wall.now_s()

    def lateness(self) -> Lateness:
        """How late the periods were until now."""
        total = sum(self._counts)
        histogram = tuple((1e3 * _edge_s(i), n) for i, n in enumerate(self._counts) if n)
        return Lateness(
            periods=total,
            late=self._late,
            lost_s=round(self._lost_s, 6),
            held_s=round(self._held_s, 6),
            p50_ms=self._percentile_ms(0.50, total),
            p99_ms=self._percentile_ms(0.99, total),
            worst_ms=1e3 * self._worst_s,
            histogram=histogram,
        )

    def _note(self, late_s: float) -> None:
        self._worst_s = max(self._worst_s, late_s)
        if late_s <= _LEAST_S:
            self._counts[0] += 1
            return
        place = math.ceil(_EDGES_PER_DECADE * math.log10(late_s / _LEAST_S))
        self._counts[min(place, len(self._counts) - 1)] += 1

    def _percentile_ms(self, share: float, total: int) -> float:
        below = 0
        for i, count in enumerate(self._counts):
            below += count
            if below >= share * total and below > 0:
                return 1e3 * _edge_s(i)
        return 0.0


def _edge_s(bin_number: int) -> float:
    return float(_LEAST_S * 10.0 ** (bin_number / _EDGES_PER_DECADE))
