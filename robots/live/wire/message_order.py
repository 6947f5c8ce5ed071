"""Numbers and stamps of a commander's messages: what is new, what was left out, what is of another time."""

from __future__ import annotations

from collections.abc import Callable

from robots.clock import Clock

MAX_AGE_S = 0.5
"""A command that is older was meant for a world that is gone; also the age at which a heartbeat is none."""
MAX_AHEAD_S = 0.01
_TOLD_LOST = 64
"""Of so many messages that never arrived their sender is told."""


class MessageOrder:
    """Checks that the numbered messages of one commander come in order, none twice.

    Args:
        clock: Control time.
        lost: Told the number of each message that was left out.

    Attributes:
        number: Of the newest message.
    """

    def __init__(self, clock: Clock, lost: Callable[[int], None]) -> None:
        self._clock, self._lost = clock, lost
        self.number = 0

    def begin(self) -> None:
        """There is another commander."""
        self.number = 0

    def is_next(self, number: int) -> bool:
        """Whether a number is a new one; it is the newest from now on."""
        if number <= self.number:
            return False
        for missing in range(max(self.number + 1, number - _TOLD_LOST), number):
            self._lost(missing)
        self.number = number
        return True

    def age_s(self, stamp_s: float) -> float:
        """How long ago a message was sent, of control time."""
        return self._clock.now_s() - stamp_s

    def is_fresh(self, stamp_s: float) -> bool:
        """Whether it was sent a short while ago, and not in the future."""
        return -MAX_AHEAD_S <= self.age_s(stamp_s) <= MAX_AGE_S
