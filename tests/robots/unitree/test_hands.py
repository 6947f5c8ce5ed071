"""The hands beside the body: their own topics, order, modes and failures."""

import numpy as np
import pytest

from robots.errors import DescriptionError
from robots.unitree.motors import DEX3, hand_motors_of
from robots.unitree.robot import SilentRobotError, UnitreeRobot
from robots.unitree.watch import Trouble
from tests.robots.unitree.test_robot import kinds, run, stiff


def test_what_a_hand_tells_is_read_behind_the_body_in_the_joints_own_order(g1, wire, body):
    told = 0.1 * np.arange(7)
    wire.put()
    wire.hands["right"].put_hand(told)

    body.advance(0.002)

    joints = g1.description.grippers["right"].joints
    columns = [g1.description.actuated.index(name) for name in joints]
    assert body.read().q[columns] == pytest.approx(told[hand_motors_of(joints, "right")])
    assert body.read().q.shape == body.read().effort.shape == body.read().motor_error.shape == (43,)


def test_each_finger_has_the_makers_number():
    names = ["left_hand_index_0_joint", "left_hand_middle_1_joint", "left_hand_thumb_2_joint"]

    assert hand_motors_of(names, "left").tolist() == [5, 4, 2]
    with pytest.raises(DescriptionError, match="'right_hand_thumb_0_joint' has no motor in a Dex3"):
        hand_motors_of(["right_hand_thumb_0_joint"], "left")


def test_a_hand_is_taken_up_and_its_motors_are_enabled_by_number_and_time_out(g1, wire, body, setpoint):
    run(body, wire, setpoint(0.2, 0.0), 60, hand_q=0.2)
    sent = wire.hands["left"].sent
    first, last = sent[0], sent[-1]

    assert last["motor"]["mode"].tolist() == [0x90 + k for k in range(len(DEX3))]
    assert stiff(first) < 0.01 * stiff(last)
    assert last["motor"]["q"] == pytest.approx(0.2)
    assert stiff(last) == pytest.approx(g1.hardware.gains["left_hand_index_0_joint"].stiffness)


def test_no_motor_is_told_a_position_that_asks_for_more_than_its_effort(g1, wire, body, setpoint):
    run(body, wire, setpoint(3.0, 0.0), 60)

    motor = wire.hands["left"].sent[-1]["motor"]
    joints = g1.description.grippers["left"].joints
    limits = np.array([g1.description.limits[name].effort for name in joints])
    asked = (motor["kp"] * motor["q"])[hand_motors_of(joints, "left")]
    assert asked == pytest.approx(limits, rel=1e-5)


def test_a_silent_hand_is_damped_and_told_and_the_body_stands(wire, body, setpoint):
    run(body, wire, setpoint(), 60)

    run(body, wire, setpoint(), 60, silent=("left",))

    assert kinds(body) == [Trouble.HAND_SILENT]
    assert body.read().alarm == "wire hand silent: no state of the left hand for more than 0.1 s"
    assert stiff(wire.hands["left"].sent[-1]) == 0.0
    assert stiff(wire.hands["right"].sent[-1]) > 0.0
    assert stiff(wire.sent[-1]) > 0.0
    assert "left hand" in body.reset()

    run(body, wire, setpoint(), 2, hand_q=0.7)
    assert wire.hands["left"].sent[-1]["motor"]["q"] == pytest.approx(0.7, abs=0.01)
    assert body.reset() is None


def test_hands_are_damped_with_a_body_that_is(wire, body, setpoint):
    run(body, wire, setpoint(), 60)

    run(body, wire, setpoint(), 2, mode_machine=6)

    assert stiff(wire.hands["right"].sent[-1]) == 0.0


def test_an_error_of_a_finger_is_told_with_its_joint(wire, body, setpoint):
    run(body, wire, setpoint(), 60)
    state = wire.hands["left"].put_hand()
    state["motor"]["reserve"][5, 0] = 3
    wire.put()

    body.advance(0.002)

    assert body.read().alarm == "wire motor error: left_hand_index_0_joint, code 3"


def test_a_hand_that_says_nothing_at_first_is_told_with_its_topic(g1, wire, clock):
    wire.hands["right"].coming.clear()

    with pytest.raises(SilentRobotError, match=r"no state on rt/dex3/right/state within 0.5 s"):
        UnitreeRobot(g1, wire, clock, wire.hands, first_within_s=0.5)


def test_a_hand_without_a_wire_is_refused(g1, wire, clock):
    with pytest.raises(DescriptionError, match="the left hand has no wire"):
        UnitreeRobot(g1, wire, clock, {"right": wire.hands["right"]})
