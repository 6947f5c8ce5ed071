"""Counts and descriptions: of what was not seen it is not said that it is not there."""

import dataclasses

import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Ball, Box
from robots.fake.fake_world import bowl, cup, person, table
from robots.perception.truth_view import TrueObject
from robots.scenes.scene_description import Region
from trees.build import build_tree
from trees.events import Said
from trees.tasks import CountTask, DescribeTask, ObjectDescription, PickTask, Relation

BLUE_CUP = ObjectDescription("cup", "blue")
ANA, BEN = person("Ana", (1.3, 0.4)), person("Ben", (1.4, -0.5))
PEOPLE = ObjectDescription("person")
ROOMS = {
    "kitchen": Region("kitchen", (1.0, 0.0), (4.0, 4.0)),
    "hall": Region("hall", (-5.0, 0.0), (4.0, 4.0)),
}


def leg(y):
    """Of the table; each solid is told by itself."""
    pose = poses.translation(0.75, y, 0.4)
    return TrueObject(f"table/leg {y}", "furniture", "table", None, Box((0.05, 0.05, 0.8)), pose)


def at(x, y):
    return poses.translation(x, y, 0.94)


def run(stage, task, **toolbox):
    return stage.play(build_tree(task, dataclasses.replace(stage.toolbox, **toolbox)))


def said(stage):
    return [event.text for event in stage.events if isinstance(event, Said)]


def test_things_are_counted(stage_with):
    stage = stage_with(table(), cup(), cup("blue cup", "blue", (0.5, 0.1)), cup("cup 3", "blue", (0.6, 0.3)))

    tree = run(stage, CountTask("how many blue cups", BLUE_CUP))

    assert tree.status == "success"
    assert tree.evidence["count"] == 2
    assert said(stage) == ["there are two blue cups"]
    assert 0.5 < tree.evidence["confidence"] <= 1.0


@pytest.mark.parametrize(("noun", "count"), [("credenza", 1), ("side table", 1), ("dresser", 0)])
def test_furniture_is_counted_by_what_it_is_called_besides(stage_with, noun, count):
    stage = stage_with(dataclasses.replace(table("side table/top"), names=("credenza",)))

    tree = run(stage, CountTask(f"how many {noun}s", ObjectDescription(noun)))

    assert tree.evidence["count"] == count


def test_what_a_hand_holds_counts_too(stage_with):
    stage = stage_with(table(), cup(), cup("red cup 2", "red", (0.5, 0.1)))
    stage.play(stage.pick(PickTask("pick it up", ObjectDescription("cup", "red", ordinal="leftmost"))))

    tree = run(stage, CountTask("how many red cups", ObjectDescription("cup", "red")))

    assert tree.evidence["count"] == 2
    assert said(stage)[-1] == "there are two red cups, 1 of them in my hand"


def test_none_is_a_number(stage):
    tree = run(stage, CountTask("how many boxes", ObjectDescription("box")))

    assert tree.evidence["count"] == 0
    assert said(stage) == ["there are no boxes"]


def test_a_table_is_described(stage_with):
    stage = stage_with(table(), cup(), cup("blue cup", "blue", (0.5, 0.1)))

    run(stage, DescribeTask("what is on the table", source="table"))

    assert said(stage) == ["on the table I see one blue cup and one red cup"]


def test_which_is_the_heaviest_is_told_to_be_unknown_with_what_there_is(stage_with):
    stage = stage_with(table(), cup(), cup("blue cup", "blue", (0.5, 0.1)))

    tree = run(
        stage, DescribeTask("what is the heaviest cup", ObjectDescription("cup", size="heaviest"), "table")
    )

    assert tree.status == "success"
    (told,) = said(stage)
    assert "which is the heaviest I do not know; there I see one blue cup and one red cup" in told


@pytest.mark.requirement("M2")
def test_what_is_in_something_hollow_is_told_and_not_that_it_is_on_top(stage_with):
    place_m = bowl().world_T_object[:2, 3]
    inside = poses.translation(*place_m, 0.94)
    ball = TrueObject("green ball", "object", "ball", "green", Ball(0.03), inside)
    stage = stage_with(table(), cup(), bowl(), ball)

    run(stage, DescribeTask("what is in the bowl", source=ObjectDescription("bowl")))

    assert said(stage) == ["in or on the bowl I see one green ball"]


@pytest.mark.requirement("M2")
@pytest.mark.parametrize(
    "task",
    [
        DescribeTask("what is on the counter", source="counter"),
        CountTask("how many cups are on the counter", ObjectDescription("cup"), source="counter"),
    ],
)
def test_of_furniture_that_was_not_seen_it_is_not_said_that_nothing_is_on_it(stage_with, task):
    stage = stage_with(table(), cup())

    tree = run(stage, task)

    assert tree.status == "failure"
    assert tree.failure.root.message == "no counter seen"
    assert said(stage) == []


@pytest.mark.requirement("M2")
@pytest.mark.parametrize(
    "task",
    [
        DescribeTask("what is on the table", source="table"),
        CountTask("how many cups are on the table", ObjectDescription("cup"), source="table"),
    ],
)
def test_of_a_table_far_away_not_all_that_is_on_it_is_told(new_stage, task):
    far = dataclasses.replace(table(), world_T_object=poses.translation(1.9, 0.0, 0.4))
    walking, standing = new_stage(far, walks=True), new_stage(far)

    assert run(walking, task).failure.root.message == "the table is too far away to see all that is on it"
    assert said(walking) == []
    assert run(standing, task).status == "success"


@pytest.mark.requirement("M2")
def test_where_a_part_of_the_table_is_hidden_it_is_not_said_that_this_is_all(stage_with):
    tall = TrueObject(
        "big box", "object", "box", None, Box((0.05, 0.4, 0.4)), poses.translation(0.6, 0.0, 1.1)
    )
    stage = stage_with(table(), cup(), tall)

    tree = run(stage, CountTask("how many cups", ObjectDescription("cup"), source="table"))

    assert tree.status == "success"
    assert said(stage) == ["not all of the table is to be seen; there I see one cup"]
    assert tree.evidence["seen_whole"] is False


BIGGEST = DescribeTask(
    "what is the biggest thing on the table", ObjectDescription(size="biggest"), source="table"
)


def test_the_biggest_is_told_of_those_that_are_seen_where_a_part_is_hidden(stage_with):
    tall = TrueObject(
        "big box", "object", "box", None, Box((0.05, 0.4, 0.4)), poses.translation(0.6, 0.0, 1.1)
    )
    stage = stage_with(table(), cup(), tall)

    tree = run(stage, BIGGEST)

    (words,) = said(stage)
    assert words.startswith("not all of the table is to be seen; of what I see it is the box, ")
    assert tree.evidence["seen_whole"] is False


def test_the_biggest_is_told_without_reserve_where_all_is_seen(stage_with):
    stage = stage_with(table(), cup())

    tree = run(stage, BIGGEST)

    (words,) = said(stage)
    assert words.startswith("the red cup is ")
    assert tree.evidence["seen_whole"] is True


@pytest.mark.parametrize("size", ["biggest", "largest", "smallest"])
def test_where_several_are_of_one_size_all_are_told_and_nobody_is_asked_back(stage_with, size):
    tall = TrueObject("white box", "object", "box", "white", Box((0.06, 0.09, 0.06)), at(0.5, 0.3))
    tiny = TrueObject("red ball", "object", "ball", "red", Ball(0.042), at(0.6, -0.4))
    stage = stage_with(table(), cup(), cup("blue cup", "blue", (0.5, 0.1)), tall, tiny)

    tree = run(stage, DescribeTask("which one", ObjectDescription(size=size), source="table"))

    (words,) = said(stage)
    assert tree.status == "success"
    assert words.startswith(f"none is clearly the {size}: ")
    assert {"red cup", "blue cup"} <= set(tree.evidence["names"].split(", "))


def test_the_biggest_in_a_room_is_compared_with_nothing_in_another(stage_with):
    tall = TrueObject("white box", "object", "box", "white", Box((0.08, 0.1, 0.2)), at(0.5, 0.3))
    tiny = TrueObject("red ball", "object", "ball", "red", Ball(0.03), at(0.5, -0.35))
    stage = stage_with(table(), cup(), tall, tiny)
    half = {"hall": Region("hall", (0.6, -0.5), (2.0, 1.1))}

    tree = run(
        stage, DescribeTask("which one", ObjectDescription(size="biggest"), source="hall"), places=half
    )

    assert tree.status == "success"
    assert tree.evidence["names"] == "red cup"


def test_of_a_size_that_cannot_be_seen_nothing_is_said(stage_with):
    stage = stage_with(table(), cup(), cup("blue cup", "blue", (0.5, 0.1)))

    tree = run(stage, DescribeTask("which one", ObjectDescription(size="prettiest"), source="table"))

    assert tree.failure.root.message == "which one is prettiest? that cannot be seen"
    assert said(stage) == []


def test_which_is_the_biggest_on_a_table_far_away_is_not_told_from_there(new_stage):
    far = dataclasses.replace(table(), world_T_object=poses.translation(1.9, 0.0, 0.4))
    stage = new_stage(
        far, dataclasses.replace(cup(), world_T_object=poses.translation(1.7, 0.0, 0.5)), walks=True
    )

    tree = run(stage, BIGGEST)

    assert tree.failure.root.message == "the table is too far away to see all that is on it"


def test_nothing_is_on_no_counter_even_where_nothing_is_seen_at_all(stage_with):
    tree = run(stage_with(), DescribeTask("what is on the counter", source="counter"))

    assert tree.failure.root.message == "no counter seen"


@pytest.mark.requirement("M2")
@pytest.mark.parametrize(
    ("task", "words"),
    [
        (CountTask("how many people are there", PEOPLE), "from here I see two people"),
        (CountTask("how many people are next to the table", PEOPLE, "table"), "from here I see two people"),
        (DescribeTask("what do you see"), "here I see the table, one red cup, Ana and Ben"),
        (DescribeTask("what is on the table", source="table"), "on the table I see one red cup"),
    ],
)
def test_people_are_told_who_stand_farther_away_than_hands_reach(stage_with, task, words):
    stage = stage_with(table(), cup(), ANA, BEN)

    run(stage, task)

    assert said(stage) == [words]


def test_of_the_table_it_is_told_by_its_own_name(stage_with):
    side = TrueObject("side table/top", "furniture", "table", None, table().shape, table().world_T_object)
    stage = stage_with(side, cup())

    run(stage, DescribeTask("what is on the table", source="table"))
    run(stage, CountTask("how many cups are on the table", ObjectDescription("cup"), source="table"))

    assert said(stage) == ["on the side table I see one red cup", "on the side table there is one cup"]


@pytest.mark.parametrize(
    ("kind", "words"),
    [
        ("table", "one table"),
        ("side table", "no side tables"),
        ("shelf", "no shelves"),
        ("fridge", "no fridges"),
    ],
)
def test_furniture_is_counted_by_the_piece_and_only_as_far_as_it_is_seen(stage_with, kind, words):
    stage = stage_with(table(), leg(0.3), leg(-0.3), cup())

    tree = run(stage, CountTask("how many", ObjectDescription(kind)))

    assert said(stage) == [f"from here I see {words}"]
    assert tree.evidence["count"] == (kind == "table")


@pytest.mark.parametrize(
    ("task", "words"),
    [
        (
            DescribeTask("what is in here", source="kitchen"),
            "in the kitchen I see the table, one red cup and Ana",
        ),
        (CountTask("how many people", PEOPLE, "kitchen"), "in the kitchen I see one person"),
        (CountTask("how many people", PEOPLE, "hall"), "in the hall I see no people"),
        (CountTask("how many cups", ObjectDescription("cup")), "from here I see one cup"),
    ],
)
def test_of_a_room_what_stands_in_it_is_told(stage_with, task, words):
    stage = stage_with(table(), cup(), ANA, walks=True)

    run(stage, task, places=ROOMS)

    assert said(stage) == [words]


def test_what_was_seen_elsewhere_is_not_told_to_be_here(stage_with):
    stage = stage_with(table(), cup(), ANA)
    run(stage, DescribeTask("what do you see"))
    stage.fake.world.hidden.add("red cup")

    run(stage, DescribeTask("what do you see"))

    assert said(stage)[1] == "here I see the table and Ana"


@pytest.mark.parametrize(
    ("to", "words"),
    [("table", "the red cup is on the table"), ("blue cup", "nothing is next to the blue cup")],
)
def test_what_is_near_something_is_told_or_that_nothing_is(stage_with, to, words):
    stage = stage_with(table(), cup(), cup("blue cup", "blue", (0.5, 0.4)))
    relation = Relation("on", to) if to == "table" else Relation("next_to", BLUE_CUP)
    wanted = (
        ObjectDescription("cup", "red", relation=relation)
        if to == "table"
        else ObjectDescription(relation=relation)
    )

    run(stage, DescribeTask("what is it", wanted))

    assert said(stage)[0].startswith(words)


@pytest.mark.requirement("L6")
def test_who_is_described_has_no_article(stage_with):
    stage = stage_with(table(), ANA, BEN)

    run(
        stage,
        DescribeTask("describe the person on the left", ObjectDescription("person", ordinal="leftmost")),
    )

    assert said(stage)[0].startswith("Ana is 1.")


def test_before_furniture_with_nothing_on_it_the_furniture_is_told(stage_with):
    stage = stage_with(table())

    run(stage, DescribeTask("what do you see"))
    run(stage, DescribeTask("what is on the table", source="table"))

    assert said(stage) == ["here I see the table", "on the table I see nothing"]
