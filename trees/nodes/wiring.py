"""Ports of a subtree connected to other keys."""

from __future__ import annotations

from collections.abc import Mapping

from py_trees.behaviour import Behaviour

from trees.nodes.leaf import Leaf


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
