"""Which gazes a search has depends on what aims the eyes: a neck, the trunk, or nothing."""

import dataclasses

import pytest

from robots.models.description import load_description
from trees.skills.looking.detect import Detect
from trees.skills.looking.search import search


class Elsewhere:
    """A model of another robot, as far as a search asks."""

    def __init__(self, robot):
        self.description = load_description(robot)


def first_looks(stage, robot):
    """Gazes that follow one another while nothing is seen."""
    toolbox = dataclasses.replace(stage.toolbox, model=Elsewhere(robot))
    looks = search("search", toolbox).children
    return [
        look.name
        for look in looks
        if any(leaf.part == "first" for leaf in look.children if isinstance(leaf, Detect))
    ]


@pytest.mark.requirement("U4")
def test_a_trunk_that_aims_looks_to_both_sides_where_nothing_is_seen_ahead(stage):
    looks = first_looks(stage, "g1")

    assert looks[0] == "look ahead"
    assert {"look near left", "look near right"} <= set(looks)
    assert "look at the body" not in looks  # a trunk does not lean besides


def test_eyes_that_nothing_aims_look_once(stage):
    assert first_looks(stage, "panda") == ["look ahead"]


def test_a_neck_looks_everywhere(stage):
    assert len(first_looks(stage, "talos")) > 6
