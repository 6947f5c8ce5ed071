import pytest
from py_trees.common import Status

from robots.perception.position_error import alike_in_all_directions
from trees.events import NotSo, Said
from trees.failures import Reason
from trees.skills.looking.look_at import LookAtTarget
from trees.skills.pick.attach import Attach
from trees.skills.pick.settings import PickSettings
from trees.skills.pick.verify_lift import VerifyLift


@pytest.fixture
def lifted(knowing, planned, target):
    """The stage with the cup lifted in the right hand, and the head turned to it."""
    planned.grip()
    inputs = {"grasp": planned.grasp, "target": target}
    knowing.run(Attach("attach", knowing.toolbox), lift=planned.step("lift"), **inputs)
    planned.play("lift")
    knowing.run(LookAtTarget("look", knowing.toolbox), **inputs)
    knowing.leaf = knowing.ready(VerifyLift("verify lift", knowing.toolbox), **inputs)
    return knowing


def verify(stage, after_ticks=0, act=lambda: None):
    """Tick to the end; do something after some ticks."""
    for number in range(1000):
        if number == after_ticks:
            act()
        if stage.tick(stage.leaf) is not Status.RUNNING:
            return stage.leaf.status
    raise AssertionError("it never ended")


@pytest.mark.requirement("M2")
def test_a_lifted_cup_that_stays_in_the_hand_counts_with_its_evidence(lifted):
    assert verify(lifted) is Status.SUCCESS

    evidence = lifted.output("evidence")
    assert evidence["gripper_opening_m"] == pytest.approx(0.06)
    assert evidence["effort_nm"] > 0.5
    assert evidence["lift_m"] == pytest.approx(0.13, abs=1e-3)
    assert evidence["seen"] is True
    assert evidence["held_s"] >= 0.2


@pytest.mark.requirement("M2")
@pytest.mark.parametrize("after_ticks", range(0, 8, 2))
def test_a_cup_that_is_taken_away_at_any_moment_is_noticed(lifted, after_ticks):
    assert verify(lifted, after_ticks, lambda: lifted.fake.world.remove("red cup")) is Status.FAILURE
    assert lifted.leaf.failure.message == "the red cup was lost after the lift"
    assert lifted.leaf.failure.cause.message == "nothing between the fingers"


@pytest.mark.requirement("M2")
def test_a_cup_that_slips_slowly_is_noticed_while_the_gripper_still_feels_it(lifted):
    world = lifted.fake.world
    assert verify(lifted, 5, lambda: world.shift_in_hand("red cup", 0.012)) is Status.FAILURE
    assert lifted.leaf.failure.message == "the red cup is slipping"
    assert lifted.leaf.failure.numbers["slip_m"] == pytest.approx(0.012, abs=1e-3)


@pytest.mark.requirement("M2")
def test_a_cup_that_is_seen_to_stay_on_the_table_is_not_lifted_whatever_the_gripper_says(lifted):
    world = lifted.fake.world
    hand = lifted.fake.grippers["right"]
    world.drop("red cup")
    hand._lost = lambda name: False

    assert verify(lifted) is Status.FAILURE
    assert lifted.leaf.failure.message == "the red cup is seen outside the hand"


@pytest.mark.requirement("M2")
def test_a_cup_that_cannot_be_seen_must_be_held_for_longer(lifted):
    lifted.fake.world.hidden.add("red cup")

    assert verify(lifted) is Status.SUCCESS
    evidence = lifted.output("evidence")
    assert evidence["held_s"] >= 0.4
    assert evidence["seen"] is False
    assert "lift_m" not in evidence


@pytest.mark.requirement("M2")
def test_an_unseen_cup_that_is_lost_late_is_still_noticed(lifted):
    lifted.fake.world.hidden.add("red cup")

    assert verify(lifted, 15, lambda: lifted.fake.world.remove("red cup")) is Status.FAILURE


@pytest.mark.requirement("M2")
def test_a_lift_that_is_too_low_does_not_count(knowing, planned, target):
    planned.grip()
    inputs = {"grasp": planned.grasp, "target": target}
    knowing.run(Attach("attach", knowing.toolbox), lift=planned.step("lift"), **inputs)
    knowing.run(LookAtTarget("look", knowing.toolbox), **inputs)
    leaf = VerifyLift("verify lift", knowing.toolbox)

    assert knowing.run(leaf, **inputs) is Status.FAILURE
    assert leaf.failure.message == "the red cup has not risen enough"


def test_one_doubtful_reading_does_not_count(lifted):
    hand = lifted.fake.grippers["right"]
    hand._lost = lambda name: False
    hand.effort_nm = -0.1
    lifted.tick(lifted.leaf)
    hand.effort_nm = -3.5

    assert verify(lifted) is Status.SUCCESS


@pytest.mark.requirement("M2")
def test_a_doubtful_reading_at_the_end_of_the_hold_is_waited_out(lifted):
    hand = lifted.fake.grippers["right"]
    hand._lost = lambda name: False
    ticks_of_the_hold = round(lifted.toolbox.policy.of(PickSettings).hold_s / 0.02)

    def lose_effort():
        hand.effort_nm = -0.1

    assert verify(lifted, ticks_of_the_hold, lose_effort) is Status.FAILURE
    assert lifted.leaf.failure.message == "the red cup was lost after the lift"


@pytest.mark.requirement("P3")
@pytest.mark.parametrize(("aside_m", "told"), [(0.0, []), (0.03, [Reason.FELT_ELSEWHERE])])
def test_a_cup_that_is_felt_elsewhere_than_it_is_seen_is_told_and_counts_as_held(lifted, aside_m, told):
    detector = lifted.fake.detector
    detector.error = alike_in_all_directions(0.003, 0.0, 0.01)
    across = lifted.toolbox.model.frame_pose(lifted.toolbox.sensing.state().q, "tcp_right")[:3, 1]
    detector.offset_m["red cup"] = tuple((aside_m * across).tolist())
    lifted.fake.step()

    assert verify(lifted) is Status.SUCCESS
    noticed = [event.failure.reason for event in lifted.events if isinstance(event, NotSo)]
    assert noticed == told
    assert len([event for event in lifted.events if isinstance(event, Said)]) == len(told)
    assert ("felt_apart_m" in lifted.output("evidence")) is bool(told)


@pytest.mark.requirement("P3")
def test_what_is_felt_elsewhere_in_one_look_alone_is_no_disagreement(lifted):
    """It is looked at again, and then the camera shows it where the hand feels it."""
    detector = lifted.fake.detector
    detector.error = alike_in_all_directions(0.003, 0.0, 0.01)
    across = lifted.toolbox.model.frame_pose(lifted.toolbox.sensing.state().q, "tcp_right")[:3, 1]
    detector.offset_m["red cup"] = tuple((0.03 * across).tolist())
    lifted.fake.step()
    while "looking again" not in lifted.leaf.feedback_message:
        lifted.tick(lifted.leaf)

    assert verify(lifted, act=detector.offset_m.clear) is Status.SUCCESS
    assert [event for event in lifted.events if isinstance(event, NotSo)] == []
    assert "felt_apart_m" not in lifted.output("evidence")


@pytest.mark.requirement("P3")
def test_what_is_felt_elsewhere_twice_is_taken_to_be_where_the_hand_feels_it(lifted):
    detector, world = lifted.fake.detector, lifted.toolbox.world
    detector.error = alike_in_all_directions(0.003, 0.0, 0.01)
    across = lifted.toolbox.model.frame_pose(lifted.toolbox.sensing.state().q, "tcp_right")[:3, 1]
    detector.offset_m["red cup"] = tuple((0.03 * across).tolist())
    body = world.scene.attached["red cup"]
    aside = body.frame_T_object.copy()
    aside[1, 3] += 0.02
    freed = world.scene.with_detached("red cup", aside)
    world.update(freed.with_attached("red cup", body.frame, aside, body.touch_links, body.mass_kg))
    lifted.fake.step()

    assert verify(lifted) is Status.SUCCESS
    assert lifted.output("evidence")["held_s"] >= 2.0 * lifted.toolbox.policy.of(PickSettings).hold_s
    assert world.scene.attached["red cup"].frame_T_object[1, 3] == pytest.approx(0.0, abs=0.002)
