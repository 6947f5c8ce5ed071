"""Say with which hand something is to be picked up that goes behind a door."""

from __future__ import annotations

from py_trees.common import Status

from trees.beliefs.openings.fridge_inside import hinge_hand
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, Leaf
from trees.nodes.ports import ports
from trees.readings.held import free_hands
from trees.registry import task_that
from trees.skill import After
from trees.tasks import PutInTask


class AskForHand(Leaf):
    """Write the task of picking up the object with the hand that can reach past the open door."""

    INPUT_PORTS = ports(task=PutInTask)
    OUTPUT_PORTS = ports(pick_task=object)
    CONTRACT = Contract(
        precondition="a hand is free",
        postcondition="the pick is described, with the hand that is named or else the one beside the hinge",
        deadline_s=1.0,
    )

    def step(self) -> Status | Failure:
        """Describe it; whoever knows no door has no hand to prefer."""
        task: PutInTask = self.get_input("task")
        if task.object is None:
            return Failure.postcondition("nothing is in a hand, and nothing was named")
        hand = task.hand or hinge_hand(self.toolbox.world.scene)
        if hand is None:
            return Failure.postcondition("no open door is known")
        free = free_hands(self.toolbox, hand)
        if isinstance(free, Failure):
            return free
        slots = {"object": task.object, "source": task.source, "hand": hand}
        self._set_output("pick_task", task_that(After.THING_HELD, task.text, **slots))
        return DONE
