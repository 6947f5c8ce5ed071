"""Velocities that somebody sends while the robot walks at them: the newest one, and when it was heard."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class HeardVelocity:
    """A velocity of the base.

    Attributes:
        linear_m_s: Forward speed.
        angular_rad_s: Turning speed, to the left.
        heard_s: Control time at which it came.
    """

    linear_m_s: float
    angular_rad_s: float
    heard_s: float


class VelocityFeed:
    """Holds the newest velocity; what is older is forgotten.

    Attributes:
        newest: It, or None before the first one.
    """

    def __init__(self) -> None:
        self.newest: HeardVelocity | None = None

    def hear(self, linear_m_s: float, angular_rad_s: float, now_s: float) -> None:
        """Take a velocity in the place of the one before."""
        self.newest = HeardVelocity(linear_m_s, angular_rad_s, now_s)
