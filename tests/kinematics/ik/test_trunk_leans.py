"""Over a low table the trunk leans, not the pelvis alone: G1 gets everywhere to what stands near the edge."""

import dataclasses

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.ik.result import DEFAULT_TOLERANCE
from kinematics.ik.solver import inverse_kinematics
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import stance_at
from kinematics.model.standing_robot import StandingRobot
from robots.models.description import load_description


@pytest.fixture(scope="module")
def robot():
    model = RobotModel(load_description("g1"))
    return StandingRobot.of(model, stance_at(model, model.q_home))


@pytest.mark.requirement("U4")
@pytest.mark.parametrize("height_m", [0.72, 0.78])
@pytest.mark.parametrize(("ahead_m", "aside_m"), [(0.36, 0.12), (0.41, 0.12), (0.41, 0.18)])
def test_a_level_hand_gets_there_with_a_pelvis_that_hardly_leans(robot, ahead_m, aside_m, height_m):
    ik = inverse_kinematics(robot, "left")
    found = []
    for yaw_rad in np.radians([-60.0, -45.0, -30.0, -15.0, 0.0, 15.0]):
        for roll_rad in (0.0, np.pi):
            turn = poses.rotation_z(yaw_rad) @ poses.rotation_x(roll_rad)
            place = poses.transform(turn, (ahead_m, aside_m, height_m))
            answer = ik.solve(place, robot.q_home)
            if answer.within(DEFAULT_TOLERANCE):
                found.append(float(np.arccos(poses.rotation_from_quaternion(answer.q[3:7])[2, 2])))

    assert len(found) >= 3
    assert np.median(found) < np.radians(15.0)
    assert max(found) <= robot.model.description.lean_rad


def test_no_answer_leans_farther_than_the_robot_may(robot):
    place = poses.transform(np.eye(3), (0.36, 0.18, 0.72))
    strict = RobotModel(dataclasses.replace(robot.model.description, lean_rad=0.01))
    upright = StandingRobot.of(strict, stance_at(strict, strict.q_home))

    assert inverse_kinematics(robot, "left").solve(place, robot.q_home).within(DEFAULT_TOLERANCE)
    assert not inverse_kinematics(upright, "left").solve(place, upright.q_home).within(DEFAULT_TOLERANCE)
