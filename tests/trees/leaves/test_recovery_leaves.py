from dataclasses import replace

import numpy as np
import pytest
from py_trees.common import Status

from kinematics.requests.move import RetreatRequest
from trees.failures import Failure
from trees.leaves.exclude_grasp import ExcludeGrasp
from trees.leaves.go_home import GoHome
from trees.leaves.release import Release
from trees.skills.pick.attach import Attach
from trees.skills.pick.back_out import BackOut
from trees.skills.pick.put_back import PutBack
from trees.skills.pick.recover import ForgetTarget


def attach(stage, planned, target):
    planned.grip()
    leaf = Attach("attach", stage.toolbox)
    stage.run(leaf, grasp=planned.grasp, target=target, lift=planned.step("lift"))


def cup(stage):
    return stage.fake.world.object("red cup").world_T_object[:3, 3]


def test_release_opens_an_empty_hand(knowing, planned):
    knowing.fake.grippers["right"].empty = True
    planned.grip()

    assert knowing.run(Release("release", knowing.toolbox), grasp=planned.grasp) is Status.SUCCESS
    assert knowing.fake.grippers["right"].reading().opening_m > 0.09


@pytest.mark.parametrize("diameter_m", [0.0, 0.03])
def test_release_lets_go_of_a_bar_by_opening_a_little_more_than_the_fingers_are(knowing, planned, diameter_m):
    planned.grip()
    gripper = knowing.fake.grippers[planned.grasp.hand]
    about_m = gripper.reading().opening_m
    at_bar = replace(planned.grasp, opening_m=about_m - 0.01, diameter_m=diameter_m)

    status = knowing.run(Release("let go", knowing.toolbox, at_bar=True), grasp=at_bar)

    assert status is Status.SUCCESS
    assert gripper.reading().opening_m == pytest.approx(max(about_m, diameter_m) + 0.02, abs=0.004)


def test_release_opens_as_wide_as_a_grasp_says_before_it(knowing, planned):
    knowing.fake.grippers["right"].empty = True
    narrow = replace(planned.grasp, opening_m=0.05)
    planned.grip()

    assert knowing.run(Release("open gripper", knowing.toolbox), grasp=narrow) is Status.SUCCESS
    assert knowing.fake.grippers[narrow.hand].reading().opening_m == pytest.approx(0.05, abs=0.004)


def test_release_has_nothing_to_do_before_a_hand_was_used(stage):
    assert stage.run(Release("release", stage.toolbox)) is Status.SUCCESS
    assert stage.fake.motion.started == []


@pytest.mark.requirement("M4")
def test_release_keeps_what_would_fall(knowing, planned, target):
    attach(knowing, planned, target)
    planned.play("lift")
    leaf = Release("release", knowing.toolbox)

    assert knowing.run(leaf, grasp=planned.grasp) is Status.FAILURE
    assert leaf.failure.message == "the right hand still holds the red cup in the air; it is kept"
    assert knowing.fake.world.carried_by("red cup") == "right"
    assert "red cup" in knowing.told.scene.attached


def test_release_forgets_what_slipped_out_of_the_hand(knowing, planned, target):
    attach(knowing, planned, target)
    planned.play("lift")
    knowing.fake.world.drop("red cup")
    knowing.fake.step()

    assert knowing.run(Release("release", knowing.toolbox), grasp=planned.grasp) is Status.SUCCESS
    assert not knowing.told.scene.attached
    assert "red cup" not in knowing.told.scene.objects


@pytest.mark.requirement("M4")
def test_put_back_lowers_what_is_held_to_where_it_can_be_let_go(knowing, planned, target):
    attach(knowing, planned, target)
    planned.play("lift")

    assert knowing.run(PutBack("put back", knowing.toolbox), grasp=planned.grasp) is Status.SUCCESS
    assert cup(knowing)[2] == pytest.approx(0.955 + 0.004, abs=1e-3)
    assert knowing.run(Release("release", knowing.toolbox), grasp=planned.grasp) is Status.SUCCESS
    assert cup(knowing)[2] == pytest.approx(0.955, abs=1e-6)


def test_put_back_has_nothing_to_do_with_an_empty_hand(knowing, planned):
    assert knowing.run(PutBack("put back", knowing.toolbox), grasp=planned.grasp) is Status.SUCCESS
    assert knowing.fake.planning.requests == []


def test_back_out_returns_to_where_the_approach_began(knowing, planned, target):
    planned.play("reach")
    before = knowing.toolbox.model.frame_pose(knowing.fake.motion.reference(), "tcp_right")
    planned.play("approach")
    leaf = BackOut("back out", knowing.toolbox)

    status = knowing.run(leaf, grasp=planned.grasp, approach=planned.step("approach"), target=target)

    after = knowing.toolbox.model.frame_pose(knowing.fake.motion.reference(), "tcp_right")
    assert status is Status.SUCCESS
    np.testing.assert_allclose(after[:3, 3], before[:3, 3], atol=1e-3)


def test_back_out_does_not_take_the_target_for_an_obstacle(knowing, planned, target):
    planned.play("reach", "approach")
    leaf = BackOut("back out", knowing.toolbox)
    knowing.run(leaf, grasp=planned.grasp, approach=planned.step("approach"), target=target)

    (retreat,) = [r for r in knowing.fake.planning.requests if isinstance(r, RetreatRequest)]
    assert "red cup" not in retreat.scene.objects
    assert "red cup" in knowing.told.scene.objects


def test_back_out_has_nothing_to_do_before_the_approach(knowing, planned, target):
    planned.play("reach")
    leaf = BackOut("back out", knowing.toolbox)

    assert knowing.run(leaf, grasp=planned.grasp, approach=planned.step("approach"), target=target)
    assert knowing.fake.planning.requests == []


def test_go_home_ends_at_the_home_posture(knowing, planned):
    planned.play("reach")

    assert knowing.run(GoHome("go home", knowing.toolbox)) is Status.SUCCESS
    np.testing.assert_allclose(
        knowing.fake.sensing.state().q[7:], knowing.toolbox.model.q_home[7:], atol=1e-9
    )


def test_go_home_does_not_move_a_robot_that_is_there(stage):
    assert stage.run(GoHome("go home", stage.toolbox)) is Status.SUCCESS
    assert stage.fake.motion.started == []


@pytest.mark.parametrize(
    ("failure", "blamed"),
    [
        (Failure.postcondition("nothing between the fingers").at("pick/grasp/verify hold"), True),
        (Failure.unsafe("too close").at("pick/plan/check approach"), True),
        (Failure.postcondition("moved").at("pick/confirm/confirm target"), False),
        (Failure.execution("stale").at("pick/reach/stream reach"), False),
    ],
)
def test_a_grasp_is_excluded_only_when_it_is_to_blame(stage, right_grasp, failure, blamed):
    stage.run(ExcludeGrasp("exclude", stage.toolbox), failure=failure, grasp=right_grasp)

    assert (stage.output("tried_now") == {"right side"}) == blamed


def test_when_no_grasp_is_left_all_may_be_tried_again(stage, right_grasp):
    leaf = ExcludeGrasp("exclude", stage.toolbox)
    failure = Failure.infeasible("no way").at("pick/plan/plan pick")

    stage.run(leaf, failure=failure, grasp=right_grasp, tried=frozenset({"right side"}))

    assert stage.output("tried_now") == frozenset()


def test_a_forgotten_target_is_believed_no_longer(knowing, target):
    assert knowing.run(ForgetTarget("forget", knowing.toolbox), target=target) is Status.SUCCESS
    assert "red cup" not in knowing.told.scene.objects


def test_there_is_nothing_to_forget_before_a_target_was_seen(stage):
    assert stage.run(ForgetTarget("forget", stage.toolbox)) is Status.SUCCESS
