"""Has the robot turned or gone away from where it was when it began?

What it was set before, a table for example, is at hand without a walk until then.
"""

from __future__ import annotations

import math

from kinematics.geometry.planar import PlanarPose, wrapped
from trees.tasks import MoveTask

_TURNED_RAD = 0.7
"""Heads turn farther than this by themselves: what was ahead is in view still."""
_GONE_M = 0.5
"""Hands do not get to what was in the middle of their reach."""


def is_away(body: PlanarPose) -> bool:
    """Tell it from where the base is in the odometry frame, whose origin is where the robot began."""
    return abs(wrapped(body.yaw_rad)) > _TURNED_RAD or math.hypot(body.x_m, body.y_m) > _GONE_M


def leads_away(move: MoveTask) -> bool:
    """Tell it of a velocity that is going to be driven; one without an end leads anywhere."""
    seconds = math.inf if move.duration_s is None else move.duration_s
    turn_rad = abs(move.angular_rad_s) * seconds if move.angular_rad_s else 0.0
    far_m = abs(move.linear_m_s) * seconds if move.linear_m_s else 0.0
    if move.distance_m is not None:
        far_m = min(far_m, abs(move.distance_m))
    return turn_rad > _TURNED_RAD or far_m > _GONE_M
