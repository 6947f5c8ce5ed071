"""Stops where a path leaves no room for a brake, and stops after which the legs have to be put right."""

import numpy as np
import pytest

from kinematics.model.stance import stance_at
from kinematics.model.standing_robot import StandingRobot
from kinematics.motion.curves import RoundedPolyline
from kinematics.motion.sampler import TrajectorySampler
from kinematics.motion.verdict import SETPOINT_FRACTION
from kinematics.standing.free_coordinates import free_coordinates
from kinematics.timing.balanced_timing import time_in_balance
from kinematics.timing.curve_timing import Pace
from robots.control.streaming.body_track import BodyTrack
from robots.control.streaming.stop_profile import StopProfile
from tests.kinematics.swings import swing

PERIOD_S = 0.002
BEHIND_RAD = 1e-6
"""By so much at least a motion that is braked is behind where it would have been after 20 ms."""
STEPPING_S = 0.31
"""Here an even brake is soon enough, and its setpoints leave a jerk limit."""
GATHERING_S = 0.43
"""Here the motion below gathers speed as hard as it may."""


@pytest.fixture(scope="module")
def stance(talos):
    return stance_at(talos, talos.q_home)


@pytest.fixture(scope="module", name="corner")
def corner_fixture(talos, stance):
    """An arm and the trunk, around a corner."""
    space, rng = free_coordinates(StandingRobot(talos, stance)), np.random.default_rng(3)
    start = space.from_q(talos.q_home)
    goal = start.copy()
    for joint in talos.description.groups["right_arm"] + talos.description.groups["torso"]:
        goal[space.index(joint)] += rng.uniform(-1.0, 1.0) * (0.25 if "torso" in joint else 1.0)
    goal[:3] += rng.uniform(-0.03, 0.03, 3)
    moved = np.abs(goal - start) > 1e-9
    corner = 0.5 * (start + goal) + rng.uniform(-0.15, 0.15, len(goal)) * moved
    curve = RoundedPolyline(np.stack([start, corner, goal]), space.weights, 0.3)
    return time_in_balance(StandingRobot(talos, stance), curve, Pace(0.8, 1.0))


@pytest.fixture(scope="module")
def sampler(corner):
    return TrajectorySampler(corner)


def rows_of(profile):
    rows = [profile.at(k) for k in range(len(profile))]
    return tuple(np.array([getattr(row, name) for row in rows]) for name in "qva")


def require_limits_kept(talos, now, a):
    assert (np.abs(a[:, 6:]) <= talos.acceleration * 1.005).all()
    jerk = np.diff(np.vstack([now.a, a])[:, 6:], axis=0) / PERIOD_S
    assert (np.abs(jerk) <= talos.jerk * 1.01).all()


def require_feet_in_place(talos, stance, q):
    for frame, world_T_sole in stance.soles:
        np.testing.assert_allclose(talos.frame_pose(q, frame), world_T_sole, atol=1e-9)


@pytest.mark.requirement("S4")
def test_a_path_that_gathers_speed_too_hard_is_braked_along_a_moment_later(talos, stance, sampler):
    of = StandingRobot(talos, stance), sampler, GATHERING_S, PERIOD_S
    assert StopProfile.along_path(*of) is None

    profile = StopProfile.soon_along_path(*of)

    q, v, a = rows_of(profile)
    assert len(profile) * PERIOD_S <= 0.45
    np.testing.assert_allclose(q[:10], sampler.many(GATHERING_S + PERIOD_S * np.arange(1, 11)).q, atol=1e-5)
    assert not v[-1].any()
    require_limits_kept(talos, sampler.at(GATHERING_S), a)
    require_feet_in_place(talos, stance, q[-1])


@pytest.mark.requirement("S4")
@pytest.mark.parametrize("t_s", [0.3, GATHERING_S, 0.7])
def test_joints_that_stop_each_on_its_own_end_where_a_motion_can_begin(talos, stance, sampler, t_s):
    now = sampler.at(t_s)

    profile = StopProfile.joint_by_joint(StandingRobot(talos, stance), now, PERIOD_S)

    q, v, a = rows_of(profile)
    assert len(profile) * PERIOD_S < 0.5
    assert not v[-1].any()
    require_limits_kept(talos, now, a)
    require_feet_in_place(talos, stance, q[-1])
    assert np.abs(np.diff(q[:, 7:], axis=0) - PERIOD_S * v[1:, 6:]).max() < 1e-4


@pytest.fixture(scope="module", name="swing")
def swing_fixture(talos, stance):
    return swing(talos, stance)


def braked(talos, stance, swing, t_s):
    """Configurations of a stop along the path after some time of a motion, one a period."""
    track = BodyTrack(StandingRobot(talos, stance), talos.q_home, PERIOD_S)
    track.play(swing)
    for _ in range(round(t_s / PERIOD_S)):
        track.propose()
        track.commit()
    track.brake(along_path=True)
    rows = []
    while not track.resting:
        rows.append(track.propose().q)
        track.commit()
    return rows


@pytest.mark.requirement("S4")
@pytest.mark.parametrize("t_s", [0.3, 0.36, 1.02])
def test_a_stop_before_a_turn_of_the_path_is_soon_and_keeps_to_the_path(talos, stance, swing, t_s):
    # With one even slope it would take 0.46 to 0.6 s; a stop may take half a second.
    sampler = TrajectorySampler(swing)
    assert StopProfile.along_path(StandingRobot(talos, stance), sampler, t_s, PERIOD_S).is_late(PERIOD_S)

    rows = braked(talos, stance, swing, t_s)

    way = sampler.many(np.arange(t_s, t_s + 0.5, PERIOD_S)).q
    assert max(np.abs(way - q).max(axis=1).min() for q in rows) < 2e-3
    assert len(rows) * PERIOD_S <= 0.45
    assert np.abs(rows[9] - sampler.at(t_s + 10 * PERIOD_S).q).max() > BEHIND_RAD


@pytest.mark.requirement("S4")
def test_a_fast_swing_can_be_stopped_soon_at_every_instant(talos, stance, swing):
    for t_s in np.arange(0.02, swing.t_s[-1], 0.03):
        assert len(braked(talos, stance, swing, t_s)) * PERIOD_S <= 0.45, t_s


def stopped(talos, stance, trajectory, t_s, along_path):
    """Speeds of the setpoints from one period before a stop until it rests, one row a period."""
    track = BodyTrack(StandingRobot(talos, stance), trajectory.q[0], PERIOD_S)
    track.play(trajectory)
    speeds = [track.now.v]
    while len(speeds) * PERIOD_S <= t_s or not track.resting:
        if len(speeds) == round(t_s / PERIOD_S):
            track.brake(along_path)
        track.propose()
        track.commit()
        speeds.append(track.now.v)
    return np.array(speeds[round(t_s / PERIOD_S) - 2 :])


@pytest.mark.requirement("S4")
@pytest.mark.parametrize("along_path", [True, False])
def test_a_stop_keeps_the_jerk_that_the_setpoints_show(talos, stance, swing, along_path):
    # A trajectory's acceleration steps at its samples, and a stop may begin right after such a step.
    for t_s in np.arange(0.05, swing.t_s[-1], 0.02):
        v = stopped(talos, stance, swing, t_s, along_path)[:, 6:]
        jerk = np.diff(v, 2, axis=0) / PERIOD_S**2
        assert (np.abs(jerk) <= talos.jerk * (1.0 + SETPOINT_FRACTION)).all(), t_s


@pytest.mark.requirement("S4")
def test_where_the_even_brake_steps_a_prompt_one_that_does_not_is_taken(talos, stance, corner, sampler):
    even = StopProfile.along_path(StandingRobot(talos, stance), sampler, STEPPING_S, PERIOD_S)
    assert even.steps
    assert not even.is_late(PERIOD_S)

    v = stopped(talos, stance, corner, STEPPING_S, along_path=True)[:, 6:]

    assert (np.abs(np.diff(v, 2, axis=0)) <= talos.jerk * (1.0 + SETPOINT_FRACTION) * PERIOD_S**2).all()


@pytest.mark.requirement("S4")
@pytest.mark.parametrize("t_s", [0.3, GATHERING_S, 0.7])
def test_joints_that_stop_each_on_its_own_rest_once(talos, stance, sampler, t_s):
    _, v, _ = rows_of(StopProfile.joint_by_joint(StandingRobot(talos, stance), sampler.at(t_s), PERIOD_S))

    assert np.abs(v[:-1]).max(axis=1).min() > 0.0


@pytest.mark.requirement("S4")
def test_where_the_legs_cannot_stop_at_once_the_path_is_braked_along(talos, stance, swing, monkeypatch):
    monkeypatch.setattr(StopProfile, "standing", lambda *_: None)
    track = BodyTrack(StandingRobot(talos, stance), talos.q_home, PERIOD_S)
    track.play(swing)
    for _ in range(180):
        track.propose()
        track.commit()

    track.brake(along_path=False)

    way = TrajectorySampler(swing).many(np.arange(0.36, 0.9, PERIOD_S)).q
    rows = []
    while not track.resting:
        rows.append(track.propose().q)
        track.commit()
    assert len(rows) * PERIOD_S <= 0.45
    assert max(np.abs(way - q).max(axis=1).min() for q in rows) < 2e-3
