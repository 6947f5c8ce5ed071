"""Get the object of a task into a hand."""

from __future__ import annotations

from collections.abc import Mapping

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.alternatives import Alternatives, defect
from trees.failures import Failure
from trees.leaf import Leaf
from trees.leaves.ask_for_pick import AskForPick
from trees.leaves.is_held import IsHeld
from trees.leaves.take_held import TakeHeld
from trees.subtrees.pick import pick
from trees.toolbox import Toolbox


def have_it(toolbox: Toolbox) -> Behaviour:
    """It is in a hand already, or it is picked up. Reads "task", writes "held"."""
    fetch = fetched("fetch it", AskForPick("say what", toolbox), toolbox)
    return Alternatives("have it", [IsHeld("is it held", toolbox), fetch], hopeless=no_pick_helps)


def fetched(name: str, ask: Leaf, toolbox: Toolbox) -> Behaviour:
    """A pick of what a leaf asks for; that leaf writes "pick_task". Writes "held"."""
    picked = rewired(pick(toolbox), {"task": "pick_task"})
    return Sequence(name, memory=True, children=[ask, picked, TakeHeld("take hold", toolbox)])


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
