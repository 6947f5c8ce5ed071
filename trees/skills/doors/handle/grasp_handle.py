"""Take hold of a handle with a hand that gives way to it."""

from __future__ import annotations

from py_trees.common import Status

from kinematics.requests.grasp import Grasp
from robots.control.hands.yield_order import YieldOrder
from trees.beliefs.openings.handles import HandleTarget
from trees.failures import Failure
from trees.nodes.closing_leaf import ClosingLeaf
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE
from trees.nodes.ports import ports
from trees.skills.doors.handle.held_handle import HeldHandle, scene_of_hand, tcp_m


class GraspHandle(ClosingLeaf):
    """Close the gripper on the bar of a handle while the arm gives way.

    Fingers that meet the bar off centre move the hand with them; where the hand comes to rest shows where the
    bar really is.
    """

    INPUT_PORTS = ports(handle=HandleTarget, grasp=Grasp)
    OUTPUT_PORTS = ports(held=HeldHandle)
    CONTRACT = Contract(
        precondition="the open hand is about the bar",
        postcondition="opening and effort of the gripper say that it holds something",
        deadline_s=8.0,
        moves="body and gripper",
        on_success="the gripper presses on the bar",
        on_failure="the gripper keeps its state; the arm holds",
        on_cancel="the gripper keeps its state; the arm holds",
    )

    def order(self, grasp: Grasp) -> YieldOrder:
        """Along the way of the handle."""
        target: HandleTarget = self.get_input("handle")
        toolbox = self.toolbox
        q = toolbox.motion.reference()
        return YieldOrder(
            grasp.hand,
            scene_of_hand(toolbox, target, grasp),
            (target.part, target.handle),
            target.path.through(tcp_m(toolbox, grasp, q), target.opening),
            target.opening,
            target.opening,
        )

    def finish(self) -> Status | Failure:
        """Judge the grip, and note where the bar really is."""
        grasp: Grasp = self.get_input("grasp")
        target: HandleTarget = self.get_input("handle")
        reading = self.toolbox.grippers[grasp.hand].reading()
        report = self.led.report
        self.measured(
            **reading.felt,
            holding=reading.holding,
            peak_force_n=report.peak_force_n,
        )
        if not reading.holding:
            return Failure.postcondition(
                "the fingers closed beside the handle",
                cause=None,
                **reading.felt,
            )
        place = tcp_m(self.toolbox, grasp, self.toolbox.motion.reference())
        path = target.path.through(place, target.opening)
        self._set_output("held", HeldHandle(target, grasp, path, report.bias))
        self.feedback_message = f"holding, {reading}"
        return DONE
