"""Close the gripper on what is between its fingers."""

from __future__ import annotations

from py_trees.common import Status

from kinematics.requests.grasp import Grasp
from robots.control.motion_handle import MotionHandle
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE
from trees.nodes.motion_leaf import MotionLeaf
from trees.nodes.ports import ports


class CloseGripper(MotionLeaf):
    """Close the hand of the grasp until something resists, and keep pressing.

    Whether it holds the target is measured by ``VerifyHold``.
    """

    INPUT_PORTS = ports(grasp=Grasp)
    OUTPUT_PORTS = ports()
    CONTRACT = Contract(
        precondition="the hand is at the grasp pose",
        postcondition="the closing has ended; what it holds is for VerifyHold to say",
        deadline_s=4.0,
        moves="gripper",
        on_success="the gripper presses with its grasp effort, or is closed",
        on_failure="the gripper holds its present opening",
        on_cancel="the gripper holds its present opening",
    )

    def start(self) -> MotionHandle | Failure:
        """Close."""
        grasp: Grasp = self.get_input("grasp")
        return self.toolbox.grippers[grasp.hand].close()

    def finish(self) -> Status | Failure:
        """Tell what the gripper feels."""
        grasp: Grasp = self.get_input("grasp")
        reading = self.toolbox.grippers[grasp.hand].reading()
        self.feedback_message = str(reading)
        return DONE
