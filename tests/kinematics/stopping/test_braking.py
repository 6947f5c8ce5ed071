import dataclasses

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from kinematics.model.stance import stance_at
from kinematics.model.standing_robot import StandingRobot
from kinematics.motion.curves import PolynomialCurve
from kinematics.motion.sampler import TrajectorySampler
from kinematics.motion.trajectory import Trajectory
from kinematics.standing.free_coordinates import FreeCoordinates
from kinematics.stopping.braking import brake_along, brake_joints, brake_standing
from kinematics.timing.balanced_timing import time_in_balance
from kinematics.timing.curve_timing import Pace

PERIOD_S = 0.002
ACCELERATION, JERK = np.full(3, 8.0), np.full(3, 120.0)


def swing(talos, amount, duration_s):
    return TrajectorySampler(swung(talos, amount, duration_s))


def swung(talos, amount, duration_s, segments=100):
    t = np.linspace(0.0, duration_s, segments + 1)
    u = t / duration_s
    s, ds = u**3 * (10 - 15 * u + 6 * u**2), 30 * u**2 * (1 - u) ** 2 / duration_s
    q, v = np.repeat(talos.q_home[None], len(t), axis=0), np.zeros((len(t), talos.nv))
    for name, share in (("arm_left_2_joint", 1.0), ("arm_left_4_joint", 0.5)):
        i = talos.joint_index(name)
        q[:, 7 + i] += share * amount * s
        v[:, 6 + i] = share * amount * ds
    return Trajectory(talos.joints, stance_at(talos, talos.q_home), t, q, v)


@pytest.mark.parametrize("share", [0.05, 0.2, 0.4, 0.5, 0.6, 0.8])
def test_braking_stays_on_the_path_within_limits_and_ends_at_rest(talos, stance, share):
    sampler = swing(talos, 0.8, 1.2)

    brake = brake_along(StandingRobot(talos, stance), sampler, share * 1.2, PERIOD_S)

    assert brake is not None
    rows = brake.rows
    assert not rows.v[-1].any()
    assert (np.abs(rows.a[:, 6:]) <= 8.0 * 1.005).all()
    assert (np.abs(np.diff(rows.a[:, 6:], axis=0)) <= 120.0 * PERIOD_S * 1.005).all()
    shoulder, elbow = (rows.q[:, 7 + talos.joint_index(f"arm_left_{k}_joint")] for k in (2, 4))
    start = talos.q_home[7 + talos.joint_index("arm_left_4_joint")]
    begin = talos.q_home[7 + talos.joint_index("arm_left_2_joint")]
    np.testing.assert_allclose(elbow - start, 0.5 * (shoulder - begin), atol=1e-9)


@pytest.mark.requirement("S4")
@pytest.mark.parametrize("t_s", [0.402, 0.652])
def test_where_the_acceleration_of_a_path_steps_differences_of_setpoints_keep_the_jerk_limit(
    talos, stance, t_s
):
    smooth = swung(talos, 0.8, 1.2, segments=119)
    v, rng = smooth.v.copy(), np.random.default_rng(119)
    for name in ("arm_left_2_joint", "arm_left_4_joint"):
        v[1:-1, 6 + talos.joint_index(name)] += rng.normal(0.0, 1e-4, 118)
    stepping = TrajectorySampler(dataclasses.replace(smooth, v=v))

    brake = brake_along(StandingRobot(talos, stance), stepping, t_s, PERIOD_S)

    assert brake is not None
    assert not brake.steps
    told = np.vstack([stepping.at(t_s - PERIOD_S).v, stepping.at(t_s).v, brake.rows.v])[:, 6:]
    assert np.abs(np.diff(told, 2, axis=0)).max() / PERIOD_S**2 <= 120.0 * 1.005


def test_a_slow_motion_stops_gently_and_sooner_than_a_fast_one(talos, stance):
    slow = brake_along(StandingRobot(talos, stance), swing(talos, 0.1, 1.2), 0.6, PERIOD_S)
    fast = brake_along(StandingRobot(talos, stance), swing(talos, 0.8, 1.2), 0.6, PERIOD_S)

    assert slow is not None
    assert fast is not None
    assert 0.22 <= len(slow.rows.q) * PERIOD_S <= 0.33
    assert len(slow.rows.q) < len(fast.rows.q)


def test_a_trajectory_that_ends_sooner_than_any_brake_is_left_alone(talos, stance):
    assert brake_along(StandingRobot(talos, stance), swing(talos, 0.8, 1.2), 1.1999, PERIOD_S) is None


triples = arrays(float, 3, elements=st.floats(-2.0, 2.0))


@given(q=triples, v=triples, a=triples)
def test_joints_come_to_rest_within_their_limits_without_a_step(q, v, a):
    qs, vs, accelerations = brake_joints(q, v, a, ACCELERATION, JERK, PERIOD_S)

    assert not vs[-1].any()
    assert (np.abs(accelerations) <= 8.0 + 1e-9).all()
    before = np.vstack([q, qs[:-1]]), np.vstack([v, vs[:-1]])
    np.testing.assert_allclose(qs, before[0] + 0.5 * (before[1] + vs) * PERIOD_S, atol=1e-6)
    assert (np.abs(np.diff(vs, axis=0)) <= 8.0 * PERIOD_S + 1e-9).all()


def test_what_rests_stays(talos, stance):
    qs, vs, _ = brake_joints(np.ones(3), np.zeros(3), np.zeros(3), ACCELERATION, JERK, PERIOD_S)

    np.testing.assert_array_equal(qs[-1], np.ones(3))
    assert not vs.any()


def reaching_down(talos, stance, rng):
    """A motion of pelvis, trunk and an arm, with the feet where they stand."""
    space = FreeCoordinates(StandingRobot(talos, stance))
    start = space.from_q(talos.q_home)
    goal = start.copy()
    goal[:6] += rng.uniform([-0.05, -0.04, -0.15, -0.1, -0.1, -0.1], [0.05, 0.04, -0.03, 0.1, 0.2, 0.1])
    for joint in ("torso_1_joint", "torso_2_joint", "arm_right_2_joint", "arm_right_4_joint"):
        goal[space.index(joint)] += rng.uniform(-0.3, 0.0)
    curve = PolynomialCurve(np.array([start, goal]))
    return space, TrajectorySampler(time_in_balance(StandingRobot(talos, stance), curve, Pace(0.5, 0.7)))


@pytest.mark.parametrize("seed", range(5))
def test_a_stop_of_every_joint_leaves_the_feet_where_they_stand(talos, stance, seed):
    rng = np.random.default_rng(seed)
    _space, sampler = reaching_down(talos, stance, rng)
    now = sampler.at(float(rng.uniform(0.3, 0.6)) * sampler.duration_s)

    rows = brake_standing(StandingRobot(talos, stance), now, PERIOD_S)

    assert rows is not None
    for frame, world_T_sole in stance.soles:
        for q in rows.q[:: max(1, len(rows.q) // 10)]:
            np.testing.assert_allclose(talos.frame_pose(q, frame), world_T_sole, atol=5e-5)
        np.testing.assert_allclose(talos.frame_pose(rows.q[-1], frame), world_T_sole, atol=1e-9)
    assert not rows.v[-1].any()
    assert len(rows.q) * PERIOD_S < 0.7
    v = np.vstack([now.v, rows.v])
    assert (np.abs(np.diff(v[:, 6:], axis=0)) <= talos.acceleration * PERIOD_S * 1.001).all()
    q = np.vstack([now.q, rows.q])
    led = 0.5 * PERIOD_S * (v[1:, 6:] + v[:-1, 6:])
    assert np.abs(np.diff(q[:, 7:], axis=0) - led).max() < 1e-5


def test_a_robot_whose_feet_have_left_the_stance_is_not_braked_as_if_they_had_not(talos, stance):
    _space, sampler = reaching_down(talos, stance, np.random.default_rng(0))
    now = sampler.at(0.5 * sampler.duration_s)
    now.q[7 + talos.joint_index("leg_left_4_joint")] += 0.01

    assert brake_standing(StandingRobot(talos, stance), now, PERIOD_S) is None


@pytest.mark.parametrize("share", [0.05, 0.3, 0.5, 0.7, 0.95])
def test_a_stop_is_found_without_computing_many_brakes(talos, stance, monkeypatch, share):
    """What is computed bounds the time that the first period of a stop takes."""
    rows = []
    many = TrajectorySampler.many
    monkeypatch.setattr(
        TrajectorySampler, "many", lambda self, t, *rest: rows.append(len(t)) or many(self, t, *rest)
    )
    for amount in (0.1, 0.8):
        rows.clear()

        assert (
            brake_along(StandingRobot(talos, stance), swing(talos, amount, 1.2), share * 1.2, PERIOD_S)
            is not None
        )
        assert sum(rows) <= 33 + 4 * 16 + 2 * 200
        assert len(rows) <= 5
