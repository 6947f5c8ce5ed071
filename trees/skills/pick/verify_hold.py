"""Measure that the hand holds the object: what the gripper reads, before the object is lifted."""

from __future__ import annotations

from py_trees.common import Status

from kinematics.requests.grasp import Grasp
from robots.interface.gripper_reading import GripperReading
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, RUNNING, Leaf
from trees.nodes.ports import ports
from trees.skills.pick.settings import PickSettings


def grip_failure(reading: GripperReading, grasp: Grasp, opening_tolerance_m: float) -> Failure | None:
    """Why the reading contradicts that the hand holds the object of the grasp; None if it does not.

    "Holding" alone says that something resists; the opening says whether it has the size of the object.
    """
    if not reading.holding:
        return Failure.postcondition(
            "nothing between the fingers", opening_m=reading.opening_m, effort_nm=reading.effort_nm
        )
    if abs(reading.opening_m - grasp.diameter_m) > opening_tolerance_m:
        return Failure.postcondition(
            "something of another size is between the fingers",
            opening_m=reading.opening_m,
            expected_m=grasp.diameter_m,
            tolerance_m=opening_tolerance_m,
        )
    return None


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
