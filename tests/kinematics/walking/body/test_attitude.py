"""The compiled steps of the estimator and the stabiliser, against the same formulas in matrices."""

import math

import numpy as np
import pinocchio as pin
import pytest

from kinematics.geometry import poses
from kinematics.geometry.planar import wrapped
from kinematics.walking.body.attitude import base_velocity, com_seen, righting_moment, turned


def rotation(rng, size=3.0):
    return poses.rotation_from_vector(rng.uniform(-size, size, 3))


@pytest.mark.parametrize("seed", range(20))
def test_a_turn_is_the_gyros_corrected_by_flat_soles_and_gravity(seed):
    rng = np.random.default_rng(seed)
    yawed = poses.rotation_z(float(rng.uniform(-3.0, 3.0)))
    R, soles = yawed @ rotation(rng, 0.003), np.array([rotation(rng, 0.003), rotation(rng, 0.003)])
    rate, force, dt = rng.normal(0.0, 0.5, 3), rng.normal(0.0, 9.0, 3), 0.002
    loads, yaw = np.array([0.0 if seed % 3 == 0 else 400.0, 500.0]), float(rng.uniform(-3.0, 3.0))

    found = turned(R, rate, dt, loads, soles, 1, yaw, force, np.array([0.4, 10.0, 4.0]), 100.0)

    before = R @ pin.exp3(rate * dt)
    turn = np.zeros(3)
    for load, sole in zip(loads, soles, strict=True):
        up = before @ sole @ (0.0, 0.0, 1.0)
        turn += dt / 0.4 * load / loads.sum() * np.cross(up, (0.0, 0.0, 1.0))
    turn[2] = dt / 10.0 * wrapped(yaw - poses.yaw_of(before @ soles[1]))
    down = before @ force
    turn[:2] += dt / 4.0 * np.array((down[1], -down[0])) / np.linalg.norm(down)
    np.testing.assert_allclose(found, pin.exp3(turn) @ before, atol=1e-12)


def test_a_sole_on_an_edge_turns_the_trunk_no_faster_than_it_may():
    level, tilted = np.eye(3), poses.rotation_from_vector(np.array([0.008, 0.006, 0.0]))
    loads, dt = np.array([900.0, 0.0]), 0.002
    still, down = np.zeros(3), np.array([0.0, 0.0, 9.81])

    found = turned(
        level, still, dt, loads, np.array([tilted, level]), 0, 0.0, down, np.array([0.4, 1e9, 1e9]), 0.012
    )

    assert np.linalg.norm(pin.log3(found)) == pytest.approx(0.012 * dt, rel=1e-3)


def test_a_sole_that_leans_far_says_nothing_about_the_trunk():
    level, tilted = np.eye(3), poses.rotation_from_vector(np.array([0.03, 0.02, 0.0]))
    loads, times = np.array([900.0, 0.0]), np.array([0.4, 1e9, 1e9])
    still, down = np.zeros(3), np.array([0.0, 0.0, 9.81])

    found = turned(level, still, 0.002, loads, np.array([tilted, level]), 0, 0.0, down, times, 0.012)

    np.testing.assert_allclose(found, level, atol=1e-9)


@pytest.mark.parametrize("seed", range(10))
def test_the_base_moves_as_the_accelerometer_says_corrected_by_the_soles(seed):
    rng = np.random.default_rng(seed)
    R, dt = rotation(rng), 0.002
    before, force, rate = rng.normal(0.0, 0.1, (3, 3))
    sole_p, sole_v = rng.normal(0.0, 0.1, (2, 2, 3))
    loads = np.array([0.0 if seed % 3 == 0 else 400.0, 500.0])

    found = base_velocity(before, R, force, dt, loads, sole_p, sole_v, rate, 0.05, 100.0)

    led = before + dt * (R @ force - (0.0, 0.0, 9.81))
    seen = -sum(
        load / loads.sum() * (R @ (v + np.cross(rate, p)))
        for load, p, v in zip(loads, sole_p, sole_v, strict=True)
    )
    np.testing.assert_allclose(found, led + dt / 0.05 * (seen - led), atol=1e-12)


def test_a_sole_that_rocks_is_believed_to_a_bound():
    loads, dt = np.array([900.0]), 0.002
    still, rocking, down = np.zeros(3), np.array([[0.5, 0.0, 0.0]]), np.array([0.0, 0.0, 9.81])

    found = base_velocity(still, np.eye(3), down, dt, loads, np.zeros((1, 3)), rocking, still, 0.05, 0.1)

    np.testing.assert_allclose(found, (-dt / 0.05 * 0.1, 0.0, 0.0), atol=1e-12)


@pytest.mark.parametrize("seed", range(10))
def test_the_com_is_seen_along_the_soles_heading(seed):
    rng = np.random.default_rng(seed)
    R, sole_R = rotation(rng, 0.5), rotation(rng, 0.5)
    sole_p, base_v, com, com_v, rate = rng.normal(0.0, 1.0, (5, 3))

    seen = com_seen(R, sole_R, sole_p, base_v, com, com_v, rate)

    heading = poses.yaw_of(R @ sole_R)
    level = poses.rotation_z(-heading) @ R
    np.testing.assert_allclose(seen[:3], level @ (com - sole_p), atol=1e-12)
    np.testing.assert_allclose(
        seen[3:6], level @ (com_v + np.cross(rate, com)) + poses.rotation_z(-heading) @ base_v, atol=1e-12
    )
    assert seen[6] == pytest.approx(wrapped(poses.yaw_of(R) - heading))


@pytest.mark.parametrize("seed", range(10))
def test_a_trunk_that_leans_is_turned_back(seed):
    rng = np.random.default_rng(seed)
    plan, lean = rotation(rng, 0.1), rng.uniform(-0.02, 0.02, 3)
    lean[2] = 0.0
    measured = poses.rotation_from_vector(lean) @ plan
    heading = poses.yaw_of(measured)
    rate = rng.normal(0.0, 0.1, 3)

    moment = righting_moment(
        poses.rotation_z(1.2) @ measured,
        heading,
        poses.quaternion_from_rotation(plan),
        rate,
        0.3,
        300.0,
        40.0,
    )

    wanted = -300.0 * lean - 40.0 * (measured @ rate - (0.0, 0.0, 0.3))
    np.testing.assert_allclose(moment, wanted, atol=300.0 * 1e-5)
    assert math.isfinite(moment[2])
