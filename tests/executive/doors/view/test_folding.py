"""Branches of the tree fold by how they stand, until a person says otherwise."""

import re
from types import SimpleNamespace

import pytest

from executive.doors.view.folding import Folding
from executive.doors.view.shown_lines import lines_of


def node(depth, name, status="running"):
    return {"depth": depth, "name": name, "status": status, "message": ""}


def tree(search="success"):
    return [
        node(0, "pick"), node(1, "search", search), node(2, "look", "success"), node(1, "reach"),
        node(2, "plan", "success"), node(2, "stream"), node(1, "lift", "idle"), node(2, "rise", "idle"),
    ]  # fmt: skip


class Gui:
    def add_dropdown(self, _label, options, hint=""):
        self.list = SimpleNamespace(options=options, value=options[0])
        self.list.on_update = lambda call: setattr(self, "call", call)
        return self.list

    def choose(self, path):
        assert path in self.list.options
        self.list.value = path
        self.call(None)


@pytest.fixture
def gui():
    return Gui()


@pytest.fixture
def folding(gui):
    return Folding(gui)


def shown(html):
    return [name for name in re.sub(r"<[^>]+>", " ", html).split() if name.isalpha()]


def test_a_branch_that_runs_is_folded_by_hand_and_unfolded_again(gui, folding):
    assert "stream" in shown(folding.words(tree(), "", False))

    gui.choose("pick/reach")
    assert shown(folding.words(tree(), "", False)) == ["pick", "search", "reach", "lift"]

    gui.choose("pick/reach")
    assert "stream" in shown(folding.words(tree(), "", False))


def test_a_branch_that_is_over_is_unfolded_by_hand_and_stays_so_when_it_runs_again(gui, folding):
    folding.words(tree(), "", False)
    gui.choose("pick/search")

    assert "look" in shown(folding.words(tree(), "", False))
    assert "look" in shown(folding.words(tree("running"), "", False))


def test_what_a_person_has_folded_stays_so_where_all_is_unfolded(gui, folding):
    folding.words(tree(), "", False)
    gui.choose("pick/reach")

    assert shown(folding.words(tree(), "", True)) == ["pick", "search", "look", "reach", "lift", "rise"]


def test_the_branches_in_sight_can_be_chosen_and_the_list_waits_for_the_next_choice(gui, folding):
    folding.words(tree(), "", False)
    none = gui.list.options[0]
    assert gui.list.options[1:] == ("pick", "pick/search", "pick/reach", "pick/lift")

    gui.choose("pick")

    assert gui.list.value == none
    assert shown(folding.words(tree(), "", False)) == ["pick"]


def test_a_search_looks_into_what_is_folded(gui, folding):
    folding.words(tree(), "", False)
    gui.choose("pick")

    assert shown(folding.words(tree(), "stream", False)) == ["pick", "reach", "stream"]


def test_a_page_that_nothing_shows_again_is_told(gui):
    turned = []
    folding = Folding(gui, lambda: turned.append(True))
    folding.words(tree(), "", False)

    gui.choose("pick")

    assert turned == [True]


def test_a_tree_of_250_nodes_is_laid_out_without_losing_one():
    nodes = [node(min(index, index % 7), f"n{index}") for index in range(250)]

    assert [line.node for line in lines_of(nodes, {})] == nodes
