"""Measure that the hand holds the object: what the gripper reads, before the object is lifted."""

from __future__ import annotations

from dataclasses import replace

from py_trees.common import Status

from kinematics.requests.grasp import Grasp
from robots.interface.gripper_reading import GripperReading
from robots.perception.fusion.hand_senses import width_felt
from trees.failures import Failure, Reason
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, RUNNING, Leaf
from trees.nodes.ports import optional, ports
from trees.port_values import Target
from trees.readings.disagreement import tell_disagreement
from trees.skills.pick.settings import PickSettings
from trees.world_model import WorldModel


def grip_failure(reading: GripperReading, grasp: Grasp, opening_tolerance_m: float) -> Failure | None:
    """Why the reading contradicts that the hand holds the object of the grasp; None if it does not.

    "Holding" alone says that something resists; the opening says whether it has the size of the object.
    """
    if not reading.holding:
        return Failure.postcondition("nothing between the fingers", cause=None, **reading.felt).because(
            Reason.CLOSED_ON_NOTHING
        )
    if abs(reading.opening_m - grasp.diameter_m) > opening_tolerance_m:
        return Failure.postcondition(
            "something of another size is between the fingers",
            opening_m=reading.opening_m,
            expected_m=grasp.diameter_m,
            tolerance_m=opening_tolerance_m,
        ).because(Reason.FELT_OTHER_SIZE)
    return None


def expected_grasp(world: WorldModel, grasp: Grasp, target: Target | None) -> Grasp:
    """The grasp with the width that is believed of its object: what fingers have felt, else what is seen."""
    felt_m = None if target is None else world.felt_widths.get(target.name)
    return grasp if felt_m is None else replace(grasp, diameter_m=felt_m)


class VerifyHold(Leaf):
    """Measure, by the gripper's opening and effort, that the hand holds the target before it is lifted."""

    INPUT_PORTS = ports(grasp=Grasp, target=optional(Target))
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
        target: Target | None = self.optional("target")
        grasp = expected_grasp(self.toolbox.world, self.get_input("grasp"), target)
        reading = self.toolbox.grippers[grasp.hand].reading()
        self.measured(**reading.felt, holding=reading.holding)
        self.feedback_message = f"holding, {reading}"
        failure = grip_failure(reading, grasp, self.toolbox.policy.of(PickSettings).opening_tolerance_m)
        if target is not None and (failure is None or failure.reason is Reason.FELT_OTHER_SIZE):
            self._compare(target, grasp, reading, failure)
        return failure or DONE

    def _compare(
        self, target: Target, grasp: Grasp, reading: GripperReading, failure: Failure | None
    ) -> None:
        """Compare the felt with the seen width; where they differ, the felt one is believed from now on.

        Something of another size that is felt once may be another thing, or a grip askew: that fails. The
        same felt again is a thing that was seen too large or too small.
        """
        world = self.toolbox.world
        seen = world.sightings.get(target.name)
        declared = None if seen is None else seen.error
        if declared is None or (target.name in world.felt_widths and failure is None):
            return
        innovation = width_felt(reading.opening_m, grasp.diameter_m, declared.size_share)
        if failure is None and not innovation.disagrees:
            return
        world.note_felt_width(target.name, reading.opening_m)
        if failure is None:
            tell_disagreement(
                self.toolbox,
                Failure.postcondition(
                    f"the {target.name} feels {reading.opening_m * 1e3:.0f} mm wide, and looks "
                    f"{grasp.diameter_m * 1e3:.0f}",
                    opening_m=reading.opening_m,
                    expected_m=grasp.diameter_m,
                    usual_m=innovation.sigma,
                )
                .because(Reason.FELT_OTHER_SIZE)
                .at(self.where),
            )
