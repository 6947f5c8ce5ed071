import numpy as np
import pinocchio as pin
import pytest

from kinematics.dynamics.sole_shares import SoleShares
from kinematics.dynamics.standing_dynamics import StandingDynamics
from kinematics.model.stance import Stance, stance_at
from kinematics.model.standing_robot import StandingRobot


def by_frame_jacobians(model, q, stance):
    """Holding efforts by each sole's Jacobian at the world's origin, and the soles' wrenches there."""
    data = model.pin.createData()
    gravity = pin.computeGeneralizedGravity(model.pin, data, q).copy()
    pin.computeJointJacobians(model.pin, data, q)
    pin.updateFramePlacements(model.pin, data)
    net = data.oMi[1].toDualActionMatrix() @ gravity[:6]
    wrenches = SoleShares(stance, model.description.soles).wrenches(net)
    efforts = gravity.copy()
    for (frame, _), wrench in zip(stance.soles, wrenches.reshape(-1, 6), strict=True):
        J = pin.getFrameJacobian(model.pin, data, model.frame_id(frame), pin.WORLD)
        efforts -= J.T @ wrench
    return efforts, wrenches


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

        efforts = StandingDynamics(StandingRobot(talos, stance)).holding_efforts(q)

        expected, _ = by_frame_jacobians(talos, q, stance)
        np.testing.assert_allclose(efforts, expected[6:], atol=1e-9)
        np.testing.assert_allclose(expected[:6], 0.0, atol=1e-9)  # the soles carry all of it


def test_on_one_foot_the_other_leg_only_hangs(talos):
    q = talos.q_home
    left_only = Stance(stance_at(talos, q).soles[:1])

    efforts = StandingDynamics(StandingRobot(talos, left_only)).holding_efforts(q)

    expected, wrench = by_frame_jacobians(talos, q, left_only)
    np.testing.assert_allclose(efforts, expected[6:], atol=1e-9)
    assert wrench[2] == pytest.approx(talos.mass_kg * 9.81)


def test_the_home_posture_asks_for_a_fraction_of_each_joint(talos, stance):
    efforts = StandingDynamics(StandingRobot(talos, stance)).holding_efforts(talos.q_home)

    assert (np.abs(efforts) < 0.5 * talos.effort).all()


def test_the_efforts_of_a_motion_do_the_work_that_the_energy_takes(talos, stance):
    # With fixed feet the ground does no work, so efforts times speeds is the change of energy.
    q, v, a = talos.q_home.copy(), np.zeros(talos.nv), np.zeros(talos.nv)
    arm = 6 + talos.group("left_arm")
    v[arm] = np.linspace(0.2, 0.8, 7)
    a[arm] = np.linspace(-2.0, 1.0, 7)
    armature = np.array([talos.description.armature[name] for name in talos.joints])
    data, step = talos.pin.createData(), 1e-6

    def energy(t):
        moved = pin.integrate(talos.pin, q, v * t + 0.5 * a * t * t)
        speed = v + a * t
        kinetic = pin.computeKineticEnergy(talos.pin, data, moved, speed)
        return kinetic + pin.computePotentialEnergy(talos.pin, data, moved) + 0.5 * armature @ speed[6:] ** 2

    power = StandingDynamics(StandingRobot(talos, stance)).efforts(q, v, a) @ v[6:]

    assert power == pytest.approx((energy(step) - energy(-step)) / (2 * step), rel=1e-5)


def test_an_answer_is_not_overwritten_by_the_next(talos, stance):
    dynamics = StandingDynamics(StandingRobot(talos, stance))
    first = dynamics.holding_efforts(talos.q_home)
    kept = first.copy()
    other = talos.q_home.copy()
    other[25] += 0.4

    assert not np.array_equal(dynamics.holding_efforts(other), kept)
    np.testing.assert_array_equal(first, kept)
