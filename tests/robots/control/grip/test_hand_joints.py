"""A hand of several motors is moved and felt as one position."""

import numpy as np
import pytest

from robots.control.grip.hand_joints import HandJoints
from robots.models.description import load_description

TALOS, G1 = load_description("talos"), load_description("g1")


def at_home(description):
    return np.array([description.home[name] for name in description.actuated])


@pytest.mark.parametrize("hand", ["left", "right"])
def test_a_hand_at_home_is_open(hand):
    assert HandJoints(G1, hand).position(at_home(G1)) == pytest.approx(1.0)


@pytest.mark.parametrize("hand", ["left", "right"])
@pytest.mark.parametrize("position", [0.0, 0.3, 1.0])
def test_motors_that_stand_where_they_were_told_to_are_read_as_that_position(hand, position):
    joints, q = HandJoints(G1, hand), at_home(G1)
    v = np.zeros_like(q)

    joints.write(position, -0.5, q, v)

    assert joints.position(q) == pytest.approx(position)
    assert joints.stroke(q[joints.lead], v[joints.lead]) == pytest.approx((position, -0.5))
    assert joints.setpoint(position, -0.5)[0] == pytest.approx(q[joints.indices])


def test_motors_that_are_held_back_count_by_their_mean():
    joints, q = HandJoints(G1, "left"), at_home(G1)
    moving = len(G1.grippers["left"].moving)
    joints.write(0.2, 0.0, q, np.zeros_like(q))

    q[joints.lead] = G1.grippers["left"].moving[0].open_rad

    assert joints.position(q) == pytest.approx((0.2 * (moving - 1) + 1.0) / moving)


@pytest.mark.parametrize("hand", ["left", "right"])
def test_what_all_motors_press_inwards_is_added_up(hand):
    joints, gripper = HandJoints(G1, hand), G1.grippers[hand]
    effort = np.zeros(len(G1.actuated))
    for motor in gripper.moving:
        effort[G1.actuated.index(motor.joint)] = 0.25 * np.sign(motor.closed_rad - motor.open_rad)

    assert joints.effort(effort) == pytest.approx(-0.25 * len(gripper.moving))  # negative closes


def test_no_motor_is_faster_than_its_own_limit():
    joints = HandJoints(G1, "right")

    _, speeds = joints.setpoint(0.5, joints.limits.velocity)

    limits = np.array([G1.limits[name].velocity for name in joints.names])
    assert np.all(np.abs(speeds) <= limits + 1e-9)
    assert np.any(np.abs(speeds) >= limits - 1e-9)


def test_the_position_of_one_joint_is_the_joint_itself():
    joints, q = HandJoints(TALOS, "left"), at_home(TALOS)
    index = TALOS.actuated.index("gripper_left_joint")
    q[index] = -0.321

    assert joints.position(q) == q[index]
    assert joints.stroke(-0.3, 0.2) == (-0.3, 0.2)
    assert joints.limits.velocity == TALOS.limits["gripper_left_joint"].velocity
