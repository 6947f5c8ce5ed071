"""Putting things down: where they go, what is lost on the way, and what is never claimed."""

import dataclasses
import math

import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from kinematics.requests.move import RetreatRequest
from kinematics.requests.place import PlaceRequest
from kinematics.scene.support_of import top_m
from robots.fake.fake_world import bowl, cup, person, table
from robots.perception.truth_view import TrueObject
from robots.scenes.scene_description import Region
from tests.trees.household_stage import (
    BLUE_CUP,
    BOX_BEFORE_IT,
    RED_CUP,
    asked,
    long_enough_to_feel_on_the_way,
    run,
)
from trees.build import build_tree
from trees.tasks import WHERE_IT_WAS, ObjectDescription, PlaceTask, PutInTask, Relation


def test_a_cup_is_picked_up_and_put_down_beside_another(stage_with):
    stage = stage_with(table(), cup(), cup("blue cup", "blue", (0.5, 0.1)))
    beside = ObjectDescription(relation=Relation("right_of", BLUE_CUP))

    tree = run(stage, PlaceTask("put the red cup right of the blue cup", RED_CUP, to=beside))

    place = stage.fake.world.object("red cup").world_T_object
    assert tree.status == "success"
    assert tree.evidence["off_m"] <= 0.03
    assert place[2, 3] == pytest.approx(0.955, abs=0.01)
    assert -0.35 < place[1, 3] - 0.1 < -0.06
    assert stage.fake.world.carried_by("red cup") is None
    remembered = stage.told.put_down["red cup"].world_T_object
    assert remembered[:2, 3] == pytest.approx(place[:2, 3], abs=0.02)


def test_where_there_is_no_room_beside_a_thing_is_said(stage_with):
    stage = stage_with(table(), cup(), cup("blue cup", "blue", (0.38, 0.1)))
    before = ObjectDescription(relation=Relation("in_front_of", BLUE_CUP))

    tree = run(stage, PlaceTask("put the red cup in front of the blue cup", RED_CUP, to=before))

    assert tree.status == "failure"
    assert "no spot in front of the blue cup for the red cup" in tree.failure.message


@pytest.mark.requirement("M4")
def test_what_shifts_in_the_hand_on_its_way_still_comes_to_stand_where_it_was_meant_to(stage):
    def shift():
        stage.fake.world.shift_in_hand("red cup", 0.02)

    stage.when("transfer", shift)

    tree = run(stage, PlaceTask("put the red cup on the table", RED_CUP, on="table"))

    assert tree.status == "success"
    assert len(asked(stage, PlaceRequest)) == 2
    assert tree.evidence["off_m"] <= 0.005


def test_what_is_held_already_is_not_picked_again(stage):
    stage.play(stage.pick())
    begun = len(stage.events)

    tree = run(stage, PlaceTask("put it down", None, on="table"))

    assert tree.status == "success"
    assert not [event for event in stage.events[begun:] if "fetch it" in getattr(event, "where", "")]


def test_a_cup_under_which_nothing_is_felt_is_kept(stage):
    stage.play(stage.pick())
    stage.fake.world.pressed_m = lambda _name: None

    tree = run(stage, PlaceTask("put it down", None, on="table"))

    assert tree.status == "failure"
    assert stage.fake.world.carried_by("red cup") == "right"
    assert "nothing is felt under the red cup" in tree.failure.message


def test_a_table_that_seemed_higher_does_not_bar_the_way_farther_down(stage):
    long_enough_to_feel_on_the_way(stage)
    stage.play(stage.pick())
    stage.fake.detector.offset_m["table"] = (0.0, 0.0, 0.02)

    tree = run(stage, PlaceTask("put it down", None, on="table"))

    further = [request for request in asked(stage, RetreatRequest) if request.world_offset_m[2] < 0.0]
    tops_m = [top_m(request.scene.objects["table"]) for request in further]
    assert tree.status == "success"
    assert len(tops_m) > 1
    # already for the first step down: where it comes to nothing is, or it is felt
    assert tops_m[0] < top_m(stage.told.scene.objects["table"]) - 0.005
    assert tops_m[-1] < top_m(stage.told.scene.objects["table"]) - 0.005


def test_on_what_in_a_room_something_goes_has_to_be_said(stage):
    stage.play(stage.pick())
    rooms = {"kitchen": Region("kitchen", (0.0, 0.0), (4.0, 4.0))}

    task = PlaceTask("put it into the kitchen", None, to="kitchen")
    tree = stage.play(build_tree(task, dataclasses.replace(stage.toolbox, places=rooms)))

    assert tree.failure.root.message == "on what in the kitchen shall it be put?"
    assert tree.failure.choices == ("the table",)
    assert tree.failure.choice_slot == "on"
    assert stage.fake.grippers["right"].reading().holding


@pytest.mark.requirement("L3")
@pytest.mark.parametrize(
    ("who", "y_m"),
    [("Ana", 0.3), ("Ben", -0.3), (ObjectDescription("person", ordinal="rightmost"), -0.3), ("me", 0.3)],
)
def test_in_front_of_somebody_is_on_the_table_between(stage_with, who, y_m):
    stage = stage_with(table(), cup(), person("Ana", (1.25, 0.3)), person("Ben", (1.3, -0.3)))
    before = ObjectDescription(relation=Relation("in_front_of", who))

    tree = run(stage, PlaceTask("put it there", RED_CUP, to=before))

    x, y, _ = stage.fake.world.object("red cup").world_T_object[:3, 3]
    assert tree.status == "success"
    assert abs(y - y_m) < math.tan(math.radians(40)) * (1.25 - x)
    assert abs(y - y_m) < abs(y + y_m)
    assert 0.35 < x < 0.95


@pytest.mark.parametrize(
    ("who", "told"),
    [
        ("Zoe", "no Zoe seen"),
        ("Ana", "there is no spot in front of Ana"),
    ],
)
def test_who_is_not_there_or_stands_far_from_every_table_gets_nothing_put_before_them(stage_with, who, told):
    stage = stage_with(table(), cup(), person("Ana", (2.4, 0.3)))
    before = ObjectDescription(relation=Relation("in_front_of", who))

    tree = run(stage, PlaceTask("put it there", RED_CUP, to=before))

    assert told in tree.failure.root.message


@pytest.mark.requirement("L2")
def test_what_is_put_back_stands_where_it_was_taken_from(stage):
    before = stage.fake.world.object("red cup").world_T_object[:2, 3].copy()
    stage.play(stage.pick())

    tree = run(stage, PlaceTask("put it back", RED_CUP, to=WHERE_IT_WAS))

    assert tree.status == "success"
    assert stage.fake.world.object("red cup").world_T_object[:2, 3] == pytest.approx(before, abs=0.01)


def test_what_is_put_back_with_the_other_hand_does_not_go_to_where_it_was_put_between(stage):
    stage.play(stage.pick())
    first = stage.toolbox.world.taken_from["red cup"]
    stage.toolbox.world.note_taken("red cup", dataclasses.replace(first, support="shelf"))

    assert stage.toolbox.world.taken_from["red cup"] == first


def test_what_no_hand_has_taken_is_not_put_back(stage):
    tree = run(stage, PlaceTask("put it back", RED_CUP, to=WHERE_IT_WAS))

    assert "where the red cup was is not known" in tree.failure.root.message
    assert stage.fake.world.carried_by("red cup") is None


def test_there_may_be_no_room_any_more_where_something_was(stage):
    x, y, _ = stage.fake.world.object("red cup").world_T_object[:3, 3]
    stage.play(stage.pick())
    box = dataclasses.replace(BOX_BEFORE_IT, shape=Box((0.15, 0.15, 0.3)))
    stage.fake.world.put(dataclasses.replace(box, world_T_object=poses.translation(x, y, 1.05)))

    tree = run(stage, PlaceTask("put it back", RED_CUP, to=WHERE_IT_WAS))

    assert "there is no room where the red cup was" in tree.failure.root.message
    assert stage.fake.world.carried_by("red cup") == "right"


def test_an_early_touch_leads_to_another_spot(stage):
    stage.play(stage.pick())
    long_enough_to_feel_on_the_way(stage)
    stage.when("lower", lambda: stage.fake.pull_n.update(right=(0.0, 0.0, 60.0)), 3)
    stage.when("lift it again", stage.fake.pull_n.clear)

    tree = run(stage, PlaceTask("put it down", None, on="table"))

    assert "something is in the way of the red cup" in [failure.message for failure in stage.failed()]
    assert tree.status == "success"
    assert tree.attempts == 2


@pytest.mark.parametrize(
    "task",
    [PlaceTask("put it down", None, on="table"), PutInTask("put it in", None, ObjectDescription("bowl"))],
)
def test_what_is_lost_on_the_way_is_told_and_no_longer_believed_to_be_held(stage_with, chain, task):
    stage = stage_with(table(), cup(), bowl())
    stage.play(stage.pick())
    stage.when("transfer", lambda: stage.fake.world.remove("red cup"))

    tree = run(stage, task)

    assert tree.status == "failure"
    assert any("slipped out of the right hand" in link.message for link in chain(tree.failure))
    assert "no red cup" in tree.failure.message
    assert not stage.told.scene.attached


@pytest.mark.parametrize(
    "task",
    [
        PlaceTask("put it down", None, on="table"),
        PutInTask("put it in", RED_CUP, ObjectDescription("bowl")),
    ],
)
def test_what_slips_out_of_the_hand_on_the_way_is_picked_up_again(stage_with, task):
    stage = stage_with(table(), cup(), bowl())
    stage.play(stage.pick())
    stage.when("transfer", lambda: stage.fake.world.remove("red cup"))
    stage.when("still held", lambda: stage.fake.world.put(cup()))

    tree = run(stage, task)

    assert "slipped out of the right hand" in str([failure.message for failure in stage.failed()])
    assert tree.status == "success"
    assert tree.attempts == 2
    assert stage.fake.world.carried_by("red cup") is None


def test_a_bowl_behind_the_hand_is_seen_once_the_hand_is_drawn_in(stage_with):
    stage = stage_with(table(), cup(), bowl())
    stage.play(stage.pick())
    stage.fake.world.hidden.add("white bowl")
    stage.when("hand away", stage.fake.world.hidden.clear)

    tree = run(stage, PutInTask("put it in", None, ObjectDescription("bowl")))

    assert tree.status == "success"


def test_a_cup_that_rolls_away_is_not_claimed_as_placed(stage):
    stage.play(stage.pick())
    tree = build_tree(PlaceTask("put it down", None, on="table"), stage.toolbox)
    stage.when("clear the view", lambda: stage.fake.world.move("red cup", (0.0, 0.12, 0.0)))

    stage.play(tree)

    assert tree.status == "failure"
    assert tree.evidence == {}


def test_a_place_that_pushed_a_neighbour_is_not_claimed(stage_with):
    stage = stage_with(table(), cup(), cup("blue cup", "blue", (0.5, 0.1)))
    stage.play(stage.pick())
    stage.when("draw back", lambda: stage.fake.world.move("blue cup", (0.0, 0.02, 0.0)))

    tree = run(stage, PlaceTask("put it down", None, on="table"))

    assert tree.status == "failure"
    assert "the blue cup was moved" in tree.failure.message


def test_nothing_is_put_where_nobody_looked(stage, monkeypatch):
    stage.play(stage.pick())
    monkeypatch.setattr("trees.beliefs.sight.sight.in_view", lambda *_: False)

    tree = run(stage, PlaceTask("put it down", None, on="table"))

    assert tree.status == "failure"
    assert "free as far as was seen" in tree.failure.message
    assert stage.fake.world.carried_by("red cup") == "right"


@pytest.mark.requirement("M2", "L6")
@pytest.mark.parametrize("on", ["table", ObjectDescription("table")])
def test_the_table_may_be_another_one_than_the_side_table_that_it_stands_on(stage_with, on):
    top = table()
    side = TrueObject("side table/top", "furniture", "table", None, top.shape, top.world_T_object)
    stage = stage_with(side, cup())

    tree = run(stage, PlaceTask("put it on the table", RED_CUP, on=on))

    assert tree.failure.root.message == "which table? it stands on the side table already"
    assert tree.failure.choices == ("side table",)
    assert stage.fake.world.carried_by("red cup") is None
    named = PlaceTask("put it on the side table", RED_CUP, on="side table")
    assert run(stage, named).status == "success"


@pytest.mark.requirement("L5", "F1")
@pytest.mark.parametrize(
    ("look", "word"), [({"color": "red"}, "red"), ({"material": "wood"}, "made of wood")]
)
def test_what_is_not_seen_of_the_only_table_is_asked(stage_with, look, word):
    stage = stage_with(table(), cup())

    tree = run(stage, PlaceTask("put it there", RED_CUP, on=ObjectDescription("table", **look)))

    assert tree.failure.root.message.endswith(f" table? that it is {word} is not seen of furniture")
    assert tree.failure.choices == ("table",)
    assert stage.fake.world.carried_by("red cup") is None


def test_a_full_table_is_told(stage_with):
    red_at = (0.40, -0.20)
    places = [(0.36 + 0.12 * (i % 5), -0.52 + 0.12 * (i // 5)) for i in range(50)]
    others = [
        cup(f"blue cup {i}", "blue", place)
        for i, place in enumerate(places)
        if math.dist(place, red_at) > 0.1
    ]
    stage = stage_with(table(), cup(place_m=red_at), *others)
    stage.play(stage.pick())

    tree = run(stage, PlaceTask("put it down", None, on="table"))

    assert tree.status == "failure"


@pytest.mark.requirement("P3")
def test_a_hand_that_puts_something_down_remembers_how_high_it_has_felt_the_table(stage):
    stage.play(stage.pick())

    tree = run(stage, PlaceTask("put it down", None, on="table"))

    assert tree.status == "success"
    assert stage.toolbox.world.felt_tops["table"].source == "right hand"
