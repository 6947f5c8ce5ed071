"""Whether the base of a robot that a person jogs has room, with its hands wherever they were jogged to.

A walk by itself goes with its hands at home, or drawn in, and keeps the room of those. A person walks with a
hand stretched out as well: it counts where it is. Going away from what is near is always possible.
"""

from __future__ import annotations

import math

import numpy as np

from executive.manual.words import BaseJog
from kinematics.arrays import Array
from kinematics.geometry import poses
from kinematics.model.robot_model import RobotModel
from kinematics.model.walking_settings import WalkingSettings
from kinematics.scene.planning_scene import PlanningScene
from kinematics.scene.support_of import top_m
from kinematics.walking.route.path_planning import footprints
from kinematics.walking.route.room import WalkingRoom, stopping_distance_m

_TURN_AHEAD_RAD = 0.5
"""So far a turn on the spot has to have room."""
_PLACES = 9
"""That a hand is looked at on the way ahead: 5 cm apart at most."""
_NEARER_M = 0.01
"""What comes no nearer than this goes away from it, or along it."""


def hand_meets(
    model: RobotModel, q: Array, scene: PlanningScene, settings: WalkingSettings, word: BaseJog
) -> str:
    """Which hand would come to what is believed to be there, for people; empty when none does.

    Args:
        model: The robot.
        q: Configuration, shape (nq,), base in the odometry frame, whose floor is at height 0.
        scene: What is believed.
        settings: Sizes, and how far a walk sways.
        word: Where to.
    """
    needed_m = settings.hand_radius_m + settings.sway_m
    items, prints = tuple(scene.objects.values()), footprints(scene)
    for hand, frame in model.description.tcp_frames.items():
        place = model.frame_pose(q, frame)[:3, 3]
        way = _way(place[:2], q, settings, word)
        for item, taken in zip(items, prints, strict=True):
            if top_m(item) < place[2] - needed_m:
                continue
            away_m = taken.distance_m(way)
            if float(away_m.min()) < min(needed_m, float(away_m[0]) - _NEARER_M):
                return f"the {hand} hand would come to the {item.name}"
    return ""


def why_no_room(room: WalkingRoom, points: Array, settings: WalkingSettings, word: BaseJog) -> str:
    """What the range sensor sees in the way of the body, for people; empty when nothing is.

    Args:
        room: What the robot takes.
        points: Of the range sensor, as for ``WalkingRoom.free_way_m``.
        settings: Sizes.
        word: Where to.
    """
    if word.linear_m_s == 0.0:
        part = room.turn_meets(points, math.copysign(_TURN_AHEAD_RAD, word.angular_rad_s))
        return "" if part is None else f"there is no room to turn for the {part}"
    # what is lower than the hands and beside the legs is passed by
    beside = np.abs(points[:, 1]) > settings.legs_radius_m + settings.sway_m
    ahead = points[~(beside & (points[:, 2] < settings.hands_from_m))]
    free_m = room.free_way_m(ahead, word.linear_m_s)
    if free_m > (needed_m := stopping_distance_m(settings, word.linear_m_s)):
        return ""
    where = "ahead" if word.linear_m_s > 0.0 else "behind"
    return (
        f"an obstacle is {max(free_m, 0.0):.2f} m {where}, nearer than the stopping distance of "
        f"{needed_m:.2f} m"
    )


def _way(place_m: Array, q: Array, settings: WalkingSettings, word: BaseJog) -> Array:
    """Where a point of the body comes by until the robot could stand again, shape (n, 2)."""
    shares = np.linspace(0.0, 1.0, _PLACES)[:, None]
    yaw = poses.yaw_of(poses.rotation_from_quaternion(q[3:7]))
    if word.linear_m_s != 0.0:
        far_m = math.copysign(stopping_distance_m(settings, word.linear_m_s), word.linear_m_s)
        return np.asarray(place_m + shares * far_m * np.array([math.cos(yaw), math.sin(yaw)]))
    angle = shares[:, 0] * math.copysign(_TURN_AHEAD_RAD, word.angular_rad_s)
    x, y = place_m - q[:2]
    c, s = np.cos(angle), np.sin(angle)
    return np.column_stack([q[0] + c * x - s * y, q[1] + s * x + c * y])
