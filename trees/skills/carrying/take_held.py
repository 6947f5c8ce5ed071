"""Find out what is in the hand."""

from __future__ import annotations

from py_trees.common import Status

from trees.beliefs.scene.held_object import HeldObject
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, Leaf
from trees.nodes.ports import ports
from trees.readings.held import held_object


class TakeHeld(Leaf):
    """Find the object of the task in a hand, and write which hand holds it.

    The world model must have it in the hand, and the gripper must feel it.
    """

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


class IsHeld(TakeHeld):
    """Ask whether a hand already holds the object of the task; that none does is an answer, not a failure.

    When the task means several objects the answer is no, since a hand can hold only one of them.
    """

    ASKS = True

    def step(self) -> Status | Failure:
        """Ask, for a single thing."""
        task = self.get_input("task")
        if task.object is not None and task.count != 1:
            return Failure.postcondition("several things are meant")
        return super().step()
