"""How far a robot that walks goes on after it is told to stop."""

from __future__ import annotations

from kinematics.model.walking_settings import WalkingSettings

_REACTION_S = 0.2
"""From a reading to the stop: readings are a tenth of a second apart, the tree ticks at 50 Hz."""
_ROOM_M = 0.05


def stopping_distance_m(settings: WalkingSettings, linear_m_s: float) -> float:
    """How far a robot at this speed may still go after it was told to stop, with some room.

    Two steps at most: the one that is under way and the one that closes the feet, which brings the body on
    by half as much again.
    """
    return abs(linear_m_s) * (_REACTION_S + 1.5 * settings.step_s) + _ROOM_M
