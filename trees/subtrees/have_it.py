"""Get the object of a task into a hand."""

from __future__ import annotations

from collections.abc import Mapping

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.alternatives import Alternatives, defect
from trees.failures import Failure, FailureKind
from trees.leaf import Leaf
from trees.leaves.ask_for_pick import AskForPick
from trees.leaves.is_held import IsHeld
from trees.leaves.know_destination import KnowDestination
from trees.leaves.look_at import LookAt
from trees.leaves.take_held import TakeHeld
from trees.subtrees.pick import pick
from trees.subtrees.search import looking_elsewhere_is_useless
from trees.toolbox import Toolbox


def have_it(toolbox: Toolbox, know_goal: Behaviour | None = None) -> Behaviour:
    """It is in a hand already, or it is picked up. Reads "task", writes "held".

    Args:
        toolbox: What leaves may call.
        know_goal: Finds out where it goes before it is picked up, or asks.
    """
    fetch = fetched("fetch it", AskForPick("say what", toolbox), toolbox)
    if know_goal is not None:
        fetch.insert_child(know_goal, 1)
    return Alternatives("have it", [IsHeld("is it held", toolbox), fetch], hopeless=no_pick_helps)


def know_destination(toolbox: Toolbox) -> Behaviour:
    """Looks until what it is put on, beside or into is seen. Reads "task"."""
    looks: list[Behaviour] = [KnowDestination("as seen from here", toolbox)]
    for gaze in (*toolbox.policy.search_gazes, *toolbox.policy.level_gazes):
        children: list[Behaviour] = [
            LookAt("look", toolbox, gaze),
            KnowDestination("know destination", toolbox),
        ]
        looks.append(Sequence(f"look {gaze.name}", memory=True, children=children))
    return Alternatives("where it goes", looks, hopeless=_cannot_go_there)


def fetched(name: str, ask: Leaf, toolbox: Toolbox) -> Sequence:
    """A pick of what a leaf asks for; that leaf writes "pick_task". Writes "held"."""
    picked = rewired(pick(toolbox), {"task": "pick_task"})
    return Sequence(name, memory=True, children=[ask, picked, TakeHeld("take hold", toolbox)])


def _cannot_go_there(failure: Failure) -> bool:
    """Several that fit, or one that things are not put on or into."""
    return looking_elsewhere_is_useless(failure) or failure.kind is FailureKind.INFEASIBLE


def no_pick_helps(failure: Failure) -> bool:
    """A defect, or several objects that fit: that takes an answer."""
    return defect(failure) or bool(failure.choices)


def rewired(tree: Behaviour, keys: Mapping[str, str]) -> Behaviour:
    """Connect ports of every leaf of a subtree to other keys, where it has them under their own names.

    Args:
        tree: Made, and not wired yet.
        keys: Port name to key.
    """
    for node in tree.iterate():
        if isinstance(node, Leaf):
            ports = {*node.INPUT_PORTS, *node.OUTPUT_PORTS}
            for port, key in keys.items():
                if port in ports and port not in node.wiring:
                    node.wiring[port] = key
    return tree
