"""A tree's state as plain values, for the terminal, the log and pictures."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

NodeStatus = Literal["idle", "running", "success", "failure"]
NodeKind = Literal["sequence", "selector", "parallel", "decorator", "leaf"]


@dataclass(frozen=True, slots=True)
class NodeSnapshot:
    """One node of a tree, with its children.

    Attributes:
        name: As the tree names it: "reach", "close gripper".
        kind: The class of the node, such as a leaf's or a control node's.
        status: "idle" before its first tick and after a reset.
        message: The newest thing that it has to say: progress, numbers, or why it failed.
        children: In order.
    """

    name: str
    kind: NodeKind
    status: NodeStatus
    message: str
    children: tuple[NodeSnapshot, ...] = ()


@dataclass(frozen=True, slots=True)
class TreeSnapshot:
    """The whole tree at one tick."""

    t_s: float
    tick: int
    root: NodeSnapshot
