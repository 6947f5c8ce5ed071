"""Feel that the hand has not lost what it carries."""

from __future__ import annotations

from py_trees.common import Status

from trees.contract import Contract
from trees.failures import Failure
from trees.held import HeldObject, lost
from trees.leaf import DONE, RUNNING, Leaf
from trees.ports import ports


class StillHeld(Leaf):
    """The gripper says holding; what was lost is forgotten, and nothing is done as if it were there."""

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
