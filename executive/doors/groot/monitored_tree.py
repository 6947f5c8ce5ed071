"""One tree as Groot2 knows it: a number for each node, statuses, and what changed while that is recorded."""

from __future__ import annotations

import hashlib
import struct
from collections import deque
from collections.abc import Mapping, Sequence
from xml.etree import ElementTree

IDLE, RUNNING, SUCCESS, FAILURE = range(4)
_BY_LETTER: Mapping[str, int] = {"i": IDLE, "r": RUNNING, "s": SUCCESS, "f": FAILURE}
_ENDED = 10
"""A node that is idle again is told as this plus the status that it had."""
_STATUS = struct.Struct("<HB")
_MOST_TRANSITIONS = 1000
NO_TREE = '<root BTCPP_format="4"/>'


class MonitoredTree:
    """A tree while it is looked at.

    Args:
        document: Of BehaviorTree.CPP 4, with one tree; see ``trees.btcpp.writer``.
        number: Of the tree; one that is begun again has another number.

    Attributes:
        id: Sixteen bytes that no other tree has.
        xml: The document, each node with its number; the root has 1, and they go on from parent to child.
        name: The tree's ID.
        said: What nodes have to say, by their names.
    """

    def __init__(self, document: str = NO_TREE, number: int = 0) -> None:
        root = ElementTree.fromstring(document)
        tree = root.find("BehaviorTree")
        self.id = hashlib.blake2b(f"{number} {document}".encode(), digest_size=16).digest()
        self.name = "" if tree is None else tree.get("ID", "")
        self.said: Mapping[str, str] = {}
        self._count = 0
        if tree is not None:
            tree.set("_fullpath", "")
            for node in tree[0].iter() if len(tree) else ():
                self._count += 1
                node.set("_uid", str(self._count))
        self.xml = ElementTree.tostring(root, encoding="unicode")
        self._now = [IDLE] * self._count
        self._told = [IDLE] * self._count
        self._recorded_from_us: int | None = None
        self._transitions: deque[bytes] = deque(maxlen=_MOST_TRANSITIONS)

    def take(self, letters: str, now_us: int) -> None:
        """Take the statuses of all nodes.

        Args:
            letters: The first letter of each node's status, from the root down, as a snapshot has them.
            now_us: When, in microseconds.
        """
        for index, status in enumerate(map(_BY_LETTER.__getitem__, letters[: self._count])):
            self.change(index + 1, status, now_us)

    def change(self, uid: int, status: int, now_us: int) -> None:
        """Take the status of one node, by its number."""
        before = self._now[uid - 1]
        if status == before:
            return
        self._now[uid - 1] = status
        self._told[uid - 1] = status if status != IDLE else _ENDED + before
        if self._recorded_from_us is not None:
            since = max(now_us - self._recorded_from_us, 0)
            self._transitions.append(since.to_bytes(6, "little") + _STATUS.pack(uid, status))

    @property
    def statuses(self) -> bytes:
        """Number and status of each node."""
        return b"".join(_STATUS.pack(uid, status) for uid, status in enumerate(self._told, start=1))

    def record(self, now_us: int | None) -> None:
        """Record changes from now on, beginning anew; None ends that, and keeps what was recorded."""
        if now_us is not None:
            self._transitions.clear()
        self._recorded_from_us = now_us

    def take_transitions(self) -> bytes:
        """The changes that were recorded, the newest thousand: time, number and status; told once."""
        told = b"".join(self._transitions)
        self._transitions.clear()
        return told

    def note(self, nodes: Sequence[Mapping[str, object]]) -> None:
        """Know what the nodes that are under way, or have failed, have to say."""
        said = {
            str(one["name"]): str(one["message"])
            for one in nodes
            if one["message"] and one["status"] in ("running", "failure")
        }
        self.said = dict(sorted(said.items()))
