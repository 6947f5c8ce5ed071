"""How far the way is free in the direction of a walk."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from kinematics.walking.settings import WalkingSettings

Array = NDArray[np.float64]

_REACTION_S = 0.2
"""From a reading to the stop: readings are a tenth of a second apart, the tree ticks at 50 Hz."""
_ROOM_M = 0.05


def free_way_m(points: Array, settings: WalkingSettings, linear_m_s: float) -> float:
    """Distance from the robot's front, or its back, to the nearest thing in its way; infinite if none.

    Args:
        points: What a range sensor sees, in a level frame at the base, x ahead, shape (n, 3).
        settings: How much room the robot takes.
        linear_m_s: Its sign tells which way it goes.
    """
    ahead = points[:, 0] if linear_m_s >= 0.0 else -points[:, 0]
    own_m = settings.front_m if linear_m_s >= 0.0 else settings.back_m
    hands = points[:, 2] >= settings.hands_from_m
    room_m = np.where(hands, settings.hands_half_width_m, settings.half_width_m)
    in_way = (np.abs(points[:, 1]) <= room_m) & (ahead > 0.0)
    return float(np.min(ahead[in_way] - own_m, initial=np.inf))


def stopping_distance_m(settings: WalkingSettings, linear_m_s: float) -> float:
    """How far a robot at this speed may still go after it was told to stop, with some room.

    Two steps at most: the one that is under way and the one that closes the feet, which brings the body on
    by half as much again.
    """
    return abs(linear_m_s) * (_REACTION_S + 1.5 * settings.step_s) + _ROOM_M
