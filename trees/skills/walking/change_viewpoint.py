"""Look from elsewhere: walk on a little, step back, make room, or turn the whole body."""

from __future__ import annotations

from typing import Literal

from py_trees.common import Status

from kinematics.arrays import Array
from kinematics.geometry.planar import PlanarPose
from kinematics.model.walking_settings import WalkingSettings
from kinematics.walking.pattern.steering import PathSteering, Steering, StretchSteering
from kinematics.walking.route.room import WalkingRoom
from trees.failures import Failure, Reason
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE
from trees.nodes.ports import ports
from trees.readings.odometry import feet_pose
from trees.skills.walking.walking_leaf import ScannedWalk
from trees.skills.walking.walking_room import no_room_to_turn, walking_room
from trees.toolbox import Toolbox

_AHEAD_M = 2.0
"""Half of what the camera sees far."""
_LEAST_M = 0.4
_ROOM_M = 0.6
_BACK_M, _LEAST_BACK_M, _ROOM_BEHIND_M = 0.7, 0.2, 0.3
"""So far back there is room to turn, where one stands with the hands over or inside something."""
_TURN_RAD = 1.9
"""Less than the head sees to both sides, so that nothing is passed over."""
_SPEED_M_S = 0.3


Viewpoint = Literal["ahead", "around", "back", "room"]


class ChangeViewpoint(ScannedWalk):
    """Walk straight on or back as far as the floor is free, or turn on the spot.

    "room" is for a place without room to turn: the robot then steps back, or ahead, until there is. It stays
    when there is room already, or when it cannot step either way.
    """

    INPUT_PORTS = ports()
    OUTPUT_PORTS = ports(stepped_m=float)
    CONTRACT = Contract(
        precondition="the robot stands upright with its hands at home or drawn in, and there is room",
        postcondition="the robot stands elsewhere, or faces elsewhere",
        deadline_s=40.0,
        moves="body",
        on_success="the robot stands",
        on_failure="the robot stops within two steps and stands",
        on_cancel="the robot stops within two steps and stands",
    )

    def __init__(self, name: str, toolbox: Toolbox, way: Viewpoint) -> None:
        super().__init__(name, toolbox)
        self._way = way

    def step(self) -> Status | Failure:
        """Set out once, and wait until the robot stands; tell how far a step for room was."""
        status = super().step()
        if status is DONE and self._way == "room" and self._handle is not None:
            self._set_output("stepped_m", self._from.to(feet_pose(self.toolbox)).x_m)
        return status

    def steering(self, settings: WalkingSettings, scan: Array) -> Steering | Failure | None:
        """The way to go by what was asked for."""
        self._from = body = feet_pose(self.toolbox)
        room = walking_room(self.toolbox, settings)
        if self._way == "ahead":
            room_m = room.free_way_m(scan, 1.0) - _ROOM_M
            if room_m < _LEAST_M:
                message = "there is no room ahead to look from"
                return Failure.infeasible(message, room_m=room_m).because(Reason.NO_ROOM)
            return StretchSteering(settings, body, _SPEED_M_S, min(room_m, _AHEAD_M))
        if self._way == "back":
            room_m = room.free_way_m(scan, -1.0) - _ROOM_BEHIND_M
            if room_m < _LEAST_BACK_M:
                message = "there is no room behind to look from"
                return Failure.infeasible(message, room_m=room_m).because(Reason.NO_ROOM)
            return StretchSteering(settings, body, -_SPEED_M_S, min(room_m, _BACK_M))
        narrow = no_room_to_turn(self.toolbox, room, scan)
        if self._way == "room":
            return None if narrow is None else _to_room(settings, body, room, scan)
        return narrow or PathSteering(settings, (body, body @ PlanarPose(yaw_rad=_TURN_RAD)))


def _to_room(settings: WalkingSettings, body: PlanarPose, room: WalkingRoom, scan: Array) -> Steering | None:
    """A step back, or ahead where something is behind; None where neither way is free."""
    for sign in (-1.0, 1.0):
        room_m = room.free_way_m(scan, sign) - _ROOM_BEHIND_M
        if room_m >= _LEAST_BACK_M:
            return StretchSteering(settings, body, sign * _SPEED_M_S, min(room_m, _BACK_M))
    return None
