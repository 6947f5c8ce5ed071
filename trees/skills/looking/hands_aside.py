"""Bring hands out of the picture of a camera on the chest, beside the body, with what they hold upright."""

from __future__ import annotations

from kinematics.ik.held_upright import arm_beside
from kinematics.requests.gesture import GestureRequest
from kinematics.requests.move import MoveRequest
from trees.leaves.go_home import GoHome
from trees.nodes.contract import Contract
from trees.nodes.planned_motion_leaf import move_from_here
from trees.nodes.ports import ports
from trees.readings.held import held_objects
from trees.toolbox import Toolbox


class HandsAside(GoHome):
    """Bring the body home, and the arms to where eyes that no neck aims see past them."""

    INPUT_PORTS = ports()
    OUTPUT_PORTS = ports()
    CONTRACT = Contract(
        precondition="none",
        postcondition="every body joint is measured to be at home, and the arms beside the body",
        deadline_s=30.0,
        moves="body",
        on_success="the robot holds that posture, what its hands hold is upright",
    )

    def goal(self) -> MoveRequest | GestureRequest | None:
        """The arms beside the body; those that cannot go home."""
        toolbox, model = self.toolbox, self.toolbox.model
        held = {one.hand: one.tcp_T_object for one in held_objects(toolbox)}
        joints: dict[str, float] = {}
        for hand in model.description.arms:
            joints |= arm_beside(model, model.q_home, hand, held.get(hand)) or {}
        return move_from_here(toolbox, joints)


def out_of_the_picture(name: str, toolbox: Toolbox) -> GoHome:
    """The leaf that gives a robot's eyes a free view: hands at home, or beside the body."""
    trunk_aims = toolbox.model.description.camera.trunk is not None
    return HandsAside(name, toolbox) if trunk_aims else GoHome(name, toolbox)
