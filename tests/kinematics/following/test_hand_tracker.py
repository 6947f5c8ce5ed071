"""A hand that follows a goal with the whole body."""

import numpy as np
import pytest

from kinematics.following.hand_tracker import TARGET_STEP_M, TICK_S, HandGoal, HandTracker
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import Stance
from kinematics.model.standing_robot import StandingRobot
from robots.models.description import load_description

TIMES = 0.002 * np.arange(1, 6)
UP = np.array([0.0, 0.0, 1.0])


def goal_at(tracker, offset):
    return HandGoal(tracker.tcp_m + offset, tracker.tcp_rotation.copy(), 0.3, UP, np.zeros(2))


def followed(tracker, goal, ticks):
    samples = []
    for _ in range(ticks):
        samples += tracker.tick(goal, TIMES)
    return samples


@pytest.fixture
def tracker(talos, stance):
    return HandTracker(StandingRobot(talos, stance), "left", talos.q_home)


@pytest.mark.parametrize("offset", [(0.15, 0.0, 0.0), (0.0, -0.1, 0.04), (0.1, 0.05, -0.1)])
def test_the_hand_gets_there_and_the_feet_stay(talos, stance, tracker, offset):
    goal = goal_at(tracker, offset)

    samples = followed(tracker, goal, 300)

    assert np.linalg.norm(tracker.tcp_m - goal.position_m) < 1e-3
    for frame, pose in stance.soles:
        assert talos.frame_pose(samples[-1].q, frame) == pytest.approx(pose, abs=1e-6)


@pytest.mark.requirement("S1")
@pytest.mark.parametrize("offset", [(0.2, 0.1, 0.15), (0.0, -0.1, 0.04), (0.1, 0.05, -0.1)])
def test_setpoints_keep_speed_acceleration_and_jerk_and_fit_together(talos, tracker, offset):
    samples = followed(tracker, goal_at(tracker, offset), 60)
    samples += followed(tracker, goal_at(tracker, (-0.1, 0.0, 0.0)), 10)
    samples += followed(tracker, None, 40)
    q = np.array([sample.q[7:] for sample in samples])
    v = np.array([sample.v[6:] for sample in samples])

    leap = np.diff(q, axis=0) - 0.5 * 0.002 * (v[1:] + v[:-1])

    assert np.abs(leap).max() < 1e-5
    assert np.abs(v[:, talos.group("left_arm")]).max() <= 1.0
    assert np.abs(v).max() <= 2.0
    a = np.diff(v, axis=0) / 0.002
    assert (np.abs(a) <= talos.acceleration).all()
    assert (np.abs(np.diff(a, axis=0)) / 0.002 <= talos.jerk).all()


def test_a_goal_that_jumps_is_followed_step_by_step(tracker):
    start = tracker.followed_m.copy()

    tracker.tick(goal_at(tracker, (0.5, 0.0, 0.0)), TIMES)

    assert np.linalg.norm(tracker.followed_m - start) <= TARGET_STEP_M + 1e-12


def test_without_a_goal_it_comes_to_rest_at_once(tracker):
    followed(tracker, goal_at(tracker, (0.2, 0.0, 0.0)), 20)
    assert not tracker.at_rest

    followed(tracker, None, round(0.35 / TICK_S))

    assert tracker.at_rest


def test_the_centre_of_mass_goes_where_it_is_wanted(talos, tracker):
    here = tracker.tcp_m.copy()
    goal = HandGoal(here, tracker.tcp_rotation.copy(), 0.3, UP, np.array([-0.03, 0.0]))

    samples = followed(tracker, goal, 250)

    assert talos.com(samples[-1].q)[0] == pytest.approx(-0.005 - 0.03, abs=0.008)
    assert np.linalg.norm(tracker.tcp_m - here) < 2e-3


def test_a_welded_arm_follows_with_its_joints_alone():
    panda = RobotModel(load_description("panda"))
    tracker = HandTracker(StandingRobot(panda, Stance(())), "right", panda.q_home)
    goal = goal_at(tracker, (0.1, 0.08, -0.1))

    samples = followed(tracker, goal, 300)

    assert np.linalg.norm(tracker.tcp_m - goal.position_m) < 1e-3
    assert all(np.array_equal(sample.q[:7], panda.q_home[:7]) for sample in samples)
    assert not any(sample.v[:6].any() for sample in samples)
