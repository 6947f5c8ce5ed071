"""What an arm feels beyond its need: what counts as a touch, and which ways press on against it."""

import numpy as np
import pytest

from kinematics.estimation.held_mass import effort_per_kg
from kinematics.model.robot_model import RobotModel
from robots.control.hands.jog_touch import JogTouch
from robots.models.description import load_description, load_robot

MODEL = RobotModel(load_description("talos"))
HARDWARE = load_robot("talos").hardware
ELBOW = MODEL.joints.index("arm_left_4_joint")
WAIST = MODEL.joints.index("torso_1_joint")
NEEDED = np.linspace(-20.0, 20.0, len(MODEL.description.actuated))


def one(joint, value):
    row = np.zeros(len(MODEL.joints))
    row[joint] = value
    return row


def felt(extra, ticks=3, holding=None):
    """The touch after some ticks of efforts beyond the need, shape (body joints,)."""
    touch = JogTouch(MODEL, HARDWARE, lambda hand: hand == holding)
    effort = NEEDED.copy()
    effort[: len(extra)] += extra
    for _ in range(ticks):
        for _ in range(5):
            touch.take(effort, NEEDED)
        touch.tick(MODEL.q_home)
    return touch


def test_half_of_what_is_contact_on_a_planned_way_is_a_touch_and_is_told():
    touch = felt(one(ELBOW, -5.5))

    assert "the left arm meets something that nobody saw (arm_left_4_joint gives 5.5 Nm more" in touch.told
    assert touch.felt_nm[ELBOW] == pytest.approx(-5.5)


@pytest.mark.parametrize(("extra_nm", "ticks"), [(4.5, 9), (50.0, 1)])
def test_noise_of_a_free_arm_and_a_single_spike_are_none(extra_nm, ticks):
    touch = felt(one(ELBOW, extra_nm), ticks)

    assert touch.felt_nm is None
    assert not touch.presses(one(ELBOW, 0.1))


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_the_way_that_the_motor_pushes_presses_on_and_the_opposite_does_not(sign):
    touch = felt(one(ELBOW, 7.0 * sign))

    assert touch.presses(one(ELBOW, 0.1 * sign))
    assert not touch.presses(one(ELBOW, -0.1 * sign))
    assert sign * touch.easing[ELBOW] < 0.0


def test_a_trunk_that_brings_a_pressed_hand_on_presses_too():
    touch = felt(one(ELBOW, 7.0) + one(WAIST, 20.0))

    assert touch.presses(one(WAIST, 0.1))
    assert not touch.presses(one(WAIST, -0.1))


def test_it_gives_way_until_it_hardly_presses():
    assert not felt(one(ELBOW, 1.9)).easing.any()


@pytest.mark.parametrize(("holding", "felt_it"), [("right", False), (None, True)])
def test_the_weight_of_what_fingers_hold_is_no_touch(holding, felt_it):
    gripper = MODEL.description.grippers["right"]
    weight = 1.5 * effort_per_kg(MODEL, gripper.tcp_frame, MODEL.q_home, np.zeros(3))

    assert (felt(weight, holding=holding).felt_nm is not None) == felt_it
