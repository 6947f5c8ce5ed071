"""Get the object of a task into a hand, or from one hand into the other."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.failures import Failure, Reason
from trees.nodes.alternatives import Alternatives
from trees.nodes.best_effort import BestEffort
from trees.nodes.judgements import judgement, no_pick_helps
from trees.nodes.leaf import Leaf, rewired
from trees.skills.carrying.ask_for_pick import AskForPick
from trees.skills.carrying.ask_for_swap import AskForSwap
from trees.skills.carrying.draw_back import DrawBack
from trees.skills.carrying.take_held import IsHeld, TakeHeld
from trees.skills.pick.tree import pick
from trees.toolbox import Toolbox


def get_in_hand(toolbox: Toolbox, know_goal: Behaviour | None = None) -> Behaviour:
    """It is in a hand already, or it is picked up. Reads "task", writes "held".

    Args:
        toolbox: What leaves may call.
        know_goal: Finds out where it goes before it is picked up, or asks.
    """
    fetch = fetched("fetch it", AskForPick("say what", toolbox), toolbox)
    if know_goal is not None:
        fetch.insert_child(know_goal, 1)
    return Alternatives("have it", [IsHeld("is it held", toolbox), fetch], hopeless=no_pick_helps)


def fetched(name: str, ask: Leaf, toolbox: Toolbox) -> Sequence:
    """A pick of what a leaf asks for; that leaf writes "pick_task". Writes "held"."""
    picked = rewired(pick(toolbox), {"task": "pick_task"})
    return Sequence(name, memory=True, children=[ask, picked, TakeHeld("take hold", toolbox)])


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
