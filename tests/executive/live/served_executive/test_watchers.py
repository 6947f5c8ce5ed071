"""Who watches is told of events and of a tree that changes, and nothing is made while nobody does."""

import pytest

from executive.live.served_executive.watchers import TREE_EVERY_S, Watchers
from executive.session.events import SensorsNoted
from robots.live.wire.messages import read_object
from trees.events import NodeChanged, Said
from trees.snapshot import NodeSnapshot, TreeSnapshot


class Somebody:
    def __init__(self):
        self.told = []

    def send(self, message):
        self.told.append(read_object(message))


class Tree:
    """Says what it is told to say, and counts how often it is looked at."""

    def __init__(self):
        self.message, self.looks = "", 0

    def __call__(self):
        self.looks += 1
        return TreeSnapshot(0.0, 0, NodeSnapshot("task", "sequence", "running", self.message))


@pytest.fixture
def somebody():
    return Somebody()


@pytest.fixture
def watchers(somebody):
    made = Watchers()
    made.add(somebody)
    return made


def test_an_event_is_told_with_its_line_for_people(watchers, somebody):
    watchers.event(NodeChanged(2.0, "pick/reach", "running", ""))

    assert somebody.told[0]["told"]["where"] == "pick/reach"
    assert somebody.told[0]["line"] == "EXECUTING: pick/reach"


def test_what_is_for_the_digest_alone_is_not_told(watchers, somebody):
    watchers.event(SensorsNoted(2.0, "abc"))

    assert somebody.told == []


@pytest.mark.parametrize("text", ["x" * 70_000, "字" * 15_000])
def test_an_event_that_fits_no_message_loses_what_it_says(watchers, somebody, text):
    watchers.event(Said(2.0, text))

    assert somebody.told[0]["told"] == {"event": "Said", "t_s": 2.0}


def test_a_tree_is_told_where_it_has_changed_and_not_too_often(watchers, somebody):
    tree = Tree()
    watchers.tree(tree, 1.0)
    tree.message = "at once"
    watchers.tree(tree, 1.0 + 0.5 * TREE_EVERY_S)
    watchers.tree(tree, 1.0 + 1.5 * TREE_EVERY_S)
    watchers.tree(tree, 1.0 + 3.0 * TREE_EVERY_S)

    assert [told["nodes"][0]["message"] for told in somebody.told] == ["", "at once"]


def test_the_last_state_of_a_tree_is_told_at_once(watchers, somebody):
    tree = Tree()
    watchers.tree(tree, 1.0)
    tree.message = "over"
    watchers.tree(tree, 1.001, last=True)

    assert somebody.told[-1]["nodes"][0]["message"] == "over"


def test_who_comes_later_is_told_the_tree_as_it_stands(watchers):
    tree, other = Tree(), Somebody()
    watchers.tree(tree, 1.0)
    watchers.add(other)
    watchers.tree(tree, 1.0 + 2.0 * TREE_EVERY_S)

    assert other.told[-1]["nodes"][0]["name"] == "task"


def test_a_tree_is_not_looked_at_while_nobody_watches(watchers, somebody):
    tree = Tree()
    watchers.remove(somebody)
    watchers.tree(tree, 1.0)

    assert tree.looks == 0
