"""Picking something up while a hand is full, and placing what the hand that holds it cannot bring there."""

import pytest

from kinematics.requests.move import RetreatRequest
from kinematics.requests.place import PlaceRequest
from kinematics.requests.step import NoPlan, WhyNoPlan
from robots.fake.fake_world import cup, table
from trees.build import build_tree
from trees.failures import FailureKind
from trees.skills.looking import hand_ways
from trees.skills.pick.lift_wholly import LiftWholly
from trees.tasks import ObjectDescription, PickTask, PlaceTask, Relation
from trees.world_model import FormerPlace

RED_CUP, BLUE_CUP = ObjectDescription("cup", "red"), ObjectDescription("cup", "blue")
AT_ONCE_S = 0.3


@pytest.fixture
def stage(stage_with, monkeypatch):
    """Two cups, the red one in the right hand; no look leans: the fake arm takes a cup however it comes."""
    monkeypatch.setattr(hand_ways, "_LEANS_RAD", ())
    stage = stage_with(table(), cup(), cup("blue cup", "blue", (0.45, 0.2)))
    assert stage.play(stage.pick()).evidence["hand"] == "right"
    return stage


def run(stage, task):
    return stage.play(build_tree(task, stage.toolbox))


def carried_by(stage, name):
    return stage.fake.world.carried_by(name)


@pytest.mark.parametrize("hand", [None, "right"])
def test_what_was_asked_for_and_is_held_already_is_done_at_once(stage, hand):
    began_s, moved = stage.fake.clock.now_s(), len(stage.fake.motion.started)

    tree = run(stage, PickTask("pick up the red cup", RED_CUP, hand=hand))

    assert tree.status == "success"
    assert tree.evidence["already_held"]
    assert tree.acted_on == "red cup"
    assert stage.fake.clock.now_s() - began_s < AT_ONCE_S
    assert len(stage.fake.motion.started) == moved


def test_what_is_asked_for_where_it_was_taken_from_is_what_the_hand_holds(stage):
    tree = run(stage, PickTask("pick up the red cup on the table", RED_CUP, source="table"))

    assert tree.status == "success"
    assert tree.evidence["already_held"]


def test_what_is_asked_for_elsewhere_is_not_what_the_hand_holds(stage):
    tree = run(stage, PickTask("pick up the red cup on the shelf", RED_CUP, source="shelf"))

    assert tree.status == "failure"


def test_what_the_other_hand_holds_is_told_at_once_and_nothing_moves(stage):
    began_s, moved = stage.fake.clock.now_s(), len(stage.fake.motion.started)

    tree = run(stage, PickTask("pick it up with the left hand", RED_CUP, hand="left"))

    assert tree.status == "failure"
    assert tree.failure.kind is FailureKind.INFEASIBLE
    assert "the red cup is in the right hand already, not in the left" in tree.failure.message
    assert stage.fake.clock.now_s() - began_s < AT_ONCE_S
    assert len(stage.fake.motion.started) == moved


def test_a_full_hand_that_is_named_is_told_at_once(stage):
    tree = run(stage, PickTask("pick up the blue cup with the right hand", BLUE_CUP, hand="right"))

    assert tree.failure.kind is FailureKind.INFEASIBLE
    assert "no hand is free: the right hand holds the red cup" in tree.failure.message


def test_another_thing_is_taken_with_the_other_hand(stage):
    tree = run(stage, PickTask("pick up the blue cup", BLUE_CUP))

    assert tree.status == "success"
    assert (carried_by(stage, "red cup"), carried_by(stage, "blue cup")) == ("right", "left")


def test_with_both_hands_full_nothing_else_is_looked_for(stage):
    run(stage, PickTask("pick up the blue cup", BLUE_CUP))
    began_s = stage.fake.clock.now_s()

    tree = run(stage, PickTask("pick up a can", ObjectDescription("can")))

    assert tree.failure.kind is FailureKind.INFEASIBLE
    assert "no hand is free" in tree.failure.message
    assert stage.fake.clock.now_s() - began_s < AT_ONCE_S


@pytest.mark.parametrize("wanted", [ObjectDescription("cup"), ObjectDescription("cup", ordinal="other")])
def test_a_description_that_also_fits_another_thing_means_that(stage, wanted):
    tree = run(stage, PickTask("pick up the cup", wanted))

    assert tree.status == "success"
    assert carried_by(stage, "blue cup") == "left"


def test_what_a_hand_has_lost_in_between_is_picked_up_again(stage):
    stage.fake.world.remove("red cup")
    stage.fake.step()
    stage.fake.world.put(cup())

    tree = run(stage, PickTask("pick up the red cup", RED_CUP))

    assert tree.status == "success"
    assert "already_held" not in tree.evidence
    assert carried_by(stage, "red cup") == "right"


def test_something_else_is_put_down_with_the_free_hand(stage):
    tree = run(stage, PlaceTask("put the blue cup on the table", BLUE_CUP, on="table"))

    assert tree.status == "success"
    assert (carried_by(stage, "red cup"), carried_by(stage, "blue cup")) == ("right", None)


@pytest.fixture
def right_hand_fails(stage, monkeypatch):
    """The right hand reaches no spot beside anything; anywhere else it does."""
    answer = stage.fake.planning.answer

    def planned(request):
        if not isinstance(request, PlaceRequest):
            return answer(request)
        frame = request.scene.attached[request.held].frame
        left_part = request.spots[0].world_T_object[1, 3] > 0.0
        if frame == stage.toolbox.model.description.tcp_frames["right"] and left_part:
            return NoPlan(
                "no way", {"no inverse kinematics": 9}, {"spots": 9.0}, WhyNoPlan.NO_SPOT_IS_REACHED
            )
        return answer(request)

    monkeypatch.setattr(stage.fake.planning, "answer", planned)


BESIDE_BLUE = ObjectDescription(relation=Relation("left_of", BLUE_CUP))


def test_what_one_hand_cannot_bring_there_is_taken_by_the_other(stage, right_hand_fails):
    tree = run(stage, PlaceTask("put it left of the blue cup", RED_CUP, to=BESIDE_BLUE))

    assert tree.status == "success"
    assert tree.evidence["hand"] == "left"
    assert carried_by(stage, "red cup") is None
    assert stage.fake.world.object("red cup").world_T_object[1, 3] > 0.2


def test_the_hand_that_was_named_is_not_exchanged(stage, right_hand_fails):
    tree = run(stage, PlaceTask("put it there with the right hand", RED_CUP, to=BESIDE_BLUE, hand="right"))

    assert tree.status == "failure"
    assert "it has to be the right hand" in tree.failure.message
    assert carried_by(stage, "red cup") == "right"


def lifted_by(stage, rise_m, aside_m=0.0):
    """Let the red cup have stood so far below and beside where the hand has it now."""
    toolbox = stage.toolbox
    body = toolbox.world.scene.attached["red cup"]
    place = toolbox.model.frame_pose(stage.fake.sensing.state().q, body.frame) @ body.frame_T_object
    place[:3, 3] -= (aside_m, 0.0, rise_m)
    toolbox.world.taken_from = {"red cup": FormerPlace("table", place)}


@pytest.mark.requirement("S9", "F1")
def test_what_a_cancelled_pick_has_hardly_lifted_is_not_picked_up_before_it_is_lifted(stage):
    lifted_by(stage, 0.016)
    asked = len(stage.fake.planning.requests)

    tree = run(stage, PickTask("pick up the red cup", RED_CUP))

    (lift,) = [one for one in stage.fake.planning.requests[asked:] if isinstance(one, RetreatRequest)]
    assert lift.hand == "right"
    assert lift.world_offset_m == pytest.approx((0.0, 0.0, stage.toolbox.policy.lift_m - 0.016), abs=1e-6)
    assert [one.names for one in lift.concessions] == [("red cup", "table")]
    assert tree.status == "success"


def test_what_did_not_rise_is_not_claimed(stage, monkeypatch):
    lifted_by(stage, 0.016)
    monkeypatch.setattr(LiftWholly, "goal", lambda _leaf: None)

    tree = run(stage, PickTask("pick up the red cup", RED_CUP))

    assert tree.status == "failure"
    assert "has not risen enough" in tree.failure.message


@pytest.mark.parametrize(("rise_m", "aside_m"), [(0.13, 0.0), (0.016, 0.5)])
def test_what_was_lifted_or_carried_away_stays_where_it_is(stage, rise_m, aside_m):
    lifted_by(stage, rise_m, aside_m)
    moved = len(stage.fake.motion.started)

    assert run(stage, PickTask("pick up the red cup", RED_CUP)).status == "success"
    assert len(stage.fake.motion.started) == moved


def test_a_pick_that_was_verified_is_not_lifted_once_more(stage_with, monkeypatch):
    stage = stage_with(table(), cup())
    note_taken = stage.toolbox.world.note_taken

    def higher(name, origin):
        """It stood upright when it was first taken, and lay when it was taken again."""
        place = origin.odom_T_object.copy()
        place[2, 3] += 0.05
        note_taken(name, FormerPlace(origin.support, place))

    monkeypatch.setattr(stage.toolbox.world, "note_taken", higher)

    assert stage.play(stage.pick()).status == "success"
    assert not [one for one in stage.fake.planning.requests if isinstance(one, RetreatRequest)]
