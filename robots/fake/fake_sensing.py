"""What the fake robot felt, now and a while ago, worked out when somebody asks for it."""

from __future__ import annotations

import functools
from collections.abc import Callable

from robots.control.state_history import KEPT_S
from robots.sensed_state import SensedState

Sense = Callable[[], SensedState]


class FakeSensing:
    """The last sensed states; satisfies ``trees.toolbox.Sensing``.

    A task of ten seconds passes through five hundred states, and its leaves look at one in seven: efforts
    of a body that moves take longer than all else that the fake does in a period.
    """

    def __init__(self, stamp_s: float, sense: Sense, period_s: float) -> None:
        """Begin with one state; one follows each period."""
        self._kept = round(KEPT_S / period_s)
        self._states: list[tuple[float, Sense]] = [(stamp_s, functools.cache(sense))]

    def add(self, stamp_s: float, sense: Sense) -> None:
        """Remember how to tell the newest state.

        Args:
            stamp_s: When it is felt.
            sense: Gives it; its answer must depend on nothing that changes later.
        """
        self._states.append((stamp_s, functools.cache(sense)))
        del self._states[: -self._kept]

    def state(self) -> SensedState:
        """The newest one."""
        return self._states[-1][1]()

    def state_at(self, stamp_s: float) -> SensedState:
        """The remembered one nearest to a time."""
        newest_first = reversed(self._states)
        nearest_s, nearest = next(newest_first)
        for earlier_s, earlier in newest_first:
            if abs(earlier_s - stamp_s) >= abs(nearest_s - stamp_s):
                break
            nearest_s, nearest = earlier_s, earlier
        return nearest()
