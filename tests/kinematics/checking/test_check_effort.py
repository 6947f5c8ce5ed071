from dataclasses import replace

import numpy as np
import pytest

from kinematics.checking.compiled_kinematics import CompiledKinematics
from kinematics.checking.dynamics import DynamicsCheck
from kinematics.checking.kinematics import BatchedKinematics
from kinematics.checking.limits import limit_findings
from kinematics.checking.settings import DEFAULT_SETTINGS
from kinematics.checking.timeline import Timeline
from kinematics.geometry import poses
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import Stance
from kinematics.model.standing_robot import StandingRobot
from kinematics.motion.curves import PolynomialCurve
from kinematics.motion.trajectory import Trajectory
from kinematics.standing.free_coordinates import free_coordinates
from kinematics.timing.curve_timing import Pace, time_curve


def hasty(talos, stance, seed):
    """A motion of the whole body at random, within all limits."""
    rng = np.random.default_rng(seed)
    space = free_coordinates(StandingRobot(talos, stance))
    ends = np.repeat(space.from_q(talos.q_home)[None], 2, axis=0)
    ends[1, :6] += rng.uniform(-0.04, 0.02, 6)
    ends[1, 6:] += rng.uniform(-0.2, 0.2, space.size - 6)
    columns = talos.indices(space.joints)
    ends[1, 6:] = np.clip(ends[1, 6:], talos.lower_rad[columns] + 0.01, talos.upper_rad[columns] - 0.01)
    return time_curve(StandingRobot(talos, stance), PolynomialCurve(ends), Pace())


@pytest.mark.parametrize("seed", range(3))
def test_compiled_balance_and_effort_are_those_by_pinocchios_inverse_dynamics(talos, stance, seed):
    trajectory = hasty(talos, stance, seed)
    timeline = Timeline(trajectory)
    at = timeline.at(timeline.knots(0.02))
    compiled, plain = CompiledKinematics(talos), BatchedKinematics(talos)

    ours = DynamicsCheck(talos, compiled, DEFAULT_SETTINGS, compiled.loads)
    theirs = DynamicsCheck(talos, plain, DEFAULT_SETTINGS)

    for one, other in zip(
        ours._torques_and_zmp(trajectory, at, compiled.poses(at)),
        theirs._torques_and_zmp(trajectory, at, plain.poses(at)),
        strict=True,
    ):
        np.testing.assert_allclose(one, other, atol=1e-8)


def judged(talos, trajectory, is_compiled):
    """Torques, shape (n, joints), and ZMP, shape (n, 2), at the checker's instants."""
    kinematics = (CompiledKinematics if is_compiled else BatchedKinematics)(talos)
    loads = kinematics.loads if is_compiled else None
    timeline = Timeline(trajectory)
    at = timeline.at(timeline.knots(0.02))
    check = DynamicsCheck(talos, kinematics, DEFAULT_SETTINGS, loads)
    return at, *check._torques_and_zmp(trajectory, at, kinematics.poses(at))


@pytest.mark.parametrize("is_compiled", [True, False])
def test_a_motion_on_a_platform_is_judged_as_it_is_on_the_floor(talos, stance, is_compiled):
    low = hasty(talos, stance, 1)
    raised = Stance(tuple((frame, poses.translation(0.0, 0.0, 0.1) @ pose) for frame, pose in stance.soles))
    high = replace(low, stance=raised, q=low.q + np.eye(talos.nq)[2] * 0.1)

    _, torques, zmp = judged(talos, low, is_compiled)
    _, torques_up, zmp_up = judged(talos, high, is_compiled)

    np.testing.assert_allclose(zmp_up, zmp, atol=1e-9)
    np.testing.assert_allclose(torques_up, torques, atol=1e-7)


@pytest.mark.parametrize("is_compiled", [True, False])
def test_what_turns_the_rotors_is_in_the_judged_efforts(talos, stance, is_compiled):
    trajectory = hasty(talos, stance, 1)
    light = dict.fromkeys(talos.description.armature, 0.0)
    without = RobotModel(replace(talos.description, armature=light))

    at, torques, _ = judged(talos, trajectory, is_compiled)
    _, without_rotors, _ = judged(without, trajectory, is_compiled)

    joint = int(np.argmax(np.abs(torques - without_rotors).max(axis=0)))
    window = DEFAULT_SETTINGS.acceleration_window_s
    t = np.clip(np.stack([at.t_s - window, at.t_s + window]), 0.0, trajectory.duration_s)
    before, after = (np.interp(row, trajectory.t_s, trajectory.v[:, 6 + joint]) for row in t)
    armature = talos.description.armature[talos.joints[joint]]
    wanted = armature * (after - before) / (t[1] - t[0])
    assert np.abs(wanted).max() > 0.1
    np.testing.assert_allclose(torques[:, joint] - without_rotors[:, joint], wanted, atol=1e-7)


def with_one_number_changed(trajectory, rng):
    q, v = trajectory.q.copy(), trajectory.v.copy()
    row, joint = rng.integers(1, len(q) - 1), rng.integers(q.shape[1] - 7)
    size = 10.0 ** rng.uniform(-7.0, 1.0) * rng.choice([-1.0, 1.0])
    if rng.integers(2):
        q[row, 7 + joint] += size
    else:
        v[row, 6 + joint] += size
    return Trajectory(trajectory.joints, trajectory.stance, trajectory.t_s, q, v)


def test_what_is_called_plainly_within_limits_has_no_findings(talos, stance):
    rng = np.random.default_rng(5)
    motions = [hasty(talos, stance, seed) for seed in range(3)]
    within = beyond = missed = 0
    for number in range(300):
        trajectory = with_one_number_changed(motions[number % 3], rng)
        timeline = Timeline(trajectory)
        plain = CompiledKinematics.keeps_limits(talos, timeline, DEFAULT_SETTINGS)
        findings = limit_findings(talos, timeline, DEFAULT_SETTINGS)

        assert not (plain and findings)
        within += plain
        beyond += bool(findings)
        missed += not plain and not findings
    assert within > 50
    assert beyond > 50
    assert missed < 10


def test_a_number_that_is_none_is_not_within_limits(talos, stance):
    timeline = Timeline(hasty(talos, stance, 0))
    timeline.joint_velocity = timeline.joint_velocity.copy()
    timeline.joint_velocity[5, 3] = np.nan

    assert not CompiledKinematics.keeps_limits(talos, timeline, DEFAULT_SETTINGS)
