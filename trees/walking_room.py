"""The room that the robot takes as it walks, with what it holds."""

from __future__ import annotations

from kinematics.walking.load import load_of
from kinematics.walking.room import WalkingRoom
from kinematics.walking.settings import WalkingSettings
from trees.empty_arms import arms_are_tucked
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


def room_if_it_walks(toolbox: Toolbox) -> WalkingRoom | None:
    """The same for any robot; None for one that cannot walk."""
    settings = toolbox.model.description.walking
    return None if settings is None else walking_room(toolbox, settings)
