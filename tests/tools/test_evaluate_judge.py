"""The judge says held only when the truth says so, all the time."""

from types import SimpleNamespace

import numpy as np
import pytest

from kinematics.geometry import poses
from tools.evaluate.judge import Judge

CUP = "red cup"


class ScriptedTruth:
    """A truth whose every answer is a field."""

    hands = ("left", "right")

    def __init__(self):
        self.present, self.height, self.in_hand = True, 0.0, (0.02, 0.0, 0.0)
        self.touching, self.margin, self.down, self.friction = (), 0.05, False, 0.6
        self.objects_touched = ()
        self.contacts = self

    def objects(self):
        return (CUP,) if self.present else ()

    def lift_m(self, name):
        return self.height

    def tcp_T_object(self, hand, name):
        return poses.translation(*self.in_hand) if hand == "right" else poses.translation(0.9, 0.0, 0.0)

    def of_pads(self, name):
        return (SimpleNamespace(friction=self.friction),)

    def robot_touches_something(self):
        return bool(self.touching or self.objects_touched)

    def robot_with_furniture(self):
        return self.touching

    def robot_with_objects(self):
        return self.objects_touched

    def com_margin_m(self):
        return self.margin

    def fallen(self):
        return self.down


@pytest.fixture
def truth():
    return ScriptedTruth()


@pytest.fixture
def judge(truth):
    return Judge(truth, CUP)


def watch(judge, periods=10):
    for _ in range(periods):
        judge.on_period()


def lift_and_hold(truth, judge):
    truth.height = 0.13
    watch(judge)
    judge.begin_hold()
    watch(judge)


def test_lifted_and_held_is_held(truth, judge):
    lift_and_hold(truth, judge)

    assert judge.truly_held


def test_nothing_is_held_before_the_hold_begins(truth, judge):
    truth.height = 0.13
    watch(judge)

    assert not judge.truly_held


def test_a_moment_below_ten_centimetres_is_not_held(truth, judge):
    lift_and_hold(truth, judge)
    truth.height = 0.099
    watch(judge)
    truth.height = 0.13
    watch(judge)

    assert not judge.truly_held


def test_an_object_that_is_gone_is_not_held(truth, judge):
    lift_and_hold(truth, judge)
    truth.present = False
    watch(judge)

    assert not judge.truly_held


def test_a_robot_that_lies_on_the_floor_holds_nothing(truth, judge):
    lift_and_hold(truth, judge)
    truth.down = True
    watch(judge)

    assert judge.fell
    assert not judge.truly_held


def test_slip_is_the_farthest_motion_in_the_hand_that_lifted(truth, judge):
    truth.height = 0.05
    watch(judge)
    truth.in_hand = (0.02, 0.003, 0.0)
    watch(judge)
    truth.in_hand = (0.02, 0.001, 0.0)
    watch(judge)

    assert judge.slip_m == pytest.approx(0.003)


def test_slip_starts_anew_with_a_new_grasp(truth, judge):
    truth.height = 0.05
    watch(judge)
    truth.height, truth.in_hand = 0.0, (0.05, 0.0, 0.0)
    watch(judge)
    truth.height = 0.05
    watch(judge)

    assert judge.slip_m == pytest.approx(0.0)


def test_contacts_and_margin_keep_their_worst(truth, judge):
    truth.touching = (SimpleNamespace(first="arm_left_5_link", second="table/top"),)
    truth.margin = 0.01
    watch(judge)
    truth.touching, truth.margin = (), 0.05
    watch(judge)

    assert judge.furniture_contacts == {"arm_left_5_link and table/top"}
    assert judge.com_margin_m == pytest.approx(0.01)


def test_any_object_but_the_target_that_is_touched_is_noted(truth, judge):
    truth.objects_touched = (
        SimpleNamespace(first="gripper_right_pad", second=CUP),
        SimpleNamespace(first="arm_right_7_link", second="bottle"),
    )
    judge.on_period()
    truth.objects_touched = ()
    watch(judge)

    assert judge.others_touched == {"arm_right_7_link and bottle"}


def test_a_contact_of_one_period_is_not_missed(truth, judge):
    judge.on_period()
    truth.touching = (SimpleNamespace(first="hand", second="table/top"),)
    judge.on_period()
    truth.touching = ()
    watch(judge)

    assert judge.furniture_contacts


def test_the_friction_of_the_pads_is_read_back_from_the_contacts(truth, judge):
    lift_and_hold(truth, judge)

    assert judge.friction == pytest.approx(0.6)
    assert not np.isinf(judge.held_lift_m)
