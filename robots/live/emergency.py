"""The emergency latch of the control process."""

from __future__ import annotations

from robots.control.control_loop import ControlLoop


class Emergency:
    """Engaged by anybody, left by a person's reset alone.

    Attributes:
        engaged: Why it is engaged; empty when it is not.
        category: Of the stop that was made; severer ones replace milder ones.
    """

    def __init__(self, loop: ControlLoop) -> None:
        self._loop = loop
        self.engaged = ""
        self.category = 1

    def engage(self, category: int, reason: str) -> None:
        """Stop, and latch."""
        if self.engaged and not (category == 0 and self.category != 0):
            return
        self.engaged, self.category = reason or "no reason was given", category
        self._loop.stop(category, f"emergency stop: {self.engaged}")

    def reset(self) -> str | None:
        """Leave it; or say what stands against that."""
        if not self.engaged:
            return "the emergency stop is not engaged"
        if self.category == 0:
            return "the power was taken away; only a new start gives it back"
        if not self._loop.motion.resting:
            return "the robot is not at rest yet"
        self.engaged = ""
        return None
