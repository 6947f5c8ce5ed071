import numpy as np
import pytest
from py_trees.common import Status

from trees.failures import FailureKind
from trees.skills.pick.close_gripper import CloseGripper
from trees.skills.pick.open_gripper import OpenGripper
from trees.skills.pick.verify_hold import VerifyHold


def test_open_gripper_opens_the_hand_of_the_grasp(stage, right_grasp):
    stage.fake.grippers["right"].position_rad = -0.5

    assert stage.run(OpenGripper("open", stage.toolbox), grasp=right_grasp) is Status.SUCCESS
    assert stage.fake.grippers["right"].reading().opening_m > 0.09
    assert stage.fake.motion.started == ["open right gripper"]


def test_open_gripper_does_not_drop_what_is_held(knowing, right_grasp):
    knowing.told.update(knowing.told.scene.with_attached("red cup", "tcp_right", np.eye(4), []))
    leaf = OpenGripper("open", knowing.toolbox)

    assert knowing.run(leaf, grasp=right_grasp) is Status.FAILURE
    assert leaf.failure.message == "the right hand still holds the red cup"
    assert knowing.fake.motion.started == []


def test_a_gripper_that_does_not_get_open_runs_out_of_time(stage, right_grasp, monkeypatch):
    stage.fake.grippers["right"].position_rad = -0.5
    monkeypatch.setattr(stage.fake.grippers["right"], "advance", lambda period_s: None)
    leaf = OpenGripper("open", stage.toolbox)

    assert stage.run(leaf, grasp=right_grasp) is Status.FAILURE
    assert leaf.failure.kind is FailureKind.TIMEOUT


def test_close_gripper_ends_on_the_object(knowing, planned):
    planned.play("reach", "approach")

    assert knowing.run(CloseGripper("close", knowing.toolbox), grasp=planned.grasp) is Status.SUCCESS
    assert knowing.fake.grippers["right"].reading().opening_m == pytest.approx(0.06)


def test_close_gripper_passes_a_refusal_on(stage, right_grasp):
    stage.fake.motion.refuse = "the emergency stop is engaged"
    leaf = CloseGripper("close", stage.toolbox)

    assert stage.run(leaf, grasp=right_grasp) is Status.FAILURE
    assert leaf.failure.kind is FailureKind.REFUSED


@pytest.mark.requirement("S7")
def test_a_halt_while_closing_leaves_the_fingers_where_they_are(stage, right_grasp):
    leaf = stage.ready(CloseGripper("close", stage.toolbox), grasp=right_grasp)
    for _ in range(5):
        stage.tick(leaf)
    leaf.stop(Status.INVALID)
    stage.fake.step()
    held = stage.fake.grippers["right"].position_rad

    for _ in range(10):
        stage.fake.step()

    assert stage.fake.grippers["right"].position_rad == held
    assert -0.6 < held < -0.05


@pytest.mark.requirement("M2")
def test_verify_hold_believes_a_grip_of_the_objects_size(knowing, planned):
    planned.grip()

    assert knowing.run(VerifyHold("verify hold", knowing.toolbox), grasp=planned.grasp) is Status.SUCCESS


@pytest.mark.requirement("M2")
def test_verify_hold_fails_when_nothing_is_between_the_fingers(knowing, planned):
    knowing.fake.grippers["right"].empty = True
    planned.grip()
    leaf = VerifyHold("verify hold", knowing.toolbox)

    assert knowing.run(leaf, grasp=planned.grasp) is Status.FAILURE
    assert leaf.failure.kind is FailureKind.POSTCONDITION
    assert leaf.failure.numbers["opening_m"] < 0.002


@pytest.mark.requirement("M2")
def test_verify_hold_fails_when_something_thinner_is_held(knowing, planned):
    planned.grip()
    hand = knowing.fake.grippers["right"]
    hand.position_rad, hand.speed_rad_s = -0.4, 0.0
    leaf = VerifyHold("verify hold", knowing.toolbox)

    assert knowing.run(leaf, grasp=planned.grasp) is Status.FAILURE
    assert leaf.failure.message == "something of another size is between the fingers"
