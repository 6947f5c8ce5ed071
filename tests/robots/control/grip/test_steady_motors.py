"""The motors of a hand that presses: their setpoints come back to the fingers, stay there, and go back."""

import numpy as np
import pytest

from robots.control.grip.hand_joints import HandJoints
from robots.control.grip.steady_motors import SteadyMotors
from robots.models.description import load_robot

G1 = load_robot("g1")
PERIOD_S = 0.002
HANDS = pytest.mark.parametrize("hand", ["left", "right"])


class Pressing:
    """A hand that presses at the end of its fingers' way, and fingers that are held half open."""

    def __init__(self, hand):
        self.joints = HandJoints(G1.description, hand)
        self.motors = SteadyMotors(G1, self.joints, PERIOD_S)
        self.ends, self.fingers = (self.joints.setpoint(at, 0.0)[0] for at in (0.0, 0.5))
        names = self.joints.names
        self.limits = [G1.description.limits[name] for name in names]
        stiffness = np.array([G1.hardware.gains[name].stiffness for name in names])
        self.bends = np.array([limit.effort for limit in self.limits]) / stiffness

    def press(self, seconds=1.0):
        speeds = []
        for _ in range(round(seconds / PERIOD_S)):
            self.motors.come_to(self.fingers, self.ends)
            self.motors.commit()
            speeds.append(self.motors.speed.copy())
        return np.array(speeds)

    @property
    def beyond(self):
        """How far each setpoint is beyond its finger, as a share of what bends its servo by its effort."""
        inwards = self.joints.inwards
        return (inwards * (self.ends + self.motors.shift - self.fingers) / self.bends)[inwards != 0.0]


@HANDS
def test_each_setpoint_comes_back_to_what_leaves_its_servo_some_effort(hand):
    pressing = Pressing(hand)

    speeds = pressing.press()

    assert pressing.beyond == pytest.approx(0.85, abs=0.011)
    assert not pressing.motors.moving
    acceleration = np.diff(speeds, axis=0) / PERIOD_S
    assert np.all(np.abs(speeds) <= [limit.velocity for limit in pressing.limits])
    assert np.all(np.abs(acceleration) <= [limit.acceleration for limit in pressing.limits])


@HANDS
def test_a_setpoint_at_rest_meets_little_movement_and_follows_much(hand):
    pressing = Pressing(hand)
    pressing.press()
    before = pressing.motors.shift.copy()

    pressing.fingers = pressing.fingers + 0.25 * pressing.bends
    assert not pressing.press().any()
    assert pressing.motors.shift == pytest.approx(before, abs=0.0)

    pressing.fingers = pressing.fingers + 0.4 * pressing.bends
    assert pressing.press().any()
    assert pressing.beyond == pytest.approx(0.85, abs=0.011)


@HANDS
def test_what_creeps_is_followed_slowly_and_what_gives_way_at_once(hand):
    pressing = Pressing(hand)
    pressing.press()

    fastest = []
    for share in (0.35, 1.0):
        pressing.fingers = pressing.fingers + share * pressing.bends
        fastest.append(np.abs(pressing.press(3.0)).max())
        assert pressing.beyond == pytest.approx(0.85, abs=0.011)

    assert fastest[0] < 0.031
    assert fastest[1] > 1.0


@HANDS
def test_fingers_that_are_closed_press_at_the_end_and_no_farther(hand):
    pressing = Pressing(hand)
    pressing.fingers = pressing.ends

    assert not pressing.press().any()
    assert not pressing.motors.shifted


def test_what_opens_goes_back_to_the_position_of_the_hand():
    pressing = Pressing("right")
    pressing.press()
    assert pressing.motors.shifted

    for _ in range(round(0.5 / PERIOD_S)):
        pressing.motors.go_back()

    assert not pressing.motors.shifted


def test_what_was_refused_is_taken_back_and_what_halts_stays():
    pressing = Pressing("right")
    pressing.press(0.05)
    before = pressing.motors.shift.copy()

    pressing.motors.come_to(pressing.fingers, pressing.ends)
    assert (pressing.motors.shift != before).any()
    pressing.motors.revert()
    assert pressing.motors.shift == pytest.approx(before, abs=0.0)
    assert pressing.motors.moving

    pressing.motors.halt()
    assert pressing.motors.shift == pytest.approx(before, abs=0.0)
    assert not pressing.motors.moving
