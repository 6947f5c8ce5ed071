"""Bring the body to its home posture."""

from __future__ import annotations

from kinematics.requests.gesture import GestureRequest
from kinematics.requests.move import MoveRequest
from trees.nodes.arrival import is_told_to_be_home
from trees.nodes.contract import Contract
from trees.nodes.move_from_here import move_from_here
from trees.nodes.planned_motion_leaf import PlannedMotionLeaf
from trees.nodes.ports import ports


class GoHome(PlannedMotionLeaf):
    """Bring arms, trunk and head to the home posture; fingers stay as they are, with what they hold."""

    INPUT_PORTS = ports()
    OUTPUT_PORTS = ports()
    CONTRACT = Contract(
        precondition="none",
        postcondition="every body joint is measured to be at home",
        deadline_s=30.0,
        moves="body",
        on_success="the robot holds the home posture",
    )

    def goal(self) -> MoveRequest | GestureRequest | None:
        """The home posture, unless it is commanded already."""
        return None if is_told_to_be_home(self.toolbox) else move_from_here(self.toolbox)
