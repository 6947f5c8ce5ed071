"""Several things that are looked for: each is told with where it is, and only what was seen."""

import dataclasses

import pytest

from robots.fake.fake_world import cup, person, table
from robots.scenes.scene_description import Region
from trees.build import build_tree
from trees.events import Said
from trees.failures import FailureKind
from trees.tasks import FindTask, ObjectDescription

CUP = ObjectDescription("cup")
BLUE = cup("blue cup", "blue", (0.5, 0.1))
KITCHEN = {"kitchen": Region("kitchen", (1.0, 0.0), (4.0, 4.0))}


def run(stage, task, **toolbox):
    return stage.play(build_tree(task, dataclasses.replace(stage.toolbox, **toolbox)))


def said(stage):
    return [event.text for event in stage.events if isinstance(event, Said)]


@pytest.mark.parametrize("count", ["all", "both", 2])
def test_each_is_told_with_where_it_is(stage_with, count):
    stage = stage_with(table(), cup(place_m=(0.45, -0.2)), BLUE)

    tree = run(stage, FindTask("where are the cups?", CUP, count=count))

    assert tree.status == "success"
    assert said(stage) == [
        "I see two cups: the red cup on the table, 0.45 m ahead, 0.20 m to the right; "
        "the blue cup on the table, 0.50 m ahead, 0.10 m to the left"
    ]
    assert (tree.evidence["count"], tree.evidence["names"]) == (2, "red cup, blue cup")
    assert 0.5 < tree.evidence["confidence"] <= 1.0


def test_none_is_a_failure(stage_with):
    tree = run(stage_with(table(), cup()), FindTask("find all boxes", ObjectDescription("box"), count="all"))

    assert tree.status == "failure"
    assert tree.failure.message == "could not find all boxes: no box seen"


@pytest.mark.parametrize(("count", "asked"), [("both", "both cups"), (3, "three cups")])
def test_of_fewer_than_were_said_it_is_told_what_was_seen(stage_with, count, asked):
    stage = stage_with(table(), cup(place_m=(0.45, -0.2)))

    tree = run(stage, FindTask("find them", CUP, count=count))

    assert tree.failure.kind is FailureKind.POSTCONDITION
    assert tree.failure.message == (
        f"could not find {asked}: I see only one cup: "
        "the red cup on the table, 0.45 m ahead, 0.20 m to the right"
    )
    assert tree.failure.root.numbers["count"] == 1
    assert said(stage) == []


def test_what_is_only_remembered_is_not_found(stage_with):
    stage = stage_with(table(), cup(), BLUE)
    run(stage, FindTask("find all cups", CUP, count="all"))
    stage.fake.world.hidden.add("blue cup")

    tree = run(stage, FindTask("find all cups", CUP, count="all"))

    assert tree.evidence["names"] == "red cup"


def test_those_that_no_word_tells_apart_have_no_article(stage_with):
    stage = stage_with(table(), cup("cup 1", "red", (0.45, -0.2)), cup("cup 2", "red", (0.5, 0.2)))

    run(stage, FindTask("find both cups", CUP, count="both"))

    assert "one red cup on the table, 0.45 m" in said(stage)[0]
    assert "one red cup on the table, 0.50 m" in said(stage)[0]


def test_nothing_is_chosen_for_the_task_after_it(stage_with):
    stage = stage_with(table(), cup(), BLUE)

    tree = run(stage, FindTask("find all cups", CUP, count="all"))

    assert tree.acted_on is None
    assert stage.toolbox.world.last_acted_on is None


def test_people_are_told_by_name(stage_with):
    stage = stage_with(table(), person("Ana", (1.3, 0.4)), person("Ben", (1.4, -0.5)))

    run(stage, FindTask("where are the people?", person=ObjectDescription("person"), count="all"))

    assert said(stage)[0].startswith("I see two people: Ana 1.30 m ahead")


@pytest.mark.parametrize(("source", "where"), [("kitchen", "in the kitchen"), (None, "from here")])
def test_in_a_flat_it_is_told_where_was_looked(stage_with, source, where):
    stage = stage_with(table(), cup(), BLUE, walks=True)

    run(stage, FindTask("find all cups", CUP, source=source, count="all"), places=KITCHEN)

    assert said(stage)[0].startswith(f"I see two cups {where}: the red cup on the table, in the kitchen, ")
