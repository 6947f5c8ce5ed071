"""Fingers that make a fist before a button, and close on a knob."""

from __future__ import annotations

from py_trees.common import Status

from kinematics.requests.grasp import Grasp
from robots.control.motion_handle import MotionHandle
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE
from trees.nodes.motion_leaf import MotionLeaf
from trees.nodes.ports import ports
from trees.skills.controls.control_target import ControlTarget
from trees.skills.controls.plan_control import hand_for


class MakeFist(MotionLeaf):
    """Close the empty hand that is to press: what of it is foremost comes first."""

    INPUT_PORTS = ports(task=object, control=ControlTarget)
    OUTPUT_PORTS = ports()
    CONTRACT = Contract(
        precondition="the hand is empty",
        postcondition="the fingers have closed on nothing",
        deadline_s=4.0,
        moves="gripper",
        on_success="the gripper is closed",
        on_failure="the gripper holds its present opening",
        on_cancel="the gripper holds its present opening",
    )

    def start(self) -> MotionHandle | Failure:
        """Close, unless something is held."""
        hand = hand_for(self.toolbox, self.get_input("control"), self.get_input("task"))[0]
        frame = self.toolbox.model.description.grippers[hand].tcp_frame
        held = [name for name, body in self.toolbox.world.scene.attached.items() if body.frame == frame]
        if held:
            return Failure.infeasible(f"the {hand} hand holds the {held[0]}")
        return self.toolbox.grippers[hand].close()

    def finish(self) -> Status | Failure:
        """The fingers have met."""
        return DONE


class CloseOnKnob(MotionLeaf):
    """Close the fingers on the bar of a knob."""

    INPUT_PORTS = ports(grasp=Grasp)
    OUTPUT_PORTS = ports()
    CONTRACT = Contract(
        precondition="the open hand is about the knob",
        postcondition="opening and effort of the gripper say that it holds something",
        deadline_s=4.0,
        moves="gripper",
        on_success="the gripper presses on the knob",
        on_failure="the gripper holds its present opening",
        on_cancel="the gripper holds its present opening",
    )

    def start(self) -> MotionHandle | Failure:
        """Close."""
        grasp: Grasp = self.get_input("grasp")
        return self.toolbox.grippers[grasp.hand].close()

    def finish(self) -> Status | Failure:
        """Judge what the fingers feel."""
        grasp: Grasp = self.get_input("grasp")
        reading = self.toolbox.grippers[grasp.hand].reading()
        self.measured(**reading.felt, holding=reading.holding)
        if not reading.holding:
            return Failure.postcondition("the fingers closed beside the knob", None, **reading.felt)
        self.feedback_message = f"holding, {reading}"
        return DONE
