"""What the fake robot felt, now and a while ago, worked out when somebody asks for it; its range sensor."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from robots.control.loop.state_history import KEPT_S
from robots.interface.sensed_state import SensedState

Sense = Callable[[], SensedState]


class _Moment:
    """What is felt at one instant, worked out once."""

    __slots__ = ("_felt", "_sense", "stamp_s")

    def __init__(self, stamp_s: float, sense: Sense) -> None:
        self.stamp_s, self._sense = stamp_s, sense
        self._felt: SensedState | None = None

    def felt(self) -> SensedState:
        if self._felt is None:
            self._felt = self._sense()
        return self._felt


class FakeSensing:
    """The last sensed states; satisfies ``trees.toolbox.Sensing``.

    A task of ten seconds passes through five hundred states, and its leaves look at one in seven: efforts
    of a body that moves take longer than all else that the fake does in a period.
    """

    def __init__(self, stamp_s: float, sense: Sense, period_s: float) -> None:
        """Begin with one state; one follows each period."""
        self._moments = deque([_Moment(stamp_s, sense)], maxlen=round(KEPT_S / period_s))

    def add(self, stamp_s: float, sense: Sense) -> None:
        """Remember how to tell the newest state.

        Args:
            stamp_s: When it is felt.
            sense: Gives it; its answer must depend on nothing that changes later.
        """
        self._moments.append(_Moment(stamp_s, sense))

    def state(self) -> SensedState:
        """The newest one."""
        return self._moments[-1].felt()

    def state_at(self, stamp_s: float) -> SensedState:
        """The remembered one nearest to a time."""
        newest_first = reversed(self._moments)
        nearest = next(newest_first)
        for earlier in newest_first:
            if abs(earlier.stamp_s - stamp_s) >= abs(nearest.stamp_s - stamp_s):
                break
            nearest = earlier
        return nearest.felt()


class FakeRangeSensor:
    """The fake robot's range sensor; satisfies ``RangeSensor``.

    Attributes:
        points_m: What is around, from the body, shape (n, 3).
        silent: While true, there are no scans.
    """

    def __init__(self) -> None:
        """Nothing is around."""
        self.points_m: NDArray[np.float64] = np.zeros((0, 3))
        self.silent = False

    def scan(self) -> NDArray[np.float64] | None:
        """The points, or None while it is silent."""
        return None if self.silent else self.points_m.copy()
