"""Find out what is in the hand."""

from __future__ import annotations

from py_trees.common import Status

from trees.contract import Contract
from trees.failures import Failure
from trees.held import HeldObject, held_object
from trees.leaf import DONE, Leaf
from trees.ports import ports


class TakeHeld(Leaf):
    """The object of the task is in a hand: the world model says so, and the gripper feels it."""

    INPUT_PORTS = ports(task=object)
    OUTPUT_PORTS = ports(held=HeldObject)
    CONTRACT = Contract(
        precondition="none",
        postcondition="what is meant is an attached body, and its gripper says holding",
        deadline_s=1.0,
    )

    def step(self) -> Status | Failure:
        """Ask world model and gripper."""
        task = self.get_input("task")
        held = held_object(self.toolbox, task.object, task.hand)
        if isinstance(held, Failure):
            return held
        self._set_output("held", held)
        self.feedback_message = f"{held.name} in the {held.hand} hand"
        return DONE
