"""Where something is seen to be; what is taken for its sort is told, once."""

from dataclasses import replace

import pytest

from robots.fake.fake_world import cup, person, table
from robots.scenes.scene_description import Region
from tests.trees.household_stage import run, said
from trees.tasks import FindTask, LookAtTask, ObjectDescription

SOUP = replace(cup("tomato soup", "red"), names=("tomato soup",), categories=("food",))
HALL = {"hall": Region("hall", (1.3, 0.8), (1.0, 1.0))}
ANA, BEN = person("Ana", (1.3, 0.5)), person("Ben", (1.3, 0.0))


def test_what_is_taken_for_its_sort_is_told_once(stage_with):
    stage = stage_with(table(), SOUP)

    tree = run(stage, LookAtTask("look at the food", ObjectDescription("food")))

    assert tree.status == "success"
    assert said(stage) == ["the tomato soup is the only food that I see"]


def test_what_is_called_so_needs_no_reason(stage_with):
    stage = stage_with(table(), SOUP)

    run(stage, LookAtTask("look at the tomato soup", ObjectDescription("tomato soup")))

    assert said(stage) == []


@pytest.mark.parametrize("who", [ObjectDescription("person"), "Ana"])
def test_who_is_said_to_be_in_a_room_is_seen_there(stage_with, who):
    stage = stage_with(ANA, BEN)
    stage.toolbox = replace(stage.toolbox, places=HALL)

    tree = run(stage, FindTask("find", person=who, source="hall"))

    assert tree.evidence["found"] == "Ana"


def test_who_is_said_to_be_at_some_furniture_stands_next_to_it(stage_with):
    stage = stage_with(table(), person("Ana", (3.4, 0.4)), person("Ben", (1.3, -0.3)))

    tree = run(stage, FindTask("find", person=ObjectDescription("person"), source="table"))

    assert tree.evidence["found"] == "Ben"
