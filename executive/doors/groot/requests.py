"""What Groot2 asks, and what it is answered: the protocol of BehaviorTree.CPP's ``Groot2Publisher``.

A request is six bytes, the protocol's version, a letter and a number that the answer bears again, and for
some letters a second part. An answer is these six bytes and the tree's id, then what was asked for; or
``error`` and why. Numbers have their low byte first.
"""

from __future__ import annotations

import struct
from collections.abc import Sequence

import msgpack

from executive.doors.groot.monitored_tree import MonitoredTree

_HEAD = struct.Struct("<BcI")
_VERSION = 2
_SET_HOOKS = (b"I", b"R", b"U")
"""Insert, remove, and let go on what has stopped at one."""
_IN_TWO_PARTS = (b"B", b"r", *_SET_HOOKS)
HOOKS_REFUSED = "hooks are refused: they would hold a node, or force its status, of a robot that moves"


def answer(request: Sequence[bytes], tree: MonitoredTree, now_us: int) -> list[bytes]:
    """Answer a request.

    Args:
        request: Its parts.
        tree: The one that is looked at.
        now_us: Microseconds since 1970.

    Returns:
        The parts of the answer.
    """
    if not request or len(request[0]) != _HEAD.size:
        return _error("wrong request header")
    _, letter, number = _HEAD.unpack(request[0])
    if letter in _IN_TWO_PARTS and len(request) != 2:
        return _error("must be 2 parts message")
    if letter in _SET_HOOKS:
        return _error(HOOKS_REFUSED)
    parts = _parts(letter, request[1:], tree, now_us)
    if parts is None:
        return _error("Request not recognized")
    return [_HEAD.pack(_VERSION, letter, number) + tree.id, *parts]


def _parts(letter: bytes, more: Sequence[bytes], tree: MonitoredTree, now_us: int) -> list[bytes] | None:
    """What follows the head of an answer; None where nothing is known of such a request."""
    match letter:
        case b"T":  # the tree
            return [tree.xml.encode()]
        case b"S":  # statuses
            return [tree.statuses]
        case b"B":  # blackboards, by the names of their trees
            return [_blackboard(more[0], tree)]
        case b"r":  # begin or end to record changes
            return _record(more[0], tree, now_us)
        case b"t":  # those that were recorded
            return [tree.take_transitions()]
        case b"D":  # hooks, of which there are none
            return [b"[]"]
        case b"A" | b"X":  # forget or disable them all
            return []
    return None


def _blackboard(names: bytes, tree: MonitoredTree) -> bytes:
    """What nodes have to say stands for the blackboard of the tree, whose values are no texts."""
    asked = names.decode("utf-8", "replace").split(";")
    told = {tree.name: dict(tree.said) or None} if tree.name and tree.name in asked else None
    packed: bytes = msgpack.packb(told)
    return packed


def _record(word: bytes, tree: MonitoredTree, now_us: int) -> list[bytes]:
    if word == b"start":
        tree.record(now_us)
        return [str(now_us).encode()]
    if word == b"stop":
        tree.record(None)
    return []


def _error(why: str) -> list[bytes]:
    return [b"error", why.encode()]
