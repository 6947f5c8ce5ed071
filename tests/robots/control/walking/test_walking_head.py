"""The head of a robot that walks."""

import numpy as np
import pytest

from kinematics.model.robot_model import RobotModel
from robots.control.walking.walking_head import WalkingHead
from robots.models.description import load_description

PERIOD_S = 0.002


@pytest.fixture(scope="module")
def model():
    return RobotModel(load_description("talos"))


@pytest.fixture
def head(model):
    return WalkingHead(model, model.q_home, PERIOD_S)


def turned(head, seconds, resting=False):
    return np.array([head.advance(resting=resting) for _ in range(round(seconds / PERIOD_S))])


def test_a_head_that_nobody_told_to_look_anywhere_is_left_alone(head):
    assert head.advance(resting=False) is None
    assert head.at_rest


def test_it_comes_to_rest_where_it_is_told_to_look(head):
    head.look(0.7, 0.1)

    assert turned(head, 3.0)[-1] == pytest.approx([0.7, 0.1], abs=1e-6)
    assert head.at_rest


def test_it_turns_no_farther_than_its_joints(model, head):
    head.look(3.0, 0.1)

    assert turned(head, 5.0)[-1][0] < model.description.limits["head_2_joint"].position[1]


def test_it_keeps_the_limits_of_its_joints_wherever_it_is_told_to_look(model, head):
    rng = np.random.default_rng(0)
    q = []
    for _ in range(20):
        head.look(*rng.uniform(-1.2, 1.2, 2))
        q.append(turned(head, 0.15))
    v = np.diff(np.concatenate(q), axis=0) / PERIOD_S
    a = np.diff(v, axis=0) / PERIOD_S

    for k, joint in enumerate(("head_2_joint", "head_1_joint")):
        limits = model.description.limits[joint]
        assert np.abs(v[:, k]).max() <= limits.velocity
        assert np.abs(a[:, k]).max() <= limits.acceleration


def test_as_the_walk_comes_to_rest_it_stops_on_its_way(head):
    head.look(1.2, 0.1)
    on_the_way = turned(head, 0.4)[-1][0]

    stopped = turned(head, 0.6, resting=True)

    assert head.at_rest
    assert on_the_way < stopped[-1][0] < 1.0


def test_a_robot_whose_camera_no_joint_aims_moves_nothing():
    model = RobotModel(load_description("g1"))
    head = WalkingHead(model, model.q_home, PERIOD_S)

    head.look(0.5, 0.2)

    assert len(head.columns) == 0
    assert len(head.advance(resting=False)) == 0
