"""Bring the body to its home posture."""

from __future__ import annotations

from kinematics.gesture_requests import GestureRequest
from kinematics.requests import MoveRequest
from trees.arrival import largest_error
from trees.contract import Contract
from trees.move_here import move_from_here
from trees.planned_motion_leaf import PlannedMotionLeaf
from trees.ports import ports

# A reference nearer than this to home is home.
_HOME_RAD = 0.01


class GoHome(PlannedMotionLeaf):
    """Bring arms, trunk and head home; hands stay as they are, with what they hold."""

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
        toolbox = self.toolbox
        reference = toolbox.motion.reference()
        if largest_error(toolbox.model, reference, toolbox.model.q_home)[1] <= _HOME_RAD:
            return None
        return move_from_here(toolbox)
