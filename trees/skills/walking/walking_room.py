"""The room that the robot takes as it walks, with what it holds."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from kinematics.model.walking_settings import WalkingSettings
from kinematics.walking.route.load import load_of
from kinematics.walking.route.room import WalkingRoom
from trees.failures import Failure, Reason
from trees.readings.odometry import feet_pose
from trees.skills.walking.empty_arms import arms_are_tucked
from trees.toolbox import Toolbox


def walking_room(toolbox: Toolbox, settings: WalkingSettings) -> WalkingRoom:
    """The room that it takes in its present posture.

    Args:
        toolbox: Knows what is attached, and where the hands are.
        settings: The sizes of a robot that walks.
    """
    held = toolbox.world.scene.attached.values()
    load = load_of(toolbox.model, toolbox.sensing.state().q, held, settings.hand_radius_m)
    return WalkingRoom(settings, load, arms_are_tucked(toolbox))


def no_room_to_turn(toolbox: Toolbox, room: WalkingRoom, scan: NDArray[np.float64]) -> Failure | None:
    """Why the robot cannot turn on the spot; None where there is room.

    Args:
        toolbox: Knows what is believed to stand about.
        room: What the robot takes.
        scan: What the range sensor sees, shape (n, 3), m.
    """
    found = room.tightest_seen(scan), room.tightest(toolbox.world.scene, feet_pose(toolbox))
    tight = max(found, key=lambda spot: spot.lack_m)
    if tight.lack_m <= 0.0:
        return None
    message = f"there is no room to turn for the {tight.part}"
    lack = Failure.infeasible(message, room_m=tight.room_m, needed_m=tight.needed_m)
    return lack.because(Reason.NO_ROOM)


def room_if_it_walks(toolbox: Toolbox) -> WalkingRoom | None:
    """The same for any robot; None for one that cannot walk."""
    settings = toolbox.model.description.walking
    return None if settings is None else walking_room(toolbox, settings)
