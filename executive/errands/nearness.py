"""Is a walk needless? What a hand gets to from here, or furniture that the robot stands before already.

What the robot was set before, a table for example, is at hand without a walk until it has turned or gone away
from where it began.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from kinematics.geometry.planar import PlanarPose, wrapped
from kinematics.geometry.poses import Transform
from kinematics.scene.planning_scene import PlanningScene
from trees.beliefs.grounding.furniture_called import called_so
from trees.beliefs.grounding.grounding import Found, ground
from trees.beliefs.scene.believed_thing import BelievedThing, Surroundings
from trees.beliefs.scene.furniture_pieces import gap_to_furniture_m
from trees.skills.moving import AWAY_M, AWAY_RAD
from trees.tasks import ObjectDescription

_AHEAD_M = (0.3, 0.65)
_ASIDE_M = 0.45
"""Where hands get to a thing on furniture without a step, from the feet: ``tools.evaluate pick`` has its cups
there."""
_BEFORE_M = 0.45
"""So near to furniture the robot stands before it."""


@dataclass(frozen=True, slots=True)
class Nearness:
    """What has to be within reach, or stood before already, for a walk to be needless.

    Attributes:
        thing: What is walked to, or what is to be picked up from there.
        within_reach: Whether a thing has to be within reach, and the robot has to stand before furniture;
            otherwise it is enough that it was seen.
    """

    thing: ObjectDescription
    within_reach: bool = True


def is_near(wanted: Nearness, around: Surroundings, scene: PlanningScene, odom_T_base: Transform) -> bool:
    """Tell whether one thing that was seen fits, and is near enough.

    Args:
        wanted: What, and how near.
        around: What is believed, from where the robot stands.
        scene: The same in the odometry frame.
        odom_T_base: Pose of the robot's base, shape (4, 4).
    """
    found = ground(wanted.thing, around)
    if isinstance(found, Found):
        one = next(thing for thing in around.things if thing.name == found.names[0])
        before = not one.movable and _is_before(one, scene, odom_T_base)
        return not wanted.within_reach or before or _is_within_reach(one)
    name, words = wanted.thing.name, called_so(wanted.thing.kind or "", around.furniture_words)
    return wanted.within_reach and any(
        (thing.name == name or (name is None and thing.kind in words))
        and _is_before(thing, scene, odom_T_base)
        for thing in around.things
        if not thing.movable
    )


def _is_within_reach(thing: BelievedThing) -> bool:
    ahead, aside, _ = thing.place_m.tolist()
    return bool(_AHEAD_M[0] <= ahead <= _AHEAD_M[1] and abs(aside) <= _ASIDE_M)


def _is_before(furniture: BelievedThing, scene: PlanningScene, odom_T_base: Transform) -> bool:
    is_ahead = furniture.place_m[0] >= 0.0
    return bool(is_ahead and gap_to_furniture_m(scene.objects[furniture.name], odom_T_base) <= _BEFORE_M)


def is_away(body: PlanarPose) -> bool:
    """Tell it from where the base is in the odometry frame, whose origin is where the robot began."""
    return abs(wrapped(body.yaw_rad)) > AWAY_RAD or math.hypot(body.x_m, body.y_m) > AWAY_M
