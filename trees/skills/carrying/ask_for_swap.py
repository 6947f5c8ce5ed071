"""Say how an object gets from one hand into the other."""

from __future__ import annotations

from py_trees.common import Status

from kinematics.model.robot_description import Hand
from trees.beliefs.scene.held_object import HeldObject
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, Leaf
from trees.nodes.ports import ports
from trees.readings.held import free_hands
from trees.tasks import ObjectDescription, PickTask, PlaceTask


class AskForSwap(Leaf):
    """Write two tasks that bring an object from one hand into the other.

    The first puts down what the hand holds, the second picks it up with the other hand. It fails when the
    person has named the hand, or the other hand is not free.
    """

    INPUT_PORTS = ports(task=object, held=HeldObject)
    OUTPUT_PORTS = ports(swap_place=PlaceTask, swap_pick=PickTask)
    CONTRACT = Contract(
        precondition="a hand holds the object",
        postcondition="no hand was named, the other hand is free, and both tasks are described",
        deadline_s=1.0,
    )

    def step(self) -> Status | Failure:
        """Describe them, unless it has to be this hand."""
        task, held = self.get_input("task"), self.get_input("held")
        if task.hand is not None:
            return Failure.infeasible(f"it has to be the {task.hand} hand, as was asked")
        other: Hand = "left" if held.hand == "right" else "right"
        free = free_hands(self.toolbox, other)
        if isinstance(free, Failure):
            return free
        like_it = ObjectDescription(held.kind, held.color)
        self._set_output("swap_place", PlaceTask(task.text))
        self._set_output("swap_pick", PickTask(task.text, like_it, None, other))
        self.feedback_message = f"with the {other} hand"
        return DONE
