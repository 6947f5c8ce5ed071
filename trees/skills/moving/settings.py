"""Numbers of walking at a velocity; each with its reason."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class MoveSettings:
    """Numbers of walking at a velocity.

    Attributes:
        fastest_m_s, fastest_rad_s: Speed limits of a walk; the robot's own may be lower.
        move_s: How long a move takes that is asked for without an end.
        silence_s: Velocities that are sent while the robot walks end the walk when none has come for so long.
    """

    fastest_m_s: float = 0.5
    fastest_rad_s: float = 1.0
    move_s: float = 3.0
    silence_s: float = 1.0
