"""Turn a tree's nodes into snapshot values."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.common import Status
from py_trees.composites import Parallel, Selector, Sequence

from trees.nodes.alternatives import Alternatives
from trees.nodes.leaf import Leaf
from trees.snapshot import NodeKind, NodeSnapshot, NodeStatus

_STATUS: dict[Status, NodeStatus] = {
    Status.INVALID: "idle",
    Status.RUNNING: "running",
    Status.SUCCESS: "success",
    Status.FAILURE: "failure",
}


def snapshot_of(node: Behaviour) -> NodeSnapshot:
    """A node and everything below it, as plain values."""
    return NodeSnapshot(
        name=node.name,
        kind=_kind(node),
        status=status_word(node),
        message=node.feedback_message,
        children=tuple(snapshot_of(child) for child in node.children),
    )


def status_word(node: Behaviour) -> NodeStatus:
    """A node's status as snapshots and events write it."""
    return _STATUS[node.status]


def _kind(node: Behaviour) -> NodeKind:
    if isinstance(node, Leaf):
        return "leaf"
    if isinstance(node, Sequence):
        return "sequence"
    if isinstance(node, Selector | Alternatives):
        return "selector"
    return "parallel" if isinstance(node, Parallel) else "decorator"
