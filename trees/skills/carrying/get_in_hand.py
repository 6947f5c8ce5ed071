"""Get the object of a task into a hand: what every skill does that begins with its thing in one."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.nodes.alternatives import Alternatives
from trees.nodes.judgements import no_pick_helps
from trees.nodes.leaf import Leaf, rewired
from trees.skills.carrying.ask_for_pick import AskForPick
from trees.skills.carrying.take_held import IsHeld, TakeHeld
from trees.skills.pick.tree import pick
from trees.toolbox import Toolbox


def get_in_hand(
    toolbox: Toolbox, know_goal: Behaviour | None = None, with_hand: Leaf | None = None
) -> Behaviour:
    """It is in a hand already, or it is picked up. Reads "task", writes "held".

    An errand that has to fetch something from elsewhere does so by a task of its own before
    (``Before.THING_HELD``); then this finds it in the hand.

    Args:
        toolbox: What leaves may call.
        know_goal: Finds out where it goes before it is picked up, or asks.
        with_hand: Says how to pick it up by the hand that suits what follows, and is tried first; it writes
            "pick_task".
    """
    ways: list[Behaviour] = [IsHeld("is it held", toolbox)]
    if with_hand is not None:
        ways.append(_fetched("fetch it with that hand", with_hand, toolbox))
    fetch = _fetched("fetch it", AskForPick("say what", toolbox), toolbox)
    if know_goal is not None:
        fetch.insert_child(know_goal, 1)
    return Alternatives("have it", [*ways, fetch], hopeless=no_pick_helps)


def _fetched(name: str, ask: Leaf, toolbox: Toolbox) -> Sequence:
    """A pick of what a leaf asks for; that leaf writes "pick_task". Writes "held"."""
    picked = rewired(pick(toolbox), {"task": "pick_task"})
    return Sequence(name, memory=True, children=[ask, picked, TakeHeld("take hold", toolbox)])
