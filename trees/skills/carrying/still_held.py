"""Feel that the hand has not lost what it carries."""

from __future__ import annotations

from py_trees.common import Status

from trees.beliefs.scene.held_object import HeldObject
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, RUNNING, Leaf
from trees.nodes.ports import ports
from trees.readings.held import lost


class StillHeld(Leaf):
    """Measure with the gripper that the hand still holds what it carries.

    When it does not, the leaf fails, and takes the object out of the planning scene: where it is now is not
    known.
    """

    INPUT_PORTS = ports(held=HeldObject)
    OUTPUT_PORTS = ports()
    CONTRACT = Contract(
        precondition="the object is an attached body",
        postcondition="the gripper says holding",
        deadline_s=1.0,
        on_success="the gripper goes on pressing",
        on_failure="the gripper goes on pressing; the object is an attached body no more",
        on_cancel="the gripper goes on pressing",
    )

    def step(self) -> Status | Failure:
        """Ask the gripper, for a few readings if need be."""
        held: HeldObject = self.get_input("held")
        if self.toolbox.grippers[held.hand].reading().holding:
            return DONE
        if self.elapsed_s < self.toolbox.policy.lost_grip_s:
            return RUNNING
        return lost(self.toolbox, held)
