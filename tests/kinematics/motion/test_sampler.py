import numpy as np
import pytest
from scipy.interpolate import CubicHermiteSpline

from kinematics.geometry import poses
from kinematics.model.stance import stance_at
from kinematics.motion.sampler import TrajectorySampler
from kinematics.motion.trajectory import Trajectory


@pytest.fixture
def swaying(talos):
    """Joints and base moving at once, sampled unevenly."""
    t = np.array([0.0, 0.07, 0.1, 0.22, 0.3, 0.41, 0.5])
    rng = np.random.default_rng(2)
    n = len(t)
    q = np.repeat(talos.q_home[None], n, axis=0)
    q[:, 7:] += 0.05 * rng.normal(size=(n, len(talos.joints)))
    q[:, :3] += 0.01 * rng.normal(size=(n, 3))
    for k in range(n):
        q[k, 3:7] = poses.quaternion_from_rotation(poses.rotation_from_vector(0.1 * rng.normal(size=3)))
    q[3, 3:7] *= -1.0  # the same orientation, written the other way
    v = 0.3 * rng.normal(size=(n, talos.nv))
    return Trajectory(talos.joints, stance_at(talos, talos.q_home), t, q, v)


TIMES = np.linspace(0.0, 0.5, 47)


def test_joints_follow_the_hermite_polynomials_of_an_independent_library(swaying):
    sampler = TrajectorySampler(swaying)
    spline = CubicHermiteSpline(swaying.t_s, swaying.q[:, 7:], swaying.v[:, 6:])

    for t in TIMES[:-1]:
        sample = sampler.at(t)
        np.testing.assert_allclose(sample.q[7:], spline(t), atol=1e-12)
        np.testing.assert_allclose(sample.v[6:], spline(t, 1), atol=1e-10)
        np.testing.assert_allclose(sample.a[6:], spline(t, 2), atol=1e-8)


def test_the_base_passes_through_its_samples_and_moves_as_its_twist_says(swaying):
    sampler = TrajectorySampler(swaying)
    world = np.array(
        [poses.rotation_from_quaternion(q[3:7]) @ v[:3] for q, v in zip(swaying.q, swaying.v, strict=True)]
    )
    spline = CubicHermiteSpline(swaying.t_s, swaying.q[:, :3], world)

    for t in TIMES[:-1]:
        sample = sampler.at(t)
        rotation = poses.rotation_from_quaternion(sample.q[3:7])
        np.testing.assert_allclose(sample.q[:3], spline(t), atol=1e-12)
        np.testing.assert_allclose(rotation @ sample.v[:3], spline(t, 1), atol=1e-10)
        assert np.linalg.norm(sample.q[3:7]) == pytest.approx(1.0)
    for t, q in zip(swaying.t_s, swaying.q, strict=True):
        turned = poses.rotation_from_quaternion(q[3:7])
        np.testing.assert_allclose(poses.rotation_from_quaternion(sampler.at(t).q[3:7]), turned, atol=1e-12)


def test_many_times_at_once_give_what_each_gives_alone(swaying):
    sampler = TrajectorySampler(swaying)
    rate, slope = np.linspace(1.0, 0.2, len(TIMES)), np.full(len(TIMES), -2.0)

    together = sampler.many(TIMES, rate, slope)

    for k, t in enumerate(TIMES):
        alone = sampler.at(t, rate[k], slope[k])
        np.testing.assert_allclose(together.q[k], alone.q, atol=1e-12)
        np.testing.assert_allclose(together.v[k], alone.v, atol=1e-12)
        np.testing.assert_allclose(together.a[k], alone.a, atol=1e-9)


def test_times_outside_are_those_of_the_ends_and_may_come_in_any_order(swaying):
    sampler = TrajectorySampler(swaying)

    np.testing.assert_allclose(sampler.at(9.0).q[7:], swaying.q[-1, 7:], atol=1e-12)
    np.testing.assert_allclose(sampler.at(-1.0).q[7:], swaying.q[0, 7:], atol=1e-12)


def test_a_slower_clock_scales_speeds_and_accelerations(swaying):
    sampler = TrajectorySampler(swaying)
    full, half = sampler.at(0.2), sampler.at(0.2, 0.5, 0.0)

    np.testing.assert_allclose(half.v[6:], 0.5 * full.v[6:])
    np.testing.assert_allclose(half.a[6:], 0.25 * full.a[6:])


def test_the_acceleration_of_a_turning_base_is_the_change_of_its_twist(talos):
    # On a circle of 1 m at 1 rad/s the base's own velocity is steady while it speeds up along it.
    t = np.linspace(0.0, 0.5, 51)
    angle = t + 0.5 * t * t
    q, v = np.repeat(talos.q_home[None], len(t), axis=0), np.zeros((len(t), talos.nv))
    q[:, 0], q[:, 1] = np.cos(angle), np.sin(angle)
    q[:, 5], q[:, 6] = np.sin(angle / 2), np.cos(angle / 2)
    v[:, 1] = v[:, 5] = 1.0 + t
    sampler = TrajectorySampler(Trajectory(talos.joints, stance_at(talos, talos.q_home), t, q, v))

    for moment in (0.105, 0.275, 0.425):
        np.testing.assert_allclose(sampler.at(moment).v[:6], (0, 1 + moment, 0, 0, 0, 1 + moment), atol=1e-4)
        np.testing.assert_allclose(sampler.at(moment).a[:6], (0, 1, 0, 0, 0, 1), atol=5e-3)
