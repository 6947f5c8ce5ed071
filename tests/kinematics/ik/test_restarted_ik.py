"""Inverse kinematics of a welded arm, begun anew where one start leads nowhere."""

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.ik.placo_ik import PlacoIk
from kinematics.ik.restarted_ik import RestartedIk
from kinematics.ik.result import DEFAULT_TOLERANCE
from kinematics.ik.solver import inverse_kinematics
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import Stance
from kinematics.model.standing_robot import StandingRobot
from robots.models.description import load_description


@pytest.fixture(scope="module")
def robot():
    return StandingRobot(RobotModel(load_description("panda")), Stance(()))


def at_a_handle(rng):
    """A hand with its fingers one above the other, before a drawer."""
    turn = poses.rotation_z(rng.uniform(-0.7, 0.7)) @ poses.rotation_x(rng.choice([-0.5, 0.5]) * np.pi)
    return poses.transform(turn, rng.uniform((0.4, -0.3, 0.8), (0.7, 0.3, 1.1)))


def found(ik, robot, targets):
    return sum(ik.solve(target, robot.q_home).within(DEFAULT_TOLERANCE) for target in targets)


def test_it_finds_most_of_what_one_start_misses(robot):
    rng = np.random.default_rng(7)
    targets = [at_a_handle(rng) for _ in range(40)]

    once, anew = (found(kind(robot, "right"), robot, targets) for kind in (PlacoIk, RestartedIk))

    assert once <= 20
    assert anew >= 30


def test_what_is_to_stay_near_a_posture_is_not_begun_elsewhere(robot):
    out_of_reach = poses.translation(3.0, 0.0, 1.0)
    q = robot.q_home

    answers = [ik(robot, "right").solve(out_of_reach, q, q_preferred=q) for ik in (PlacoIk, RestartedIk)]

    assert np.array_equal(answers[0].q, answers[1].q)


def test_answers_are_the_same_each_time(robot):
    target = at_a_handle(np.random.default_rng(3))

    first, again = (RestartedIk(robot, "right").solve(target, robot.q_home) for _ in range(2))

    assert np.array_equal(first.q, again.q)


def test_a_welded_robot_gets_it(robot):
    assert isinstance(inverse_kinematics(robot, "right"), RestartedIk)
