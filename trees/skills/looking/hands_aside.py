"""Bring hands out of the picture: home, or beside the body of a robot whose camera is on its chest."""

from __future__ import annotations

from kinematics.ik.held_upright import arm_beside
from kinematics.requests.gesture import GestureRequest
from kinematics.requests.move import MoveRequest
from trees.failures import Failure
from trees.leaves.go_home import GoHome
from trees.nodes.contract import Contract
from trees.nodes.planned_motion_leaf import move_from_here
from trees.nodes.ports import ports
from trees.readings.held import held_objects


class HandsAside(GoHome):
    """Bring the body home; arms that eyes on the trunk do not see past stay beside it."""

    INPUT_PORTS = ports()
    OUTPUT_PORTS = ports()
    CONTRACT = Contract(
        precondition="none",
        postcondition="every body joint is measured to be at home; where a trunk aims the eyes, the arms are "
        "beside the body",
        deadline_s=30.0,
        moves="body",
        on_success="the robot holds that posture; what hands beside the body hold is upright",
    )

    def goal(self) -> MoveRequest | GestureRequest | Failure | None:
        """Home, or the arms beside the body; those that cannot get there go home."""
        toolbox, model = self.toolbox, self.toolbox.model
        if model.description.camera.trunk is None:
            return super().goal()
        held = {one.hand: one.tcp_T_object for one in held_objects(toolbox)}
        joints: dict[str, float] = {}
        for hand in model.description.arms:
            joints |= arm_beside(model, model.q_home, hand, held.get(hand)) or {}
        return move_from_here(toolbox, joints)
