"""A handle that is not seen from here is looked for a step back, and all around."""

import pytest

from trees.nodes.alternatives import Alternatives
from trees.nodes.leaf import Leaf
from trees.skills.doors.close import close
from trees.skills.doors.open import open_or_close
from trees.skills.doors.recall_handle import RecallHandle
from trees.skills.walking.change_viewpoint import ChangeViewpoint


@pytest.mark.parametrize("skill", [open_or_close, close])
def test_a_robot_that_walks_steps_back_and_turns_before_it_says_that_nothing_is_there(stage, skill):
    tree = skill(stage.toolbox)

    searches = [node for node in tree.iterate() if isinstance(node, Alternatives) and node.name == "search"]
    ways = [
        [leaf.settings["way"] for leaf in search.iterate() if isinstance(leaf, ChangeViewpoint)]
        for search in searches
    ]

    assert ways
    assert all(way[:2] == ["room", "back"] and way.count("around") >= 3 for way in ways)


@pytest.mark.parametrize("skill", [open_or_close, close])
def test_what_was_seen_before_and_is_far_away_is_gone_back_to_first(stage, skill):
    tree = skill(stage.toolbox)

    searches = [node for node in tree.iterate() if isinstance(node, Alternatives) and node.name == "search"]

    assert searches
    assert all(isinstance(next(_leaves(search)), RecallHandle) for search in searches)


def _leaves(node):
    return (item for item in node.iterate() if isinstance(item, Leaf))
