"""The household skills on the fake robot: what is done, what is said, and what is never claimed."""

import dataclasses
import math

import numpy as np
import pytest

from kinematics import poses
from kinematics.gesture_requests import OfferRequest, PointRequest, RaiseHandRequest
from kinematics.place_requests import PlaceRequest
from kinematics.requests import NoPlan, PickRequest, RetreatRequest
from kinematics.shapes import Box
from kinematics.support import top_m
from kinematics.view_request import ViewRequest
from robots.articulated import furniture_T_part, moving_solids, opened
from robots.fake.fake_world import bowl, cup, person, table
from robots.furniture import floor_pose, solids
from robots.perception.truth_view import TrueObject
from robots.scene_description import Region
from robots.scene_file import load_scene
from trees.build import build_tree
from trees.events import LeafFailed, NotSo, Said
from trees.failures import FailureKind
from trees.tasks import (
    WHERE_IT_WAS,
    DescribeTask,
    FindTask,
    HandOverTask,
    LookAtTask,
    ObjectDescription,
    PickTask,
    PlaceTask,
    PointAtTask,
    PutInTask,
    Relation,
    SayTask,
    WaitTask,
    WaveTask,
)

RED_CUP = ObjectDescription("cup", "red")
BLUE_CUP = ObjectDescription("cup", "blue")
ANA = person()
BOX_BEFORE_IT = TrueObject(
    "brown box",
    "object",
    "box",
    "brown",
    Box((0.06, 0.24, 0.30)),
    poses.translation(0.42, -0.2, 1.05),
)


def run(stage, task):
    return stage.play(build_tree(task, stage.toolbox))


def long_enough_to_feel_on_the_way(stage):
    """Make motions so long that a touch is felt twice before the end."""
    stage.fake.planning.motion_s = 0.08


def said(stage):
    return [event.text for event in stage.events if isinstance(event, Said)]


def asked(stage, kind):
    return [request for request in stage.fake.planning.requests if isinstance(request, kind)]


def test_words_are_given_out(stage):
    tree = run(stage, SayTask("say hello", "hello", "Ana"))

    assert tree.status == "success"
    assert said(stage) == ["hello"]


def test_waiting_takes_its_time_and_moves_nothing(stage):
    began_s = stage.fake.clock.now_s()

    tree = run(stage, WaitTask("wait", 0.5))

    assert tree.status == "success"
    assert stage.fake.clock.now_s() - began_s == pytest.approx(0.5, abs=0.05)
    assert not stage.fake.motion.started


def test_a_wave_is_for_the_person_who_is_named(stage_with):
    stage = stage_with(person("Ben", (1.4, -0.6)), person("Ana", (1.3, 0.6)))

    tree = run(stage, WaveTask("wave at Ana", "Ana"))

    assert tree.status == "success"
    assert tree.evidence["swings"] >= 3
    assert asked(stage, RaiseHandRequest)[0].towards_m[1] > 0.5


def test_a_wave_at_nobody_fails_and_says_so(stage):
    tree = run(stage, WaveTask("wave at Ana", "Ana"))

    assert tree.status == "failure"
    assert "no Ana seen" in tree.failure.message
    assert not asked(stage, RaiseHandRequest)


def test_a_hand_that_hardly_swings_is_no_wave(stage_with):
    stage = stage_with(ANA)
    stage.when("swing hand", lambda: setattr(stage.fake.robot, "stuck", set(stage.toolbox.model.joints)))

    tree = run(stage, WaveTask("wave"))

    assert tree.status == "failure"
    assert tree.failure.kind in (FailureKind.POSTCONDITION, FailureKind.EXECUTION)


def test_pointing_is_measured_against_the_thing(stage):
    tree = run(stage, PointAtTask("point at the red cup", RED_CUP))

    assert tree.status == "success"
    assert tree.evidence["off_m"] <= 0.10
    assert asked(stage, PointRequest)


def test_an_arm_is_not_stretched_over_a_table_that_was_not_looked_at(stage_with):
    stage = stage_with(table(), cup(), cup("blue cup", "blue", (0.45, -0.45)))
    stage.fake.world.hidden.add("blue cup")
    stage.when("look below the way", stage.fake.world.hidden.clear)
    started = []
    stage.when("stretch arm", lambda: started.append(asked(stage, PointRequest)[-1].scene))

    tree = run(stage, PointAtTask("point at the red cup", RED_CUP))

    assert tree.status == "success"
    assert "blue cup" not in asked(stage, PointRequest)[0].scene.objects
    assert ["blue cup" in scene.objects for scene in started] == [True]


def test_an_arm_that_passes_over_nothing_is_stretched_at_once(stage_with):
    stage = stage_with(ANA)

    tree = run(stage, PointAtTask("point at Ana", person="Ana"))

    assert tree.status == "success"
    assert len(asked(stage, PointRequest)) == 1


def test_what_is_looked_at_is_in_the_middle_of_the_picture(stage):
    tree = run(stage, LookAtTask("look at the red cup", RED_CUP))

    assert tree.status == "success"
    assert tree.evidence["off_centre"] <= 0.10


def test_a_look_that_is_barred_by_what_the_hand_holds_is_taken_from_home(stage_with):
    stage = stage_with(table(), cup(), cup("blue cup", "blue", (0.5, 0.1)))
    stage.play(stage.pick())
    planning = stage.fake.planning
    stage.when("turn to it", lambda: setattr(planning, "no_plan", NoPlan("no way", {"no path": 1})))
    stage.when("draw the hands in", lambda: setattr(planning, "no_plan", None))

    tree = run(stage, LookAtTask("look at the blue cup", BLUE_CUP))

    assert "no way" in [failure.message for failure in stage.failed()]
    assert tree.status == "success"
    assert tree.evidence["off_centre"] <= 0.10


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
    monkeypatch.setattr("trees.sight.in_view", lambda *_: False)

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


def test_a_cup_is_put_into_a_bowl(stage_with):
    stage = stage_with(table(), cup(), bowl())

    tree = run(stage, PutInTask("put it in", RED_CUP, ObjectDescription("bowl")))

    off = stage.fake.world.object("red cup").world_T_object[:2, 3] - (0.45, 0.2)
    assert tree.status == "success"
    assert float(np.linalg.norm(off)) <= 0.10


def test_a_neighbour_that_was_pushed_while_putting_in_is_told(stage_with):
    stage = stage_with(table(), cup(), bowl(), cup("blue cup", "blue", (0.5, -0.4)))
    stage.when("clear the view", lambda: stage.fake.world.move("blue cup", (0.0, -0.03, 0.0)))

    tree = run(stage, PutInTask("put it in", RED_CUP, ObjectDescription("bowl")))

    assert tree.status == "failure"
    assert "the blue cup was moved" in tree.failure.message


def test_a_cup_that_is_nowhere_to_be_seen_is_not_claimed_to_be_in_the_bowl(stage_with):
    stage = stage_with(table(), cup(), bowl())
    stage.when("clear the view", lambda: stage.fake.world.hidden.add("red cup"))

    tree = run(stage, PutInTask("put it in", RED_CUP, ObjectDescription("bowl")))

    assert tree.status == "failure"
    assert "is not seen in the white bowl" in tree.failure.message


def test_what_a_wall_hides_is_seen_from_above(stage_with):
    stage = stage_with(table(), cup(), bowl())
    stage.when("clear the view", lambda: stage.fake.world.hidden.add("red cup"))
    stage.when("lean over it", stage.fake.world.hidden.clear)

    tree = run(stage, PutInTask("put it in", RED_CUP, ObjectDescription("bowl")))

    assert tree.status == "success"


def test_a_cup_that_falls_beside_the_bowl_is_not_claimed(stage_with):
    stage = stage_with(table(), cup(), bowl())
    stage.when("clear the view", lambda: stage.fake.world.move("red cup", (0.0, -0.25, 0.0)))

    tree = run(stage, PutInTask("put it in", RED_CUP, ObjectDescription("bowl")))

    assert tree.status == "failure"
    assert "beside" in tree.failure.message


def chest(opening_m):
    """A chest of drawers ahead, its drawer out so far, as the truth has it."""
    (piece,) = load_scene("drawers").furniture
    fixed = [
        TrueObject(solid.name, "furniture", piece.kind, None, solid.shape, solid.world_T_solid)
        for solid in solids(piece)
    ]
    part = floor_pose(piece) @ furniture_T_part(piece) @ opened(piece, opening_m)
    moving = [
        TrueObject(solid.name, "furniture", solid.kind, None, solid.shape, part @ solid.part_T_solid)
        for solid in moving_solids(piece)
        if solid.kind
    ]
    return *fixed, *moving


ON_THE_CHEST = cup(place_m=(0.85, 0.33), table_height_m=1.05)


def test_a_cup_is_put_into_an_open_drawer(stage_with):
    stage = stage_with(*chest(0.3), ON_THE_CHEST)

    tree = run(stage, PutInTask("put the red cup in the drawer", RED_CUP, "drawer"))

    place = stage.fake.world.object("red cup").world_T_object[:3, 3]
    assert tree.status == "success"
    assert tree.evidence["in"] == "drawer"
    assert 0.45 < place[0] < 0.72
    assert 0.2 < place[1] < 0.56


@pytest.mark.requirement("F1")
def test_a_shut_drawer_is_told_before_anything_is_picked_up(stage_with):
    stage = stage_with(*chest(0.0), ON_THE_CHEST)

    tree = run(stage, PutInTask("put the red cup in the drawer", RED_CUP, "drawer"))

    assert tree.status == "failure"
    assert tree.failure.kind is FailureKind.INFEASIBLE
    assert "the drawer is shut: open it first" in tree.failure.message
    assert not asked(stage, PickRequest)


def fridge(opening_rad):
    """A fridge ahead to the left, its door so far open, as the truth has it; and a table to the right."""
    (piece,) = load_scene("fridge").furniture
    fixed = [
        TrueObject(solid.name, "furniture", piece.kind, None, solid.shape, solid.world_T_solid)
        for solid in solids(piece)
    ]
    part = floor_pose(piece) @ furniture_T_part(piece) @ opened(piece, opening_rad)
    moving = [
        TrueObject(solid.name, "furniture", solid.kind, None, solid.shape, part @ solid.part_T_solid)
        for solid in moving_solids(piece)
        if solid.kind
    ]
    return *fixed, *moving


@pytest.mark.requirement("M3")
def test_a_cup_is_put_on_a_board_of_an_open_fridge(stage_with):
    stage = stage_with(*fridge(1.25), table(), cup())

    tree = run(stage, PutInTask("put the red cup in the fridge", RED_CUP, "fridge"))

    place = stage.fake.world.object("red cup").world_T_object[:3, 3]
    assert tree.status == "success"
    assert tree.evidence["on"].startswith("fridge")
    assert place[2] == pytest.approx(0.65 * 1.70 + 0.01 + 0.055, abs=0.02)


@pytest.mark.parametrize(("opening_rad", "status"), [(0.0, "failure"), (1.25, "success")])
def test_what_is_in_a_shut_fridge_is_not_told(stage_with, opening_rad, status):
    stage = stage_with(*fridge(opening_rad), table(), cup())

    tree = run(stage, DescribeTask("what is in the fridge?", source="fridge"))

    assert tree.status == status
    told = tree.evidence["said"] if status == "success" else tree.failure.message
    assert ("in the fridge I see" if status == "success" else "the fridge is shut: open it first") in told


@pytest.mark.requirement("F1")
def test_a_shut_fridge_is_told_before_anything_is_picked_up(stage_with):
    stage = stage_with(*fridge(0.0), table(), cup())

    tree = run(stage, PutInTask("put the red cup in the fridge", RED_CUP, "fridge"))

    assert tree.failure.kind is FailureKind.INFEASIBLE
    assert "the fridge is shut: open it first" in tree.failure.message
    assert not asked(stage, PickRequest)


def test_a_cup_that_falls_off_its_board_is_not_claimed_to_be_in_the_fridge(stage_with):
    stage = stage_with(*fridge(1.25), table(), cup())
    stage.when("clear the view", lambda: stage.fake.world.move("red cup", (-0.2, 0.0, -0.4)))

    tree = run(stage, PutInTask("put the red cup in the fridge", RED_CUP, "fridge"))

    assert tree.status == "failure"


def test_a_cup_that_lies_on_the_chest_afterwards_is_not_claimed_to_be_in_the_drawer(stage_with):
    stage = stage_with(*chest(0.3), ON_THE_CHEST)
    stage.when("clear the view", lambda: stage.fake.world.move("red cup", (0.3, 0.0, 0.2)))

    tree = run(stage, PutInTask("put the red cup in the drawer", RED_CUP, "drawer"))

    assert tree.status == "failure"
    assert "red cup" in tree.failure.message


def test_an_object_is_given_to_whom_pulls(stage_with):
    stage = stage_with(table(), cup(), ANA)
    stage.when("wait for the pull", lambda: stage.fake.pull_n.update(right=(5.0, 0.0, 0.0)), 10)
    stage.when("let it go", lambda: stage.fake.world.move("red cup", (0.3, 0.0, 0.25)))

    tree = run(stage, HandOverTask("give it to Ana", RED_CUP, "Ana"))

    assert tree.status == "success"
    assert tree.evidence["pull_n"] >= 3.0
    assert len(asked(stage, OfferRequest)) == 1
    assert not stage.told.scene.attached


@pytest.mark.parametrize("force", [(2.0, 0.0, 0.0), (0.0, 0.0, 0.0)])
def test_what_nobody_takes_is_taken_back(stage_with, force):
    stage = stage_with(table(), cup(), ANA)
    stage.when("wait for the pull", lambda: stage.fake.pull_n.update(right=force), 10)

    tree = run(stage, HandOverTask("give it to Ana", RED_CUP, "Ana"))

    assert tree.status == "failure"
    assert "nobody took the red cup" in tree.failure.message
    assert stage.fake.world.carried_by("red cup") == "right"


def test_what_slips_out_of_an_offering_hand_was_not_taken(stage_with):
    stage = stage_with(table(), cup(), ANA)
    stage.when("wait for the pull", lambda: stage.fake.world.remove("red cup"), 10)

    tree = run(stage, HandOverTask("give it to Ana", RED_CUP, "Ana"))

    assert tree.status == "failure"
    assert "the red cup slipped out of the right hand" in tree.failure.message
    assert not stage.told.scene.attached


def test_a_dropped_gift_is_not_claimed(stage_with):
    stage = stage_with(table(), cup(), ANA)
    stage.when("wait for the pull", lambda: stage.fake.pull_n.update(right=(5.0, 0.0, 0.0)), 10)
    stage.when("let it go", lambda: stage.fake.world.drop("red cup"))

    tree = run(stage, HandOverTask("give it to Ana", RED_CUP, "Ana"))

    assert tree.status == "failure"
    assert "the red cup was dropped onto the table" in tree.failure.message


@pytest.mark.parametrize(("far_m", "status"), [(0.35, "success"), (0.12, "failure")])
def test_what_was_carried_away_and_stands_there_was_taken(stage_with, far_m, status):
    def put_aside():
        stage.fake.world.drop("red cup")
        stage.fake.world.move("red cup", (far_m, 0.0, 0.0))

    stage = stage_with(table(), cup(), ANA)
    stage.when("wait for the pull", lambda: stage.fake.pull_n.update(right=(5.0, 0.0, 0.0)), 10)
    stage.when("let it go", put_aside)

    tree = run(stage, HandOverTask("give it to Ana", RED_CUP, "Ana"))

    assert tree.status == status


def test_a_gift_that_is_nowhere_to_be_seen_is_not_claimed(stage_with):
    stage = stage_with(table(), cup(), ANA)
    stage.when("wait for the pull", lambda: stage.fake.pull_n.update(right=(5.0, 0.0, 0.0)), 10)
    stage.when("let it go", lambda: stage.fake.world.remove("red cup"))

    tree = run(stage, HandOverTask("give it to Ana", RED_CUP, "Ana"))

    assert tree.status == "failure"
    assert "was let go, and is not seen with Ana" in tree.failure.message


@pytest.mark.requirement("M2", "M3")
def test_what_somebody_else_took_is_not_claimed(stage_with):
    stage = stage_with(table(), cup(), ANA, person("Ben", (1.25, -0.7)))
    stage.when("wait for the pull", lambda: stage.fake.pull_n.update(right=(5.0, 0.0, 0.0)), 10)
    stage.when("let it go", lambda: stage.fake.world.move("red cup", (0.45, -0.35, 0.25)))

    tree = run(stage, HandOverTask("give it to Ana", RED_CUP, "Ana"))

    assert tree.status == "failure"
    assert "the red cup was taken by Ben, not by Ana" in tree.failure.message


@pytest.mark.requirement("M3")
def test_nothing_is_held_out_to_who_does_not_come_for_it(stage_with):
    stage = stage_with(table(), cup(), person("Ana", (2.8, 0.1)))

    tree = run(stage, HandOverTask("give it to Ana", RED_CUP, "Ana"))

    assert tree.failure.root.message == "Ana stands 2.8 m away"
    assert tree.failure.wants_nearer
    assert stage.fake.world.carried_by("red cup") == "right"


def test_another_cup_like_the_gift_is_not_taken_for_a_dropped_one(stage_with):
    stage = stage_with(table(), cup(), cup("red cup 2", "red", (0.45, -0.45)), ANA)
    stage.play(stage.pick(PickTask("pick it up", ObjectDescription("cup", "red", ordinal="leftmost"))))
    stage.when("wait for the pull", lambda: stage.fake.pull_n.update(right=(5.0, 0.0, 0.0)), 10)
    stage.when("let it go", lambda: stage.fake.world.move("red cup", (0.3, 0.0, 0.25)))

    tree = run(stage, HandOverTask("give it to Ana", RED_CUP, "Ana"))

    assert tree.status == "success"


def test_something_hidden_from_here_is_looked_for_from_elsewhere(stage_with):
    stage = stage_with(table(), cup(place_m=(0.52, -0.2)), BOX_BEFORE_IT)
    stage.fake.world.hidden.add("red cup")
    stage.when("peer", stage.fake.world.hidden.clear)

    tree = run(stage, FindTask("find the red cup", RED_CUP))

    assert tree.status == "success"
    assert tree.evidence["found"] == "red cup"
    assert len(asked(stage, ViewRequest)) == 1


def test_a_search_that_finds_it_at_last_tells_of_no_failures(stage_with):
    stage = stage_with(table(), cup(place_m=(0.52, -0.2)), BOX_BEFORE_IT)
    stage.fake.world.hidden.add("red cup")
    stage.when("peer", stage.fake.world.hidden.clear)

    run(stage, FindTask("find the red cup", RED_CUP))

    assert [event for event in stage.events if isinstance(event, LeafFailed)] == []
    assert any(isinstance(event, NotSo) for event in stage.events)


def test_what_is_hidden_from_everywhere_is_not_found(stage_with):
    stage = stage_with(table(), cup(place_m=(0.52, -0.2)), BOX_BEFORE_IT)
    stage.fake.world.hidden.add("red cup")

    tree = run(stage, FindTask("find the red cup", RED_CUP))

    assert tree.status == "failure"
    assert said(stage) == []
    assert 1 <= len(asked(stage, ViewRequest)) <= stage.toolbox.policy.looks_past


def test_something_that_is_nowhere_is_not_found(stage):
    stage.fake.world.remove("red cup")

    tree = run(stage, FindTask("find the red cup", RED_CUP))

    assert (
        tree.failure.message == "could not find the red cup: no red cup seen, and every place was looked at"
    )
    assert said(stage) == []


def test_a_person_who_is_nowhere_is_not_found(stage):
    tree = run(stage, FindTask("find Ana", person="Ana"))

    assert tree.failure.message == "could not find Ana: no Ana seen"


def test_no_plan_for_a_gesture_is_told(stage_with):
    stage = stage_with(ANA)
    stage.when("raise hand", lambda: None)
    stage.fake.planning.no_plan = NoPlan(
        "no posture of the left arm for that was found", {"out of reach": 14}
    )

    tree = run(stage, WaveTask("wave at Ana", "Ana"))

    assert tree.status == "failure"
    assert tree.failure.kind is FailureKind.INFEASIBLE


def test_a_hand_that_holds_something_does_not_wave(stage_with):
    stage = stage_with(table(), cup(), ANA)
    stage.play(stage.pick(PickTask("pick up the red cup", RED_CUP)))

    tree = run(stage, WaveTask("wave with the right hand", "Ana", "right"))

    assert tree.status == "failure"
    assert "no hand is free" in tree.failure.message


@pytest.mark.requirement("L1", "M3")
@pytest.mark.parametrize(
    "task",
    [
        PlaceTask("put the cup from the shelf on the table", RED_CUP, on="table", source="shelf"),
        PutInTask(
            "put the cup from the shelf in the bowl", RED_CUP, ObjectDescription("bowl"), source="shelf"
        ),
        HandOverTask("give Ana the cup from the shelf", RED_CUP, "Ana", source="shelf"),
    ],
    ids=lambda task: task.action,
)
def test_a_thing_that_is_said_to_be_elsewhere_is_left_where_it_stands(stage_with, task):
    stage = stage_with(table(), cup(), bowl(), ANA)

    tree = run(stage, task)

    assert tree.status == "failure"
    assert "on the shelf" in str(tree.failure)
    assert not stage.toolbox.world.scene.attached
