"""Whether the base of a robot that a person jogs has room, with its hands wherever they were jogged to.

A walk by itself goes with its hands at home, or drawn in, and keeps the room of those. A person walks with a
hand stretched out as well: each link counts where it is, and so does what is believed to be where the range
sensor looks over or under it. Going away from what is near is always possible.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from executive.manual.words import BaseJog
from kinematics.arrays import Array
from kinematics.geometry.planar import PlanarPose
from kinematics.model.walking_settings import WalkingSettings
from kinematics.walking.route.room import WalkingRoom, stopping_distance_m, stopping_turn_rad
from kinematics.walking.route.swept_body import SweptBody

_PLACES = 9
"""That the body is looked at on the way ahead: 5 cm apart at most."""
_SLOWER = 0.5
_LEAST_SHARE = 0.125
"""Where there is no room at the speed that is asked for there may be at a lower one, down to this share."""


def slower(word: BaseJog) -> Iterator[BaseJog]:
    """A word, and the same at lower and lower speeds, along the same arc."""
    share = 1.0
    while share >= _LEAST_SHARE:
        yield BaseJog(share * word.linear_m_s, share * word.angular_rad_s)
        share *= _SLOWER


def body_meets(body: SweptBody, settings: WalkingSettings, word: BaseJog) -> str:
    """What of the robot would come to what is believed to be there, for people; empty when nothing does.

    Args:
        body: The robot as it stands among what is believed.
        settings: How soon a walk stands.
        word: Where to.
    """
    found = body.meets(_way(settings, word))
    return "" if found is None else f"{found.part} would come to the {found.item}"


def why_no_room(room: WalkingRoom, points: Array, settings: WalkingSettings, word: BaseJog) -> str:
    """What the range sensor sees in the way of the body, for people; empty when nothing is.

    Args:
        room: What the robot takes.
        points: Of the range sensor, as for ``WalkingRoom.free_way_m``.
        settings: Sizes.
        word: Where to.
    """
    if word.linear_m_s == 0.0:
        part = room.turn_meets(
            points, math.copysign(stopping_turn_rad(settings, word.angular_rad_s), word.angular_rad_s)
        )
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


def _way(settings: WalkingSettings, word: BaseJog) -> list[PlanarPose]:
    """Where the base comes by until the robot could stand again, seen from where it is: an arc."""
    far_m = turned_rad = 0.0
    if word.linear_m_s != 0.0:
        far_m = math.copysign(stopping_distance_m(settings, word.linear_m_s), word.linear_m_s)
        turned_rad = far_m * word.angular_rad_s / word.linear_m_s
    elif word.angular_rad_s != 0.0:
        turned_rad = math.copysign(stopping_turn_rad(settings, word.angular_rad_s), word.angular_rad_s)
    places = []
    for share in np.linspace(0.0, 1.0, _PLACES):
        yaw = float(share) * turned_rad
        # the chord of an arc
        chord_m = float(share) * far_m * float(np.sinc(0.5 * yaw / math.pi))
        places.append(PlanarPose(chord_m * math.cos(0.5 * yaw), chord_m * math.sin(0.5 * yaw), yaw))
    return places
