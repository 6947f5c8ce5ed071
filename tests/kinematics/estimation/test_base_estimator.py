import numpy as np
import pytest

from kinematics.errors import KinematicsError
from kinematics.estimation.base_estimator import BaseEstimator
from kinematics.geometry import poses
from kinematics.model.stance import Stance
from kinematics.model.standing_robot import StandingRobot
from robots.models.description import load_robot

HARDWARE = load_robot("talos").hardware

PERIOD_S = 0.002


class Walkthrough:
    """Makes the readings of a base that moves as told, with the soles of the stance under it."""

    def __init__(self, model, stance, rng=None):
        self.model, self.stance = model, stance
        self.estimator = BaseEstimator(StandingRobot(model, stance))
        self.rng = rng
        self.stamp_s = 0.0
        self.last_imu = None
        self.loads = (450.0, 450.0)
        self.gyro_bias = np.zeros(3)

    def read(self, joints, turn=None):
        """One update; ``turn`` tips soles, base and all about the odometry frame's origin."""
        turn = np.eye(3) if turn is None else turn
        named = dict(zip(self.model.joints, joints, strict=True))
        q = self.model.on_the_floor(named)
        imu = turn @ self.model.frame_pose(q, self.model.description.imu_link)[:3, :3]
        last = imu if self.last_imu is None else self.last_imu
        gyro = poses.vector_from_rotation(last.T @ imu) / PERIOD_S + self.gyro_bias
        accelerometer = imu.T @ (0.0, 0.0, 9.81)
        measured = np.array(joints)
        wrench = np.zeros((2, 6))
        wrench[:, 2] = self.loads
        if self.rng is not None:
            noise = HARDWARE.noise
            measured += self.rng.normal(0.0, noise.joint_position_rad, measured.shape)
            gyro = gyro + self.rng.normal(0.0, noise.gyro_rad_s, 3)
            accelerometer = accelerometer + self.rng.normal(0.0, noise.accelerometer_m_s2, 3)
            wrench += self.rng.normal(0.0, noise.foot_force_n, wrench.shape)
        self.last_imu = imu
        self.estimator.update(self.stamp_s, measured, gyro, accelerometer, wrench)
        estimate = self.estimator.configuration(measured, wrench, self.estimator.tilt_rad)
        self.stamp_s += PERIOD_S
        true = q.copy()
        true[:3] = turn @ q[:3]
        true[3:7] = poses.quaternion_from_rotation(turn @ poses.rotation_from_quaternion(q[3:7]))
        return estimate, true

    def hold(self, joints, seconds, turn=None):
        for _ in range(round(seconds / PERIOD_S)):
            estimate, true = self.read(joints, turn)
        return estimate, true


def error(estimate, true):
    away = poses.rotation_from_quaternion(true[3:7]).T @ poses.rotation_from_quaternion(estimate[3:7])
    turned = poses.vector_from_rotation(away)
    return np.linalg.norm(estimate[:3] - true[:3]), np.linalg.norm(turned)


@pytest.fixture
def walkthrough(talos, stance):
    return lambda rng=None: Walkthrough(talos, stance, rng)


def test_flat_soles_and_exact_readings_give_the_exact_base(walkthrough, talos):
    estimate, true = walkthrough().hold(talos.q_home[7:], 0.1)

    np.testing.assert_allclose(estimate, true, atol=1e-9)


def test_with_the_noise_of_the_described_sensors_it_is_good_to_a_millimetre(walkthrough, talos):
    walk = walkthrough(np.random.default_rng(1))
    errors = [error(*walk.read(talos.q_home[7:])) for _ in range(1500)]

    position, angle = np.max(errors[100:], axis=0)
    assert position < 1e-3
    assert angle < 1e-3


def test_a_moving_torso_is_not_taken_for_a_tipping_base(walkthrough, talos):
    walk = walkthrough()
    torso, worst = talos.joint_index("torso_2_joint"), 0.0
    for k in range(1000):
        joints = talos.q_home[7:].copy()
        joints[torso] += 0.2 * np.sin(np.pi * k * PERIOD_S) ** 2
        worst = max(worst, *error(*walk.read(joints)))

    assert worst < 5e-4


def test_a_quick_tip_of_the_soles_that_no_encoder_sees_is_seen_by_the_gyro(walkthrough, talos):
    walk = walkthrough()
    walk.hold(talos.q_home[7:], 0.2)
    for k in range(1, 51):  # 20 mrad in 0.1 s
        estimate, true = walk.read(talos.q_home[7:], poses.rotation_y(0.02 * k / 50))

    assert error(estimate, true)[1] < 0.004
    assert estimate[0] > walk.model.q_home[0] + 0.012  # the base went ahead with the tip


def test_the_accelerometer_shows_what_lasts_in_its_own_figure(walkthrough, talos):
    walk = walkthrough()
    walk.hold(talos.q_home[7:], 6.0, turn=poses.rotation_y(0.01))

    assert walk.estimator.gravity_tilt_rad[1] == pytest.approx(0.01, abs=5e-4)
    assert walk.estimator.gravity_tilt_rad[0] == pytest.approx(0.0, abs=5e-4)


def test_with_no_sole_carrying_the_accelerometer_is_believed(walkthrough, talos):
    walk = walkthrough()
    walk.loads = (0.0, 0.0)
    estimate, true = walk.hold(talos.q_home[7:], 6.0, turn=poses.rotation_y(0.01))

    assert walk.estimator.carrying == [False, False]
    assert error(estimate, true)[1] < 1e-3


def test_a_gyro_bias_stays_a_milliradian(walkthrough, talos):
    walk = walkthrough()
    walk.gyro_bias = np.array([0.003, -0.003, 0.003])
    estimate, true = walk.hold(talos.q_home[7:], 5.0)

    assert error(estimate, true)[1] < 2e-3


def test_the_unloaded_foot_has_no_say(walkthrough, talos):
    walk = walkthrough()
    walk.loads = (900.0, 0.0)
    lifted = talos.q_home[7:].copy()
    lifted[talos.joint_index("leg_right_4_joint")] += 0.3
    estimate, _ = walk.read(lifted)

    assert walk.estimator.carrying == [True, False]
    np.testing.assert_allclose(estimate[:3], talos.q_home[:3], atol=1e-9)


def test_each_estimate_is_a_value_of_its_own(walkthrough, talos):
    walk = walkthrough()
    first, _ = walk.read(talos.q_home[7:])
    kept = first.copy()
    walk.read(talos.q_home[7:] + 0.01)

    np.testing.assert_array_equal(first, kept)


def test_a_stance_without_soles_cannot_be_estimated_from(talos):
    with pytest.raises(KinematicsError, match="without a sole"):
        BaseEstimator(StandingRobot(talos, Stance(())))
