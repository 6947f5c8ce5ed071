"""Turn on the spot until what a task is aimed at is ahead."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from kinematics.geometry.planar import PlanarPose
from kinematics.model.walking_settings import WalkingSettings
from kinematics.walking.pattern.steering import PathSteering, Steering
from trees.beliefs.grounding.destination import Place
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.ports import ports
from trees.readings.odometry import bearing_rad, feet_pose
from trees.skills.walking.scanned_walk import ScannedWalk
from trees.skills.walking.walking_room import no_room_to_turn, walking_room


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
