"""Turn the feet to what was found beside the robot or behind it."""

from __future__ import annotations

from collections.abc import Sequence as Many

import numpy as np
from numpy.typing import NDArray
from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from kinematics.geometry.planar import PlanarPose
from kinematics.model.walking_settings import WalkingSettings
from kinematics.walking.pattern.steering import PathSteering, Steering
from trees.beliefs.grounding.destination import SLOTS, Place
from trees.failures import Failure
from trees.nodes.alternatives import Alternatives
from trees.nodes.contract import Contract
from trees.nodes.ports import ports
from trees.nodes.skipping import Skipping
from trees.policy import Gaze
from trees.readings.odometry import bearing_rad, feet_pose
from trees.skills.looking.search_place import search_place
from trees.skills.walking.ready_to_walk import ReadyToWalk
from trees.skills.walking.walk_with_room import change_viewpoint, narrower_arms_are_useless, with_room
from trees.skills.walking.walking_leaf import ScannedWalk
from trees.skills.walking.walking_room import no_room_to_turn, walking_room
from trees.toolbox import Toolbox


class TurnTo(ScannedWalk):
    """Turn on the spot, by stepping, until the feet point at what the task is aimed at."""

    INPUT_PORTS = ports(place=Place)
    OUTPUT_PORTS = ports()
    CONTRACT = Contract(
        precondition="the robot stands upright with its hands at home or drawn in, and there is room to turn",
        postcondition="the robot stands, and what it was to turn to is ahead",
        deadline_s=40.0,
        moves="body",
        on_success="the robot stands",
        on_failure="the robot stops within two steps and stands",
        on_cancel="the robot stops within two steps and stands",
    )

    def steering(self, settings: WalkingSettings, scan: NDArray[np.float64]) -> Steering | Failure | None:
        """The turn, where hands and load have room for it."""
        body, room = feet_pose(self.toolbox), walking_room(self.toolbox, settings)
        turn = PlanarPose(yaw_rad=bearing_rad(self.toolbox, self.get_input("place")))
        return no_room_to_turn(self.toolbox, room, scan) or PathSteering(settings, (body, body @ turn))


class IfBeside(Skipping):
    """Ticks its child if the robot has to turn its feet to face the place, and can; else it succeeds.

    Attributes:
        beyond_rad: Angle between where the feet point and the place from which on they have to turn.
    """

    INPUT_PORTS = ports(place=Place)
    OUTPUT_PORTS = ports()

    def __init__(self, child: Behaviour, toolbox: Toolbox, beyond_rad: float) -> None:
        super().__init__(f"{child.name} if beside", child)
        self._toolbox = toolbox
        self.beyond_rad = beyond_rad

    def needed(self) -> bool:
        """Whether the feet have to turn, and can."""
        aside_rad = abs(bearing_rad(self._toolbox, self.get_input("place")))
        return self._toolbox.can_walk and aside_rad > self.beyond_rad


BESIDE_RAD = 1.0
"""Trunks turn by 1.2 rad, and hands reach farther: who waves or points up to here keeps the feet."""
BEHIND_RAD = 2.2
"""Trunk and head together look so far round."""


def turned_to(
    name: str,
    toolbox: Toolbox,
    gazes: Many[Gaze],
    beyond_rad: float = BESIDE_RAD,
    slots: Many[str] = SLOTS,
) -> Behaviour:
    """Turn to it where it is farther to a side than that, and see it again. Reads and writes "place"."""
    away: list[Behaviour] = [change_viewpoint(toolbox, "room"), _turn(toolbox)]
    ways: list[Behaviour] = [_turn(toolbox), Sequence("from a step away", memory=True, children=away)]
    turn: list[Behaviour] = [
        ReadyToWalk("stand upright", toolbox),
        Alternatives("face it", ways, narrower_arms_are_useless),
        search_place("see it again", toolbox, gazes, slots),
    ]
    return IfBeside(Sequence(name, memory=True, children=turn), toolbox, beyond_rad)


def _turn(toolbox: Toolbox) -> Behaviour:
    return with_room(toolbox, TurnTo("turn", toolbox), TurnTo("turn", toolbox))
