"""The simulated body seen through its sensors and moved by its servos."""

from dataclasses import replace

import numpy as np
import pytest

from kinematics.errors import InvalidArrayError
from kinematics.geometry import poses
from robots.errors import SetpointRefusedError
from robots.interface.hardware import RobotData
from robots.interface.robot import JointSetpoint
from robots.models.description import load_robot
from robots.scenes.scene_description import RobotStart, SceneDescription
from robots.scenes.scene_file import load_scene
from robots.simulated.world import build_world

HARDWARE = load_robot("talos").hardware

EMPTY = SceneDescription("empty")


@pytest.fixture(scope="module")
def standing(robot_model, stand_class):
    """Readings and truth of 2 s of standing, after 1 s to settle."""
    stand = stand_class(robot_model, EMPTY)
    stand.run(1.0)
    readings, truth = [], []
    for _ in range(1000):
        stand.step()
        readings.append(stand.robot.read())
        truth.append(stand.truth.joint_positions())
    return stand, readings, np.array(truth)


def setpoint(robot, q=None, **changes):
    n = len(robot.description.actuated)
    home = np.array([robot.description.home[name] for name in robot.description.actuated])
    values = {"stamp_s": 0.0, "sequence": 1, "owner": "test", "q": home, "v": np.zeros(n), "tau": np.zeros(n)}
    return JointSetpoint(**{**values, **({} if q is None else {"q": q}), **changes})


@pytest.mark.requirement("M1")
def test_the_robot_stands_free_for_five_seconds(stand):
    body = stand(EMPTY)
    start = body.truth.com()[:2]

    body.run(5.0)

    assert not body.truth.fallen()
    assert np.linalg.norm(body.truth.com()[:2] - start) < 0.002
    assert body.truth.com_margin_m() > 0.08


def test_it_starts_without_a_twitch(stand):
    body = stand(EMPTY)
    fastest = 0.0
    for _ in range(100):
        body.step()
        fastest = max(fastest, np.abs(body.world.physics.data.qvel).max())

    assert fastest < 0.01


def test_readings_do_not_change_until_time_passes(stand):
    body = stand(EMPTY)
    body.step()
    assert body.robot.read() is body.robot.read()


def test_encoders_are_unbiased_and_as_noisy_as_described(standing, description):
    _, readings, truth = standing
    error = np.array([state.q for state in readings]) - truth
    sigma = HARDWARE.noise.joint_position_rad

    assert error.std() == pytest.approx(sigma, rel=0.02)
    assert np.abs(error.mean(axis=0)).max() < 5.0 * sigma / np.sqrt(len(error))


def test_efforts_are_as_noisy_as_described(standing, description):
    _, readings, _ = standing
    efforts = np.array([state.effort for state in readings])
    limits = np.array([description.limits[name].effort for name in description.actuated])
    # Standing still, only noise is left between neighbouring periods.
    sigma = np.diff(efforts, axis=0).std(axis=0) / np.sqrt(2.0)

    assert sigma == pytest.approx(HARDWARE.noise.joint_effort_fraction * limits, rel=0.15)


def test_the_gyro_is_still_and_the_accelerometer_feels_gravity_upwards(standing, description):
    stand, readings, _ = standing
    world_R_imu = stand.truth.world_T_link(description.imu_link)[:3, :3]
    gyro = np.array([state.gyro for state in readings])
    felt = world_R_imu @ np.mean([state.accelerometer for state in readings], axis=0)

    assert np.abs(gyro.mean(axis=0)).max() < 0.001
    assert gyro.std() == pytest.approx(HARDWARE.noise.gyro_rad_s, rel=0.1)
    assert felt == pytest.approx((0.0, 0.0, 9.81), abs=0.01)


def test_the_soles_carry_the_weight_and_their_centre_of_pressure_is_under_the_com(standing, description):
    stand, readings, _ = standing
    wrench = np.mean([state.foot_wrench for state in readings], axis=0)
    weight = 9.81 * stand.model.mass_kg
    moment, force = np.zeros(3), np.zeros(3)
    for row, sole in zip(wrench, description.soles, strict=True):
        world_T_sole = stand.truth.world_T_link(sole.frame)
        push = world_T_sole[:3, :3] @ row[:3]
        force += push
        moment += world_T_sole[:3, :3] @ row[3:] + np.cross(world_T_sole[:3, 3], push)

    pressure = np.array([-moment[1], moment[0]]) / force[2]

    assert force[2] == pytest.approx(weight, rel=0.002)
    assert pressure == pytest.approx(stand.truth.com()[:2], abs=0.001)


def test_a_feed_forward_effort_is_what_the_joint_gives(standing, description):
    stand, readings, _ = standing
    measured = np.mean([state.effort for state in readings], axis=0)
    arms = [i for i, name in enumerate(description.actuated) if name.startswith("arm_")]

    assert measured[arms] == pytest.approx(stand.tau[arms], abs=0.2)


def test_effort_is_averaged_over_the_period(stand):
    body = stand(EMPTY)
    body.run(0.5)
    physics, robot = body.world.physics, body.robot
    q = np.concatenate([body.q[7:], body.gripper])
    elbow = body.description.actuated.index("arm_left_4_joint")
    q[elbow] += 0.002
    body.sequence += 1
    robot.command(JointSetpoint(0.0, body.sequence, "test", q, np.zeros_like(q), body.tau))
    robot.advance(0.002)
    sigma = HARDWARE.noise.joint_effort_fraction * body.description.limits["arm_left_4_joint"].effort

    end_of_period = physics.data.actuator_force[elbow]

    # The setpoint went up in a straight line: half way at the first of two steps.
    assert robot.read().effort[elbow] == pytest.approx(
        end_of_period - 0.25 * 0.002 * 2000.0, abs=0.5 + 5 * sigma
    )
    assert abs(robot.read().effort[elbow] - end_of_period) > 0.4


def test_a_setpoint_is_reached_in_a_straight_line_by_the_end_of_its_period(stand):
    body = stand(EMPTY)
    body.step()
    physics = body.world.physics
    former = physics.data.ctrl.copy()
    n = len(body.description.actuated)
    q, v, tau = former + 0.001, np.full(n, 0.1), np.full(n, 0.5)
    gains = [HARDWARE.gains[name] for name in body.description.actuated]
    folded = q + np.array([(0.5 + item.damping * 0.1) / item.stiffness for item in gains])

    body.robot.command(JointSetpoint(0.0, 1, "test", q, v, tau))
    body.robot.advance(0.004)
    reached = physics.data.ctrl.copy()
    body.robot.advance(0.002)

    assert reached == pytest.approx(folded, abs=1e-12)
    assert physics.data.ctrl == pytest.approx(folded, abs=1e-12)


def test_efforts_never_exceed_their_limits(stand):
    body = stand(EMPTY)
    joint = body.description.actuated.index("arm_left_7_joint")
    q = np.concatenate([body.q[7:], body.gripper])
    q[joint] += 1.0
    body.robot.command(setpoint(body.robot, q=q))
    body.robot.advance(0.02)

    limit = body.description.limits["arm_left_7_joint"].effort
    assert np.abs(body.world.physics.data.actuator_force[joint]) == pytest.approx(limit)


def test_stamps_are_those_of_a_clock_in_whole_nanoseconds(stand):
    body = stand(EMPTY)
    body.run(0.4)
    assert body.robot.read().stamp_s == 200 * 2_000_000 * 1e-9


def test_a_period_must_be_whole_physics_steps(stand):
    with pytest.raises(ValueError, match=r"no multiple of 0\.001 s"):
        stand(EMPTY).robot.advance(0.0015)


@pytest.mark.parametrize("bad", ["short", "nan", "infinite"])
def test_a_setpoint_that_breaks_the_contract_is_refused_and_the_former_one_stays(stand, bad):
    body = stand(EMPTY)
    body.step()
    n = len(body.description.actuated)
    wrong = {
        "short": {"q": np.zeros(n - 1)},
        "nan": {"v": np.full(n, np.nan)},
        "infinite": {"tau": np.full(n, np.inf)},
    }[bad]

    with pytest.raises(SetpointRefusedError):
        body.robot.command(setpoint(body.robot, **wrong))

    body.robot.advance(0.5)
    assert not body.truth.fallen()


def test_a_setpoint_that_is_no_numbers_cannot_be_written_down(stand):
    with pytest.raises(InvalidArrayError, match=r"q holds .*, not real numbers"):
        setpoint(stand(EMPTY).robot, q="home")


def test_a_setpoint_in_float32_is_followed_as_one_in_float64(stand):
    one, other = stand(EMPTY), stand(EMPTY)
    q = np.concatenate([one.q[7:], one.gripper]).astype(np.float32)
    one.robot.command(setpoint(one.robot, q=q))
    other.robot.command(setpoint(other.robot, q=q.astype(np.float64)))

    one.robot.advance(0.02)
    other.robot.advance(0.02)

    assert np.array_equal(one.robot.read().q, other.robot.read().q)


def test_the_robot_stands_where_the_scene_puts_it(description, robot_model):
    start = RobotStart(0.03, -0.02, 0.08)
    world = build_world(
        RobotData(description, HARDWARE),
        replace(EMPTY, robot_start=start),
        np.random.default_rng(0),
    )
    expected = world.truth.world_T_odom() @ robot_model.frame_pose(robot_model.q_home, description.base_link)

    assert world.truth.world_T_odom() == pytest.approx(
        poses.transform(poses.rotation_z(0.08), (0.03, -0.02, 0.0))
    )
    assert world.truth.world_T_base() == pytest.approx(expected, abs=0.0003)  # pressed into the floor


def readings_of(seed):
    world = build_world(load_robot("talos"), load_scene("tabletop"), np.random.default_rng(seed))
    out = []
    for i in range(100):
        world.robot.command(setpoint(world.robot, sequence=i))
        world.robot.advance(0.002)
        state = world.robot.read()
        out.append(np.concatenate([state.q, state.effort, state.accelerometer, state.foot_wrench.ravel()]))
    return np.array(out).tobytes()


def test_the_same_seed_gives_the_same_bytes_and_another_one_does_not():
    assert readings_of(3) == readings_of(3)
    assert readings_of(3) != readings_of(4)


def test_looking_at_the_truth_does_not_change_the_course_of_things(stand):
    def joints_after(look):
        body = stand(load_scene("tabletop"))
        for _ in range(100):
            body.step()
            if look:
                body.truth.solids()
                body.truth.com_margin_m()
                body.truth.visible("red cup", np.array([[0.5, -0.2, 0.95]]))
        return body.world.physics.data.qpos.tobytes()

    assert joints_after(look=True) == joints_after(look=False)
