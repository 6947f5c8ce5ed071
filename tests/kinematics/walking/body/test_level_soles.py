"""Level soles under the ankles of a robot whose soles are tilted."""

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import stance_at
from kinematics.model.standing_robot import StandingRobot
from kinematics.walking.body.level_soles import levelled
from robots.models.description import load_description


@pytest.fixture(scope="module", params=["talos", "g1"])
def model(request):
    return RobotModel(load_description(request.param))


def soles_of(model, q):
    return dict(stance_at(model, q).soles)


def test_level_soles_are_left_alone(model):
    q = model.q_home
    soles = {frame: poses.transform(np.eye(3), pose[:3, 3]) for frame, pose in soles_of(model, q).items()}

    found, same = levelled(model, q, soles)

    assert same is q
    assert found == soles


def test_a_tilted_sole_is_levelled_about_its_ankle(model):
    q = model.q_home.copy()
    tilt = dict(zip(model.description.groups["left_leg"][-2:], (0.06, -0.04), strict=True))
    for name, by in tilt.items():
        q[7 + model.joint_index(name)] += by

    found, straight = levelled(model, q, soles_of(model, q))

    for frame, pose in found.items():
        np.testing.assert_allclose(pose[2, :3], (0.0, 0.0, 1.0), atol=1e-12)
        np.testing.assert_allclose(model.frame_pose(straight, frame), pose, atol=1e-9)
    np.testing.assert_allclose(straight[:7], q[:7])
    np.testing.assert_allclose(straight, model.q_home, atol=0.005)


def test_the_home_posture_stands_upright_over_tilted_soles(model):
    q = model.q_home.copy()
    for leg in ("left_leg", "right_leg"):
        q[7 + model.joint_index(model.description.groups[leg][-2])] += 0.06

    home = StandingRobot(model, stance_at(model, q)).q_home

    np.testing.assert_allclose(home[3:7], model.q_home[3:7], atol=1e-9)
