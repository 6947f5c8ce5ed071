"""How the robot stands, asked again and again beside the conversation."""

from __future__ import annotations

import threading
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, Protocol

from robots.live.wire.errors import LiveError
from trees.snapshot import NodeKind, NodeSnapshot, TreeSnapshot

_EVERY_S = 0.1
_LOST_AFTER = 100
"""Looks in a row that find nobody, about ten seconds: an executive that ended is replaced meanwhile."""


@dataclass(frozen=True, slots=True)
class RobotStanding:
    """How a served robot stands at one moment.

    Attributes:
        t_s: Control time.
        state: State of the executive: "NORMAL".
        emergency: Why the emergency stop is engaged; empty where it is not.
        paused: Whether what is under way is held.
        tree: The tree under way, or the last one; None before the first.
        silent: Why nothing is known at the moment; empty where it is.
        lost: Whether that has lasted so long that the robot counts as gone.
    """

    t_s: float = 0.0
    state: str = "NORMAL"
    emergency: str = ""
    paused: bool = False
    tree: TreeSnapshot | None = None
    silent: str = ""
    lost: bool = False


class Standing(Protocol):
    """Who tells how the robot stands."""

    def status(self) -> dict[str, Any]:
        """As a door is told."""
        ...


class RobotWatch:
    """Asks in a thread of its own.

    Attributes:
        now: How the robot stood when it was last asked.
    """

    def __init__(self, robot: Standing) -> None:
        self.now = RobotStanding()
        self._robot, self._ended, self._in_vain = robot, threading.Event(), 0
        self._thread = threading.Thread(target=self._watch, name="watch of the chat", daemon=True)
        self._thread.start()

    def close(self) -> None:
        """Ask no more."""
        self._ended.set()
        self._thread.join()

    def _watch(self) -> None:
        while not self._ended.is_set():
            self.now = self._looked()
            self._ended.wait(_EVERY_S)

    def _looked(self) -> RobotStanding:
        try:
            status = self._robot.status()
        except LiveError as gone:
            self._in_vain += 1
            return replace(self.now, silent=str(gone), lost=self._in_vain >= _LOST_AFTER)
        self._in_vain = 0
        return standing_in(status, self.now.tree)


def standing_in(status: Mapping[str, Any], last: TreeSnapshot | None) -> RobotStanding:
    """How the robot stands, from its answer; ``last`` is the tree of the look before."""
    return RobotStanding(
        float(status.get("t_s", 0.0)),
        str(status.get("state", "NORMAL")),
        str((status.get("emergency") or {}).get("engaged", "")),
        bool(status.get("paused")),
        _tree(status, last),
    )


def _tree(status: Mapping[str, Any], last: TreeSnapshot | None) -> TreeSnapshot | None:
    """The tree under way, or how the last one ended; one that was halted stands as it was seen last."""
    t_s, under_way, ended = float(status.get("t_s", 0.0)), status.get("tree"), status.get("last_tree")
    if under_way and (under_way[0]["status"] != "idle" or last is None):
        return TreeSnapshot(t_s, 0, tree_of(under_way))
    if ended and (ended[0]["status"] != "idle" or last is None):
        return TreeSnapshot(t_s, 0, tree_of(ended))
    return None if last is None else replace(last, root=_halted(last.root))


def _halted(node: NodeSnapshot) -> NodeSnapshot:
    """The node as it stands when nothing runs any more: what ran has not been done."""
    status = "failure" if node.status == "running" else node.status
    return replace(node, status=status, children=tuple(map(_halted, node.children)))


def tree_of(nodes: Sequence[Mapping[str, Any]]) -> NodeSnapshot:
    """A tree from its nodes, the root first, each with its depth."""
    root, *below = nodes
    depth = int(root["depth"])
    children: list[NodeSnapshot] = []
    begins = [index for index, one in enumerate(below) if int(one["depth"]) == depth + 1]
    for begin, end in zip(begins, [*begins[1:], len(below)], strict=False):
        children.append(tree_of(below[begin:end]))
    kind: NodeKind = "sequence" if children else "leaf"
    return NodeSnapshot(root["name"], kind, root["status"], root["message"], tuple(children))
