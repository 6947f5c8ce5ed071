"""The compiled steps of the estimator and the stabiliser, against the same formulas in matrices."""

import math

import numpy as np
import pinocchio as pin
import pytest

from kinematics import poses
from kinematics.walking.attitude import com_seen, righting_moment, turned
from kinematics.walking.planar import wrapped


def rotation(rng, size=3.0):
    return poses.rotation_from_vector(rng.uniform(-size, size, 3))


@pytest.mark.parametrize("seed", range(20))
def test_a_turn_is_the_gyros_corrected_by_flat_soles_and_gravity(seed):
    rng = np.random.default_rng(seed)
    R, soles = rotation(rng), np.array([rotation(rng, 0.2), rotation(rng, 0.2)])
    rate, force, dt = rng.normal(0.0, 1.0, 3), rng.normal(0.0, 9.0, 3), 0.002
    loads, yaw = np.array([0.0 if seed % 3 == 0 else 400.0, 500.0]), float(rng.uniform(-3.0, 3.0))

    found = turned(R, rate, dt, loads, soles, 1, yaw, force, np.array([0.4, 10.0, 4.0]))

    before = R @ pin.exp3(rate * dt)
    turn = np.zeros(3)
    for load, sole in zip(loads, soles, strict=True):
        up = before @ sole @ (0.0, 0.0, 1.0)
        turn += dt / 0.4 * load / loads.sum() * np.cross(up, (0.0, 0.0, 1.0))
    turn[2] = dt / 10.0 * wrapped(yaw - poses.yaw_of(before @ soles[1]))
    down = before @ force
    turn[:2] += dt / 4.0 * np.array((down[1], -down[0])) / np.linalg.norm(down)
    np.testing.assert_allclose(found, pin.exp3(turn) @ before, atol=1e-12)


@pytest.mark.parametrize("seed", range(10))
def test_the_com_is_seen_along_the_soles_heading(seed):
    rng = np.random.default_rng(seed)
    R, sole_R = rotation(rng, 0.5), rotation(rng, 0.5)
    sole_p, sole_v, com, com_v, rate = rng.normal(0.0, 1.0, (5, 3))

    seen = com_seen(R, sole_R, sole_p, sole_v, com, com_v, rate)

    heading = poses.yaw_of(R @ sole_R)
    level = poses.rotation_z(-heading) @ R
    np.testing.assert_allclose(seen[:3], level @ (com - sole_p), atol=1e-12)
    np.testing.assert_allclose(seen[3:6], level @ (com_v - sole_v + np.cross(rate, com - sole_p)), atol=1e-12)
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
