"""A further step at the end of a walk, for a body that both soles together cannot hold any more."""

from __future__ import annotations

import math
from dataclasses import dataclass

from kinematics.geometry.planar import PlanarPose
from kinematics.model.walking_settings import WalkingSettings
from kinematics.walking.pattern.dcm import Point
from kinematics.walking.pattern.steering import Steering

SHIFT_S = 0.35
"""From both feet to the first lift: half of what setting out takes, for what tips goes on tipping."""
_AHEAD = 1.6
"""Of the way of the DCM beyond where both soles rest: what it goes on by until the foot lands."""
_THERE_M = 0.06
"""Nobody wants to be just there."""


@dataclass(frozen=True, slots=True)
class SteppingOn:
    """Go to a place by the longest steps that the robot makes, then go on by another steering.

    Attributes:
        settings: The robot's.
        goal: Where the body is to get, in the odometry frame.
        then: The steering that takes over there.
    """

    settings: WalkingSettings
    goal: PlanarPose
    then: Steering

    def advance(self, body: PlanarPose, before: PlanarPose) -> PlanarPose | None:
        """What is left, or a longest step of it."""
        left, s = body.to(self.goal), self.settings
        if math.hypot(left.x_m, left.y_m) < _THERE_M:
            return self.then.advance(body, before)
        x = min(max(left.x_m, -s.backward_m), s.forward_m)
        y = min(max(left.y_m, -s.sideways_m), s.sideways_m)
        return PlanarPose(x, y)


def stepping_on(
    settings: WalkingSettings, odom_T_body: PlanarPose, beyond: Point, then: Steering
) -> SteppingOn:
    """The way towards where the body tips.

    Args:
        settings: The robot's.
        odom_T_body: The middle between the feet.
        beyond: The DCM as measured, seen from where it rests above both feet, in the body's frame, m.
        then: What follows.
    """
    x = min(max(_AHEAD * beyond[0], -settings.backward_m), settings.forward_m)
    y = min(max(_AHEAD * beyond[1], -settings.sideways_m), settings.sideways_m)
    return SteppingOn(settings, odom_T_body @ PlanarPose(x, y), then)
