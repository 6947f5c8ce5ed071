"""Say what has to be picked up first."""

from __future__ import annotations

from py_trees.common import Status

from trees.contract import Contract
from trees.failures import Failure
from trees.free_hand import free_hands
from trees.held import HeldObject
from trees.leaf import DONE, Leaf
from trees.ports import optional, ports
from trees.tasks import ObjectDescription, PickTask


class AskForPick(Leaf):
    """Make the task of picking up the object that this task is about, or that a hand lost on its way."""

    INPUT_PORTS = ports(task=object, held=optional(HeldObject))
    OUTPUT_PORTS = ports(pick_task=PickTask)
    CONTRACT = Contract(
        precondition="a hand is free",
        postcondition="the pick is described",
        deadline_s=1.0,
    )

    def step(self) -> Status | Failure:
        """Describe it; without an object there is nothing to pick up."""
        task = self.get_input("task")
        lost: HeldObject | None = self.optional("held")
        if lost is not None:
            like_it = ObjectDescription(lost.kind, lost.color)
            self._set_output("pick_task", PickTask(task.text, like_it, None, task.hand))
            return DONE
        if task.object is None:
            return Failure.postcondition("nothing is in a hand, and nothing was named")
        free = free_hands(self.toolbox, task.hand)
        if isinstance(free, Failure):
            return free
        source = getattr(task, "source", None)
        self._set_output("pick_task", PickTask(task.text, task.object, source, task.hand))
        return DONE
