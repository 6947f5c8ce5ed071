"""Legs without a closed form are solved as exactly, against Pinocchio's forward kinematics."""

import dataclasses

import numpy as np
import pytest

from kinematics.errors import ModelError
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import stance_at
from kinematics.model.standing_robot import StandingRobot
from kinematics.standing import leg_ik
from kinematics.standing.leg_ik import LegIk
from kinematics.standing.numeric_leg import NumericLeg
from robots.models.description import load_description


@pytest.fixture(scope="module")
def g1():
    return RobotModel(load_description("g1"))


def shifted(model, rng, count):
    q = np.tile(model.q_home, (count, 1))
    q[:, :3] += rng.uniform([-0.06, -0.06, -0.2], [0.06, 0.06, 0.01], (count, 3))
    q[:, 3:6] += rng.normal(0.0, 0.04, (count, 3))
    q[:, 3:7] /= np.linalg.norm(q[:, 3:7], axis=1, keepdims=True)
    return q


def test_soles_stay_at_the_stance_to_a_nanometre(g1):
    stance = stance_at(g1, g1.q_home)
    q = shifted(g1, np.random.default_rng(0), 200)

    reached = LegIk(StandingRobot(g1, stance)).fill(q)

    assert reached.all()
    for configuration in q:
        for frame, world_T_sole in stance.soles:
            assert g1.frame_pose(configuration, frame) == pytest.approx(world_T_sole, abs=1e-9)


def test_the_legs_that_made_a_stance_are_found_again(g1):
    rng = np.random.default_rng(1)
    legs = np.concatenate([g1.group("left_leg"), g1.group("right_leg")])
    for _ in range(50):
        q = g1.q_home.copy()
        bent = q[7 + legs] + rng.uniform(-0.2, 0.2, 12)
        q[7 + legs] = np.clip(bent, g1.lower_rad[legs], g1.upper_rad[legs])
        found = q.copy()
        found[7 + legs] = 0.0

        assert LegIk(StandingRobot(g1, stance_at(g1, q))).fill(found[None, :]).all()
        assert found == pytest.approx(q, abs=1e-7)


def test_neighbouring_poses_have_neighbouring_legs(g1):
    stance = stance_at(g1, g1.q_home)
    q = np.tile(g1.q_home, (400, 1))
    q[:, 2] -= np.linspace(0.0, 0.3, 400)
    q[:, 0] += 0.05 * np.sin(np.linspace(0.0, 6.0, 400))

    assert LegIk(StandingRobot(g1, stance)).fill(q).all()
    assert np.max(np.abs(np.diff(q[:, 7:], axis=0))) < 0.02


def test_a_pose_is_solved_the_same_alone_and_among_others(g1):
    stance = stance_at(g1, g1.q_home)
    together = shifted(g1, np.random.default_rng(2), 20)
    alone = together.copy()

    LegIk(StandingRobot(g1, stance)).fill(together)
    for row in alone:
        LegIk(StandingRobot(g1, stance)).fill(row[None, :])

    assert together == pytest.approx(alone, abs=1e-10)


def test_a_pelvis_that_is_too_high_is_not_reached(g1):
    q = np.array([g1.q_home, g1.q_home])
    q[1, 2] += 0.3

    assert LegIk(StandingRobot(g1, stance_at(g1, g1.q_home))).fill(q).tolist() == [True, False]


def test_both_ways_agree_on_a_leg_that_has_a_closed_form(talos, stance):
    q = shifted(talos, np.random.default_rng(3), 100)
    closed, numeric = q.copy(), q.copy()
    placed = dict(stance.soles)

    LegIk(StandingRobot(talos, stance)).fill(closed)
    for side in ("left", "right"):
        frame = f"{side}_sole_link"
        leg = NumericLeg(talos, f"{side}_leg", frame, placed[frame])
        assert leg.fill(numeric, leg_ik._rotations(numeric[:, 3:7])).all()

    assert numeric == pytest.approx(closed, abs=1e-9)


def test_a_leg_of_too_few_joints_is_refused(g1):
    placed = dict(stance_at(g1, g1.q_home).soles)
    groups = {**g1.description.groups, "left_leg": g1.description.groups["left_leg"][:5]}
    description = dataclasses.replace(g1.description, groups=groups)

    with pytest.raises(ModelError, match="six joints"):
        NumericLeg(RobotModel(description), "left_leg", "left_sole", placed["left_sole"])


def test_knees_are_kept_off_where_a_millimetre_more_is_out_of_reach(g1):
    legs = LegIk(StandingRobot(g1, stance_at(g1, g1.q_home)))

    ranges = legs.bent_knees()

    assert set(ranges) == {"left_knee_joint", "right_knee_joint"}
    for low, high in ranges.values():
        assert low == pytest.approx(0.1, abs=0.02)
        assert high == pytest.approx(2.8798)
