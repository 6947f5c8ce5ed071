import numpy as np
import pytest

from kinematics.requests.check import CheckRequest
from kinematics.requests.pick import PickRequest
from kinematics.scene.planning_scene import PlanningScene, SceneObject


@pytest.fixture
def at_the_cup(fake, play):
    """The fake robot with its right hand around the cup."""
    item = fake.world.object("red cup")
    scene = PlanningScene().with_object(SceneObject("red cup", item.shape, item.world_T_object))
    plan = fake.planning.answer(PickRequest(fake.motion.reference(), fake.motion.stance(), scene, "red cup"))
    for step in (plan.reach, plan.approach):
        play(fake.motion.start(fake.planning.verdict(step.question)))
    fake.lift = fake.planning.verdict(CheckRequest(plan.lift.trajectory, plan.lift.scene))
    return fake


def test_a_hand_that_closes_on_nothing_reads_empty(fake, play):
    hand = fake.grippers["right"]

    play(hand.close())

    assert hand.position_rad == fake.model.description.grippers["right"].closed_rad
    assert not hand.reading().holding


def test_a_hand_that_closes_on_the_cup_holds_it_at_its_diameter(at_the_cup, play):
    hand = at_the_cup.grippers["right"]

    play(hand.close())

    assert hand.reading().holding
    assert hand.reading().opening_m == pytest.approx(0.06)
    assert at_the_cup.world.carried_by("red cup") == "right"


def test_a_held_cup_moves_with_the_hand(at_the_cup, play):
    play(at_the_cup.grippers["right"].close())
    before = at_the_cup.world.object("red cup").world_T_object[2, 3]

    play(at_the_cup.motion.start(at_the_cup.lift))

    assert at_the_cup.world.object("red cup").world_T_object[2, 3] - before == pytest.approx(0.13, abs=1e-3)


def test_an_opened_hand_lets_the_cup_fall_to_the_table(at_the_cup, play):
    play(at_the_cup.grippers["right"].close())
    play(at_the_cup.motion.start(at_the_cup.lift))

    play(at_the_cup.grippers["right"].open())

    assert at_the_cup.world.carried_by("red cup") is None
    assert at_the_cup.world.object("red cup").world_T_object[2, 3] == pytest.approx(0.955, abs=1e-3)


def test_a_hand_whose_cup_is_taken_closes_and_reads_empty(at_the_cup, play):
    hand = at_the_cup.grippers["right"]
    play(hand.close())
    at_the_cup.world.remove("red cup")

    for _ in range(40):
        at_the_cup.step()

    assert not hand.reading().holding
    assert hand.reading().opening_m == 0.0


def test_a_hand_can_be_made_to_miss(at_the_cup, play):
    at_the_cup.grippers["right"].empty = True

    play(at_the_cup.grippers["right"].close())

    assert not at_the_cup.grippers["right"].reading().holding


def test_a_cancelled_closing_stays_where_it_is(fake):
    hand = fake.grippers["left"]
    handle = hand.close()
    fake.step()
    fake.motion.cancel(handle, "enough")
    fake.step()
    held = hand.position_rad
    fake.step()

    assert hand.position_rad == held
    np.testing.assert_array_equal(fake.robot.read().q[-2:], [held, 0.0])
