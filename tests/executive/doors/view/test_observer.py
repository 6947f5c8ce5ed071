"""What the page knows of a served robot, over its real sockets."""

import time

import pytest

from executive.doors.served_robot import ServedRobot
from executive.doors.view.observer import Observer
from trees.events import LeafFailed, NodeChanged, Said
from trees.failures import Failure
from trees.snapshot import NodeSnapshot, TreeSnapshot


@pytest.fixture
def observer(served):
    made = Observer(served.folder.path, {"robot": "talos", "scene": "tabletop"})
    until(lambda: served.watched)
    yield made
    made.close()


def until(so):
    begun_s = time.monotonic()
    while not so():
        assert time.monotonic() - begun_s < 20.0
        time.sleep(0.01)


def texts(observer):
    return [line.text for line in observer.seen().log]


def test_events_are_lines_of_the_log_and_steps_are_not(served, observer):
    served.show(lambda watchers: watchers.event(NodeChanged(1.0, "pick/reach", "running", "")))
    served.show(lambda watchers: watchers.event(Said(1.5, "here you are")))

    until(lambda: texts(observer) == ["says: here you are"])


def test_the_tree_is_known_as_it_stands(served, observer):
    tree = TreeSnapshot(2.0, 0, NodeSnapshot("pick", "sequence", "running", "1 of 3"))
    served.show(lambda watchers: watchers.tree(lambda: tree, 2.0))

    until(lambda: [one["message"] for one in observer.seen().nodes] == ["1 of 3"])


def test_a_failure_is_known_until_the_next_task_begins(served, observer):
    served.show(lambda watchers: watchers.event(LeafFailed(1.0, Failure.postcondition("it slipped"))))

    until(lambda: (observer.seen().failure or {}).get("message") == "it slipped")


def test_an_order_of_anybody_is_told_when_it_has_ended(served, observer):
    ServedRobot(served.folder.path).begin("wave")

    until(lambda: "done: it waves" in texts(observer))


def test_what_is_believed_and_how_things_stand_are_asked_for(observer):
    until(lambda: observer.world()["version"] == 7)
    until(lambda: observer.seen().state == "NORMAL")

    assert observer.seen().complaint == ""


def test_an_executive_that_has_gone_is_told(served, observer):
    until(lambda: observer.seen().state == "NORMAL")
    served.close()

    until(lambda: "does not answer" in observer.seen().complaint)
