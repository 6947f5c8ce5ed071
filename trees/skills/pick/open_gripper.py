"""Open the gripper that a grasp needs."""

from __future__ import annotations

from py_trees.common import Status

from kinematics.requests.grasp import Grasp
from robots.control.motion_handle import MotionHandle
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, RUNNING
from trees.nodes.motion_leaf import MotionLeaf
from trees.nodes.ports import ports

# The pads' zero and the encoder's noise leave the last tenth uncertain.
_OPEN_SHARE = 0.9


class OpenGripper(MotionLeaf):
    """Open the hand that the grasp is planned for, as far as it goes."""

    INPUT_PORTS = ports(grasp=Grasp)
    OUTPUT_PORTS = ports()
    CONTRACT = Contract(
        precondition="the hand holds nothing that could fall",
        postcondition="the gripper measures nine tenths of its largest opening or more",
        deadline_s=4.0,
        moves="gripper",
        on_success="the gripper is open",
        on_failure="the gripper holds its present opening",
        on_cancel="the gripper holds its present opening",
    )

    def start(self) -> MotionHandle | Failure:
        """Open."""
        grasp: Grasp = self.get_input("grasp")
        frame = self.toolbox.model.description.grippers[grasp.hand].tcp_frame
        attached = self.toolbox.world.scene.attached
        held = ", ".join(name for name, body in attached.items() if body.frame == frame)
        if held:
            return Failure.postcondition(f"the {grasp.hand} hand still holds the {held}", hand=grasp.hand)
        return self.toolbox.grippers[grasp.hand].open()

    def finish(self) -> Status | Failure:
        """Measure the opening; ``RUNNING`` until it is wide enough, the deadline ends that."""
        grasp: Grasp = self.get_input("grasp")
        opening = self.toolbox.grippers[grasp.hand].reading().opening_m
        widest = self.toolbox.model.description.grippers[grasp.hand].max_opening_m
        self.feedback_message = f"{grasp.hand} hand {opening * 1000:.0f} mm open"
        return DONE if opening >= _OPEN_SHARE * widest else RUNNING
