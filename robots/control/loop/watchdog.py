"""Notices that whoever commands the robot has fallen silent while something is under way."""

from __future__ import annotations

from robots.clock import Clock

CHECK_EVERY_S = 0.1
"""Time between two looks."""
SILENCE_S = 1.0
"""Silence that is too long."""
_ROUNDING_S = 1e-9


class Watchdog:
    """Counts the time since the last sign of life; looks every 0.1 s.

    What is counted is control time. A control process that was kept from running is late itself, and
    reads what has arrived meanwhile before it looks: its own absence is nobody's silence.
    """

    def __init__(self, clock: Clock) -> None:
        """Begin with a sign of life now."""
        self._clock = clock
        self._heard_s = clock.now_s()
        self._look_s = self._heard_s + CHECK_EVERY_S

    def feed(self) -> None:
        """Take a sign of life: a heartbeat or a command."""
        self._heard_s = self._clock.now_s()

    def silence_s(self, under_way: bool) -> float | None:
        """Look, when it is time to.

        Args:
            under_way: Whether anything moves or is being carried out; while nothing is, nobody needs
                to say anything.

        Returns:
            How long the silence has lasted when it is too long, else None.
        """
        now_s = self._clock.now_s()
        if not under_way:
            self._heard_s = now_s
        if now_s + _ROUNDING_S < self._look_s:
            return None
        self._look_s = now_s + CHECK_EVERY_S
        silence_s = now_s - self._heard_s
        if silence_s + _ROUNDING_S < SILENCE_S:
            return None
        self._heard_s = now_s
        return silence_s
