"""What the robot knew about itself, now and a while ago."""

from __future__ import annotations

from collections import deque

from robots.interface.sensed_state import SensedState

KEPT_S = 2.0
"""Pictures are at most some tenths of a second late."""


class StateHistory:
    """The last sensed states: satisfies ``trees.toolbox.Sensing``."""

    def __init__(self, first: SensedState, period_s: float) -> None:
        """Begin with one state; one follows each control period."""
        self._period_s = period_s
        self._states = deque([first], maxlen=round(KEPT_S / period_s))

    def add(self, state: SensedState) -> None:
        """Remember the newest one."""
        self._states.append(state)

    def state(self) -> SensedState:
        """The newest one."""
        return self._states[-1]

    def state_at(self, stamp_s: float) -> SensedState:
        """The remembered one nearest to a time."""
        states = self._states
        back = round((states[-1].readings.stamp_s - stamp_s) / self._period_s)
        guess = min(max(len(states) - 1 - back, 0), len(states) - 1)
        # Periods may have been skipped; walk to the nearest from the guess.
        distance = abs(states[guess].readings.stamp_s - stamp_s)
        for step in (-1, 1):
            while 0 <= guess + step < len(states):
                further = abs(states[guess + step].readings.stamp_s - stamp_s)
                if further >= distance:
                    break
                guess, distance = guess + step, further
        return states[guess]
