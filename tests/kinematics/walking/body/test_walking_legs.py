"""Legs are placed over feet that move as the solver of standing legs has them, whatever their form."""

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.planar import PlanarPose
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import Stance
from kinematics.model.standing_robot import StandingRobot
from kinematics.standing.leg_ik import LegIk
from kinematics.walking.body.walking_legs import walking_legs
from robots.models.description import load_description


@pytest.fixture(scope="module", params=["talos", "g1"])
def model(request):
    return RobotModel(load_description(request.param))


def feet_at(model, rng):
    """Where soles of a walk are: near home, one of them lifted."""
    rows = []
    for sole in model.description.soles:
        home = PlanarPose.of(model.frame_pose(model.q_home, sole.frame))
        x, y, turn = rng.uniform(-0.08, 0.08), rng.uniform(-0.02, 0.02), rng.uniform(-0.2, 0.2)
        rows.append((home.x_m + x, home.y_m + y, 0.0, home.yaw_rad + turn))
    lifted = int(rng.integers(len(rows)))
    rows[lifted] = (*rows[lifted][:2], rng.uniform(0.0, 0.04), rows[lifted][3])
    return np.array(rows)


def placed(model, feet):
    soles = [
        (sole.frame, poses.translation(x, y, z) @ poses.transform(poses.rotation_z(yaw), np.zeros(3)))
        for sole, (x, y, z, yaw) in zip(model.description.soles, feet.tolist(), strict=True)
    ]
    return LegIk(StandingRobot(model, Stance(tuple(soles))))


@pytest.mark.parametrize("seed", range(20))
def test_they_are_where_legs_that_stand_are(model, seed):
    rng = np.random.default_rng(seed)
    feet, legs = feet_at(model, rng), walking_legs(model)
    q = model.q_home.copy()
    q[2] -= 0.02
    q[7 + model.joint_index(model.description.groups["left_leg"][3])] += 0.05

    reached = legs.fill(q, poses.rotation_from_quaternion(q[3:7]), feet)

    expected = q.copy()
    assert placed(model, feet).fill(expected[None, :]).all() == reached
    assert reached
    assert q == pytest.approx(expected, abs=1e-8)


def test_a_foot_that_is_too_far_away_is_not_reached(model):
    feet, q = feet_at(model, np.random.default_rng(0)), model.q_home.copy()
    feet[0, 0] += 2.0

    assert not walking_legs(model).fill(q, np.eye(3), feet)
