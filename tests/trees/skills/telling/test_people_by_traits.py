"""People are counted, found and described by what is seen of them; one look that leaves it out is not all."""

from dataclasses import replace

import pytest

from robots.fake.fake_world import cup, person, table
from robots.scenes.scene_description import Region
from tests.trees.household_stage import run, said
from trees.tasks import CountTask, DescribeTask, FindTask, ObjectDescription

ANA = replace(person("Ana", (1.3, 0.5)), traits=("sitting", "red shirt"))
BEN = replace(person("Ben", (1.4, -0.5)), traits=("standing", "waving"))
CLEO = replace(person("Cleo", (2.2, 0.0)), traits=("blue shirt", "sitting"))


def of(*traits):
    return ObjectDescription("person", traits=traits)


@pytest.mark.requirement("L12")
@pytest.mark.parametrize(
    ("traits", "words"),
    [
        (("sitting",), "from here I see two people who are sitting"),
        (("waving",), "from here I see one person who is waving"),
        (("sitting", "blue shirt"), "from here I see one person who is sitting in a blue shirt"),
        (("lying",), "from here I see no people who are lying"),
    ],
)
def test_people_are_counted_by_what_is_seen_of_them(stage_with, traits, words):
    stage = stage_with(table(), cup(), ANA, BEN, CLEO)

    run(stage, CountTask("how many", of(*traits)))

    assert said(stage) == [words]


def test_who_sits_in_a_room_is_counted_there(stage_with):
    stage = stage_with(table(), cup(), ANA, BEN, CLEO, walks=True)
    stage.toolbox = replace(stage.toolbox, places={"hall": Region("hall", (1.3, 0.5), (0.8, 0.8))})

    run(stage, CountTask("how many", of("sitting"), "hall"))

    assert said(stage) == ["in the hall I see one person who is sitting"]


def test_somebody_of_whom_a_look_told_nothing_is_looked_at_again_before_a_number_is_told(stage_with):
    stage = stage_with(table(), cup(), replace(ANA, traits=()), BEN)
    stage.when("survey", lambda: stage.fake.world.put(ANA), after_ticks=2)

    run(stage, CountTask("how many", of("sitting")))

    assert said(stage) == ["from here I see one person who is sitting"]


def test_of_whom_no_look_tells_anything_it_is_told_that_it_is_not_known(stage_with):
    stage = stage_with(table(), cup(), replace(ANA, traits=()), BEN)

    run(stage, CountTask("how many", of("sitting")))

    assert said(stage) == ["from here I see no people who are sitting; of one person I cannot tell"]


def test_who_has_gone_since_an_earlier_task_is_not_counted(stage_with):
    stage = stage_with(table(), cup(), ANA, BEN, walks=True)
    stage.toolbox = replace(stage.toolbox, places={"hall": Region("hall", (1.3, 0.0), (3.0, 3.0))})
    run(stage, CountTask("how many", ObjectDescription("person"), "hall"))
    stage.fake.world.remove("Ben")

    run(stage, CountTask("how many", ObjectDescription("person"), "hall"))

    assert said(stage) == ["in the hall I see two people", "in the hall I see one person"]


def test_somebody_is_found_by_what_is_seen(stage_with):
    tree = run(stage_with(table(), cup(), ANA, BEN), FindTask("find", person=of("waving")))

    assert tree.evidence["found"] == "Ben"


def test_all_are_found_of_whom_the_same_is_seen(stage_with):
    stage = stage_with(table(), cup(), ANA, BEN, CLEO)

    tree = run(stage, FindTask("find", person=of("sitting"), count="all"))

    assert tree.evidence["names"] == "Ana, Cleo"
    assert said(stage)[0].startswith("I see two people who are sitting: Ana ")


def test_of_somebody_it_is_described_how_they_are(stage_with):
    stage = stage_with(table(), cup(), ANA, BEN)

    run(stage, DescribeTask("describe", of("sitting")))

    assert said(stage)[0].startswith("Ana is sitting, in a red shirt, 1.")
