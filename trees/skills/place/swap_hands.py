"""Put down what a hand cannot bring to where it goes, and take it up with the other one."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.common import Status
from py_trees.composites import Sequence

from kinematics.model.robot_description import Hand
from trees.beliefs.scene.held_object import HeldObject
from trees.failures import Failure, Reason
from trees.nodes.best_effort import BestEffort
from trees.nodes.contract import Contract
from trees.nodes.judgements import judgement
from trees.nodes.leaf import DONE, Leaf, rewired
from trees.nodes.ports import ports
from trees.readings.held import free_hands
from trees.registry import task_that
from trees.skill import After
from trees.skills.carrying.draw_back import DrawBack
from trees.skills.carrying.take_held import TakeHeld
from trees.skills.pick.tree import pick
from trees.tasks import ObjectDescription, PlaceTask
from trees.toolbox import Toolbox


class AskForSwap(Leaf):
    """Write two tasks that bring an object from one hand into the other.

    The first puts down what the hand holds, the second picks it up with the other hand. It fails when the
    person has named the hand, or the other hand is not free.
    """

    INPUT_PORTS = ports(task=object, held=HeldObject)
    OUTPUT_PORTS = ports(swap_place=PlaceTask, swap_pick=object)
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
        self._set_output("swap_pick", task_that(After.THING_HELD, task.text, object=like_it, hand=other))
        self.feedback_message = f"with the {other} hand"
        return DONE


def swap_hands(put_down: list[Behaviour], toolbox: Toolbox) -> Behaviour:
    """Reads "task" and "held", writes "held".

    Args:
        put_down: Finds room for what is held and sets it down there; it reads its task from "swap_place".
        toolbox: What leaves may call.
    """
    children: list[Behaviour] = [
        AskForSwap("say how", toolbox),
        Sequence("put it down", memory=True, children=put_down),
        BestEffort(DrawBack("draw back", toolbox)),
        rewired(pick(toolbox), {"task": "swap_pick"}),
        TakeHeld("take hold", toolbox),
    ]
    return Sequence("take it with the other hand", memory=True, children=children)


@judgement
def other_hand_is_no_help(failure: Failure) -> bool:
    """All but a planner's no to every spot that was free."""
    return failure.reason is not Reason.NO_WAY_TO_SPOT or bool(failure.choices)
