"""What is told of trees and scenes fits a message of the protocol."""

import json

import pytest

from executive.live.told_as_json import tree_json
from trees.snapshot import NodeSnapshot

ROOM_BYTES = 65_536 - 20_000


def tree(count, message):
    status = ("running", "idle")
    leaves = tuple(NodeSnapshot(f"leaf {i}", "leaf", status[i % 2], message) for i in range(count))
    return NodeSnapshot("root", "sequence", "running", "", leaves)


@pytest.mark.parametrize("message", ["", "x" * 5000, "字" * 5000])
def test_a_large_tree_is_cut_to_a_message_with_the_root_first(message):
    told = tree_json(tree(2000, message))

    assert len(json.dumps(told)) <= ROOM_BYTES
    assert told[0]["name"] == "root"
    assert all(node["status"] != "idle" for node in told)


def test_a_small_tree_is_told_whole():
    assert [node["name"] for node in tree_json(tree(3, "1 of 2"))] == ["root", "leaf 0", "leaf 1", "leaf 2"]
