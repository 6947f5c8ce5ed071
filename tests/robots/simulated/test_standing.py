"""Standing on two feet in the simulation: what the efforts ask for is what the floor can give."""

import numpy as np

from kinematics.model.stance import stance_at
from kinematics.model.standing_robot import StandingRobot
from kinematics.standing.free_coordinates import free_coordinates
from robots.scenes.scene_description import SceneDescription


def test_over_one_foot_the_robot_does_not_sway(stand, robot_model):
    # CoM 8 cm aside, above the left foot: the right one carries a quarter, and cannot bear half the moment.
    body = stand(SceneDescription("bare"))
    space = free_coordinates(StandingRobot(robot_model, stance_at(robot_model, robot_model.q_home)))
    aside = space.home.copy()

    def lean(share):
        aside[1] = space.home[1] + 0.09 * share
        body.q = space.to_q(aside[None])[0][0]
        body.hold_posture(body.q[7:])
        body.step()

    for step in range(1, 1001):
        s = step / 1000
        lean(s * s * s * (10.0 + s * (6.0 * s - 15.0)))
    off = []
    for _ in range(1500):
        body.step()
        off.append(body.truth.joint_positions()[: len(robot_model.joints)] - body.q[7:])

    assert body.robot.read().foot_wrench[1, 2] < 300.0
    assert np.std(off, axis=0).max() < 2.5e-4  # 5.2e-4 with the smallest wrenches of the soles
    assert np.abs(np.mean(off, axis=0)).max() < 5e-4  # 7.1e-4
