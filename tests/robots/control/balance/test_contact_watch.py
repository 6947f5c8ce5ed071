import numpy as np
import pytest

from kinematics.estimation.held_mass import effort_per_kg
from kinematics.model.robot_model import RobotModel
from kinematics.motion.trajectory import HeldLoad
from robots.control.balance.contact_watch import PERIODS, WALKING_PERIODS, ContactWatch
from robots.control.gate.refusal import Limit
from robots.models.description import load_description, load_robot

MODEL = RobotModel(load_description("talos"))
HARDWARE = load_robot("talos").hardware
TALOS = MODEL.description
ELBOW = TALOS.actuated.index("arm_left_4_joint")


def pushed(watch, push_nm, moving=True, periods=PERIODS, walks=False):
    expected = np.linspace(-20.0, 20.0, len(TALOS.actuated))
    effort = expected.copy()
    effort[ELBOW] += push_nm
    refusals = [watch.judge(effort, expected, moving, walks) for _ in range(periods)]
    return next((refusal for refusal in refusals if refusal is not None), None)


@pytest.mark.parametrize("push_nm", [12.0, -12.0])
def test_a_push_beyond_what_the_motion_needs_is_noticed(push_nm):
    refusal = pushed(ContactWatch(MODEL, HARDWARE.contact_effort_nm), push_nm)

    assert refusal.limit is Limit.CONTACT
    assert refusal.joint == "arm_left_4_joint"
    assert refusal.value == pytest.approx(12.0)
    assert str(refusal) == "unexpected contact of arm_left_4_joint: 12 Nm, allowed 10 Nm"


def test_the_weight_of_a_cup_and_a_single_spike_are_no_contact():
    assert pushed(ContactWatch(MODEL, HARDWARE.contact_effort_nm), 7.0, periods=50) is None
    assert pushed(ContactWatch(MODEL, HARDWARE.contact_effort_nm), 100.0, periods=PERIODS - 1) is None


def test_a_push_that_was_there_before_does_not_hinder_the_motion_that_ends_it():
    watch = ContactWatch(MODEL, HARDWARE.contact_effort_nm)
    pushed(watch, 40.0, moving=False)

    assert pushed(watch, 40.0, periods=50) is None
    assert pushed(watch, 45.0).limit is Limit.CONTACT


def test_on_a_walk_an_arm_that_is_jolted_is_no_contact_and_one_that_goes_on_pushing_is():
    watch = ContactWatch(MODEL, HARDWARE.contact_effort_nm)

    assert pushed(watch, 18.0, periods=200, walks=True) is None
    assert pushed(watch, 21.0, periods=WALKING_PERIODS - 1, walks=True) is None
    assert (
        pushed(
            ContactWatch(MODEL, HARDWARE.contact_effort_nm), 21.0, periods=WALKING_PERIODS, walks=True
        ).limit
        is Limit.CONTACT
    )


def test_legs_which_balance_are_not_watched():
    watch = ContactWatch(MODEL, HARDWARE.contact_effort_nm)
    effort, expected = np.zeros(len(TALOS.actuated)), np.zeros(len(TALOS.actuated))
    effort[:14] = 100.0

    assert all(watch.judge(effort, expected, True) is None for _ in range(20))


BEFORE_THE_PALM = (0.15, 0.0, 0.0)


def lifting(watch, mass_kg, push_nm=0.0):
    """Efforts of a lift, with a weight in the left hand and a push at the elbow."""
    frame = TALOS.tcp_frames["left"]
    watch.bear((HeldLoad(frame, 0.0, BEFORE_THE_PALM),), lambda: MODEL.q_home)
    expected = np.zeros(len(TALOS.actuated))
    effort = expected.copy()
    per_kg = effort_per_kg(MODEL, frame, MODEL.q_home, np.array(BEFORE_THE_PALM))
    for joint, value in zip(MODEL.joints, per_kg, strict=True):
        effort[TALOS.actuated.index(joint)] = mass_kg * value
    effort[ELBOW] += push_nm
    refusals = [watch.judge(effort, expected, True) for _ in range(PERIODS)]
    return next((refusal for refusal in refusals if refusal is not None), None)


def test_the_weight_of_what_is_lifted_is_no_contact_before_it_is_known():
    assert lifting(ContactWatch(MODEL, HARDWARE.contact_effort_nm), 4.0) is None


def test_more_than_the_hand_can_carry_and_a_push_beside_a_weight_are_contact():
    assert lifting(ContactWatch(MODEL, HARDWARE.contact_effort_nm), 12.0).limit is Limit.CONTACT
    assert lifting(ContactWatch(MODEL, HARDWARE.contact_effort_nm), 1.5, push_nm=-25.0).limit is Limit.CONTACT


def test_what_nobody_holds_explains_no_effort_any_more():
    watch = ContactWatch(MODEL, HARDWARE.contact_effort_nm)
    assert lifting(watch, 4.0) is None
    watch.bear((), lambda: MODEL.q_home)

    assert pushed(watch, 12.0).limit is Limit.CONTACT
