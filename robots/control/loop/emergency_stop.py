"""The emergency stop's latch: once engaged, nothing but a person's reset opens it.

Engaging is the control loop's part: it ends every motion and brakes. The latch remembers why, and
says under which conditions it opens.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

STOP_CATEGORIES = (0, 1, 2)
"""0 takes the power away, 1 brakes along the path, 2 brings every joint to rest at once."""


@dataclass(frozen=True, slots=True)
class EmergencyStop:
    """An engaged emergency stop.

    Attributes:
        t_s: When it was engaged.
        category: The severest stop category that was asked for since.
        reason: Why, for people.
    """

    t_s: float
    category: int
    reason: str

    def __str__(self) -> str:
        return f"the emergency stop is engaged: {self.reason}"


@dataclass(frozen=True, slots=True)
class PersonsReset:
    """A person's explicit request to leave the emergency stop.

    Made where a person's command comes in (a command line, a key), and nowhere else.

    Attributes:
        person: Who asked, for the log.
    """

    person: str


class EmergencyLatch:
    """Remembers whether the emergency stop is engaged.

    Attributes:
        engaged: The stop, or None.
    """

    def __init__(self) -> None:
        self.engaged: EmergencyStop | None = None

    def engage(self, t_s: float, category: int, reason: str) -> bool:
        """Engage; tell whether that asks for anything that was not asked for before.

        Raises:
            ValueError: There is no such category.
        """
        require_category(category)
        before = self.engaged
        if before is None:
            self.engaged = EmergencyStop(t_s, category, reason)
            return True
        if category == 0 and before.category != 0:
            self.engaged = EmergencyStop(before.t_s, 0, reason)
            return True
        return False

    def why_not_open(self, resting: bool, defects: Sequence[str]) -> str | None:
        """Tell what stands against a reset, or None.

        Args:
            resting: Whether nothing moves any more.
            defects: What is wrong with the robot now, for people.
        """
        if self.engaged is None:
            return "no emergency stop is engaged"
        if self.engaged.category == 0:
            return "the power was taken away; the robot has to be set up and started anew"
        if not resting:
            return "the robot has not come to rest yet"
        return f"the robot is not healthy: {'; '.join(defects)}" if defects else None

    def open(self) -> None:
        """Leave the emergency stop."""
        self.engaged = None


def require_category(category: int) -> None:
    """Refuse what is no stop category.

    Raises:
        ValueError: There is no such category.
    """
    if category not in STOP_CATEGORIES:
        raise ValueError(f"no stop category {category}; there are 0, 1 and 2")
