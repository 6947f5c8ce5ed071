"""Where the robot looks first and next: where it was, then turned around, also from where it began."""

import pytest

from trees.skills.gestures.tree import wave
from trees.skills.hand_over.tree import hand_over
from trees.skills.searching.look_elsewhere import turning_if_it_walks
from trees.skills.telling.tree import find
from trees.skills.walk_to.tree import walk_to
from trees.skills.walking.change_viewpoint import ChangeViewpoint


def in_order(tree):
    """Names of the nodes as they come, parents before children."""
    found, waiting = [], [tree]
    while waiting:
        node = waiting.pop(0)
        found.append(node.name)
        waiting[:0] = node.children
    return found


@pytest.mark.requirement("L3", "M6")
@pytest.mark.parametrize("walks", [True, False])
def test_who_is_waved_to_is_looked_for_by_turning_from_where_the_robot_began(stage_with, walks):
    toolbox = stage_with(walks=walks).toolbox
    turned = next(node for node in wave(toolbox).iterate() if node.name == "turned")

    assert any(isinstance(leaf, ChangeViewpoint) for leaf in turned.iterate())
    assert turning_if_it_walks(turned, None) is walks


@pytest.mark.parametrize("skill", [walk_to, find])
def test_what_was_seen_before_is_looked_for_where_it_was_before_anywhere_else(stage_with, skill):
    order = in_order(skill(stage_with(walks=True).toolbox))

    assert order.index("look where it was") < order.index("viewpoint 1")


def test_a_person_is_looked_for_from_upright_too_before_something_is_offered(stage_with):
    order = in_order(hand_over(stage_with(walks=True).toolbox))

    assert order.index("look around") < order.index("from upright") < order.index("offer")
