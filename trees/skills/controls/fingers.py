"""Fingers that make a fist before a button, and close on a knob."""

from __future__ import annotations

import math

from py_trees.common import Status

from kinematics.requests.grasp import Grasp
from kinematics.scene.concessions import ConcessionReason, touching, with_touching
from kinematics.scene.opening_path import DrawerLine
from robots.control.hands.yield_order import YieldOrder
from robots.control.motion_handle import MotionHandle
from trees.failures import Failure
from trees.nodes.closing_leaf import ClosingLeaf
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


class CloseOnKnob(ClosingLeaf):
    """Close the fingers on the bar of a knob, while the arm gives way.

    Fingers that meet the bar off centre move the hand with them.
    """

    INPUT_PORTS = ports(control=ControlTarget, grasp=Grasp)
    OUTPUT_PORTS = ports()
    CONTRACT = Contract(
        precondition="the open hand is about the knob",
        postcondition="opening and effort of the gripper say that it holds something",
        deadline_s=8.0,
        moves="body and gripper",
        on_success="the gripper presses on the knob",
        on_failure="the gripper keeps its state; the arm holds",
        on_cancel="the gripper keeps its state; the arm holds",
    )

    def order(self, grasp: Grasp) -> YieldOrder:
        """Along what the knob looks, and no farther than it gives."""
        toolbox, control = self.toolbox, self.get_input("control")
        gripper = toolbox.model.description.grippers[grasp.hand]
        here = toolbox.model.frame_pose(toolbox.motion.reference(), gripper.tcp_frame)[:3, 3]
        ahead = control.inwards
        line = DrawerLine(here, math.atan2(float(ahead[1]), float(ahead[0])))
        held = touching(gripper.touch_links, (control.name,), ConcessionReason.HANDLE_IN_HAND, "close")
        scene = with_touching(toolbox.world.scene, held)
        return YieldOrder(grasp.hand, scene, (control.name,), line, 0.0, 0.0)

    def finish(self) -> Status | Failure:
        """Judge what the fingers feel."""
        grasp: Grasp = self.get_input("grasp")
        reading = self.toolbox.grippers[grasp.hand].reading()
        self.measured(**reading.felt, holding=reading.holding)
        if not reading.holding:
            return Failure.postcondition("the fingers closed beside the knob", None, **reading.felt)
        self.feedback_message = f"holding, {reading}"
        return DONE
