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


@pytest.mark.parametrize(("room", "side"), [("hall", 0.25), ("lobby", -0.25)])
def test_a_thing_that_is_said_to_be_in_a_room_is_none_that_is_seen_elsewhere(stage_with, room, side):
    left, right = cup("red cup", "red", (0.45, 0.25)), cup("red cup 2", "red", (0.45, -0.25))
    stage = stage_with(table(), left, right)
    rooms = {"hall": (1.0, 1.0), "lobby": (1.0, -1.0)}
    stage.toolbox = replace(
        stage.toolbox, places={name: Region(name, at, (4.0, 2.0)) for name, at in rooms.items()}
    )

    tree = run(stage, FindTask("find", ObjectDescription("cup", "red"), source=room))

    assert tree.status == "success"
    assert tree.evidence["y_m"] == pytest.approx(side, abs=0.02)


def test_a_thing_that_is_seen_in_another_room_alone_is_not_found(stage_with):
    stage = stage_with(table(), cup("red cup", "red"))
    stage.toolbox = replace(stage.toolbox, places=HALL | {"far": Region("far", (9.0, 9.0), (1.0, 1.0))})

    tree = run(stage, FindTask("find", ObjectDescription("cup", "red"), source="far"))

    assert tree.status == "failure"


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


def test_a_thing_that_was_found_is_what_is_meant_from_then_on(stage_with):
    assert run(stage_with(table(), cup()), FindTask("find", ObjectDescription("cup"))).acted_on == "red cup"


def test_who_was_found_is_no_thing_that_is_meant_from_then_on(stage_with):
    assert run(stage_with(ANA), FindTask("find", person="Ana")).acted_on is None
