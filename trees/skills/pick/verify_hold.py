"""Measure that the hand holds the object, before it is lifted."""

from __future__ import annotations

from py_trees.common import Status

from kinematics.requests.grasp import Grasp
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, RUNNING, Leaf
from trees.nodes.ports import ports
from trees.skills.pick.grip import grip_failure
from trees.skills.pick.settings import PickSettings


class VerifyHold(Leaf):
    """Measure, by the gripper's opening and effort, that the hand holds the target before it is lifted."""

    INPUT_PORTS = ports(grasp=Grasp)
    OUTPUT_PORTS = ports()
    CONTRACT = Contract(
        precondition="the gripper has closed",
        postcondition="effort says that something is held, and the opening that it has the object's size",
        deadline_s=2.0,
        on_success="the gripper presses on the object",
        on_failure="the gripper goes on pressing on whatever it holds",
        on_cancel="the gripper goes on pressing",
    )

    def step(self) -> Status | Failure:
        """Wait, then judge."""
        if self.elapsed_s < self.toolbox.policy.of(PickSettings).grasp_settle_s:
            return RUNNING
        grasp: Grasp = self.get_input("grasp")
        reading = self.toolbox.grippers[grasp.hand].reading()
        self.measured(opening_m=reading.opening_m, effort_nm=reading.effort_nm, holding=reading.holding)
        self.feedback_message = f"holding, {reading.opening_m * 1000:.0f} mm, {reading.effort_nm:.1f} Nm"
        return grip_failure(reading, grasp, self.toolbox.policy.of(PickSettings).opening_tolerance_m) or DONE
