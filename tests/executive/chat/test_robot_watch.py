"""How the robot stands, read from what it answers."""

import time

from executive.chat.robot_watch import RobotWatch, standing_in, tree_of
from robots.live.wire.errors import LiveError


def node(depth, name, status="running", message=""):
    return {"depth": depth, "name": name, "status": status, "message": message}


NODES = [
    node(0, "pick"),
    node(1, "look", "success"),
    node(2, "detect", "success"),
    node(1, "reach", message="4%"),
]


def test_a_tree_is_put_together_from_its_nodes():
    root = tree_of(NODES)

    assert [child.name for child in root.children] == ["look", "reach"]
    assert root.children[0].children[0].name == "detect"
    assert (root.children[1].kind, root.children[1].message) == ("leaf", "4%")


def test_the_last_tree_stands_after_its_task():
    ended = standing_in({"tree": None, "last_tree": [node(0, "pick", "success")]}, None)

    assert ended.tree.root.status == "success"


def test_a_tree_that_was_halted_stands_as_it_was_seen_last_and_nothing_of_it_runs():
    before = standing_in({"tree": NODES}, None).tree
    halted = standing_in({"tree": None, "last_tree": [node(0, "pick", "idle")]}, before)

    assert [halted.tree.root.status, *(one.status for one in halted.tree.root.children)] == [
        "failure", "success", "failure"
    ]  # fmt: skip


def test_an_emergency_stop_is_told_with_its_reason():
    assert standing_in({"emergency": {"engaged": "Ctrl-C"}}, None).emergency == "Ctrl-C"
    assert standing_in({"emergency": None}, None).emergency == ""


def test_a_robot_that_does_not_answer_is_told_as_silent():
    class Silent:
        def status(self):
            raise LiveError("nobody listens")

    watch = RobotWatch(Silent())
    while not watch.now.silent:
        time.sleep(0.001)
    watch.close()

    assert watch.now.silent == "nobody listens"
    assert not watch.now.lost
