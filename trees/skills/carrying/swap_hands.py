"""Put down what a hand cannot bring to where it goes, and take it up with the other one."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.failures import Failure, Reason
from trees.nodes.best_effort import BestEffort
from trees.nodes.judgements import judgement
from trees.nodes.wiring import rewired
from trees.skills.carrying.ask_for_swap import AskForSwap
from trees.skills.carrying.draw_back import DrawBack
from trees.skills.carrying.take_held import TakeHeld
from trees.skills.pick.tree import pick
from trees.toolbox import Toolbox


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
