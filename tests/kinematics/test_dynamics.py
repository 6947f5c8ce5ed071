import numpy as np
import pinocchio as pin
import pytest

from kinematics.dynamics import StandingDynamics
from kinematics.stance import stance_at
from kinematics.trajectory import Stance


def by_frame_jacobians(model, q, frames):
    """Holding efforts with each sole's wrench in its own frame and a fresh pseudo-inverse."""
    data = model.pin.createData()
    gravity = pin.computeGeneralizedGravity(model.pin, data, q).copy()
    pin.computeJointJacobians(model.pin, data, q)
    pin.updateFramePlacements(model.pin, data)
    J = np.vstack(
        [pin.getFrameJacobian(model.pin, data, model.frame_id(f), pin.LOCAL_WORLD_ALIGNED) for f in frames]
    )
    W = np.diag([1, 1, 1, 0.1, 0.1, 0.1] * len(frames))
    wrench = W @ np.linalg.pinv(J[:, :6].T @ W) @ gravity[:6]
    return (gravity - J.T @ wrench)[6:], wrench


@pytest.fixture
def postures(talos):
    rng = np.random.default_rng(4)
    lower, upper = talos.lower_rad, talos.upper_rad
    postures = [talos.q_home]
    for _ in range(5):
        joints = talos.q_home[7:] + 0.3 * rng.uniform(-1, 1, len(talos.joints))
        joints[:12] = talos.q_home[7:19]
        named = dict(zip(talos.joints, np.clip(joints, lower, upper), strict=True))
        postures.append(talos.on_the_floor(named))
    return postures


def test_holding_efforts_are_those_of_the_textbook(talos, postures):
    for q in postures:
        stance = stance_at(talos, q)
        frames = [frame for frame, _ in stance.soles]

        efforts = StandingDynamics(talos, stance).holding_efforts(q)

        np.testing.assert_allclose(efforts, by_frame_jacobians(talos, q, frames)[0], atol=1e-9)


def test_on_one_foot_the_other_leg_only_hangs(talos):
    q = talos.q_home
    left_only = Stance(stance_at(talos, q).soles[:1])

    efforts = StandingDynamics(talos, left_only).holding_efforts(q)

    expected, wrench = by_frame_jacobians(talos, q, ["left_sole_link"])
    np.testing.assert_allclose(efforts, expected, atol=1e-9)
    assert wrench[2] == pytest.approx(talos.mass_kg * 9.81)


def test_the_home_posture_asks_for_a_fraction_of_each_joint(talos, stance):
    efforts = StandingDynamics(talos, stance).holding_efforts(talos.q_home)

    assert (np.abs(efforts) < 0.5 * talos.effort).all()


def test_the_efforts_of_a_motion_do_the_work_that_the_energy_takes(talos, stance):
    # With fixed feet the ground does no work, so efforts times speeds is the change of energy.
    q, v, a = talos.q_home.copy(), np.zeros(talos.nv), np.zeros(talos.nv)
    arm = 6 + talos.group("left_arm")
    v[arm] = np.linspace(0.2, 0.8, 7)
    a[arm] = np.linspace(-2.0, 1.0, 7)
    armature = np.array([talos.description.gains[name].armature for name in talos.joints])
    data, step = talos.pin.createData(), 1e-6

    def energy(t):
        moved = pin.integrate(talos.pin, q, v * t + 0.5 * a * t * t)
        speed = v + a * t
        kinetic = pin.computeKineticEnergy(talos.pin, data, moved, speed)
        return kinetic + pin.computePotentialEnergy(talos.pin, data, moved) + 0.5 * armature @ speed[6:] ** 2

    power = StandingDynamics(talos, stance).efforts(q, v, a) @ v[6:]

    assert power == pytest.approx((energy(step) - energy(-step)) / (2 * step), rel=1e-5)


def test_an_answer_is_not_overwritten_by_the_next(talos, stance):
    dynamics = StandingDynamics(talos, stance)
    first = dynamics.holding_efforts(talos.q_home)
    kept = first.copy()
    other = talos.q_home.copy()
    other[25] += 0.4

    assert not np.array_equal(dynamics.holding_efforts(other), kept)
    np.testing.assert_array_equal(first, kept)
