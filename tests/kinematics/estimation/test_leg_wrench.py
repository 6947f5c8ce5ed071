"""What the floor does to the soles is found from the legs' efforts, however the base is turned."""

import numpy as np
import pinocchio as pin
import pytest

from kinematics.estimation.leg_wrench import LegWrench
from kinematics.geometry import poses
from kinematics.model.robot_model import RobotModel
from robots.models.description import load_description


@pytest.fixture(scope="module")
def model():
    return RobotModel(load_description("g1"))


def efforts_of(model, q, wrenches):
    """Efforts of the joints that bear gravity and these wrenches, by the model with gravity."""
    data = model.pin.createData()
    effort = np.array(pin.computeGeneralizedGravity(model.pin, data, q))
    pin.computeJointJacobians(model.pin, data, q)
    pin.updateFramePlacements(model.pin, data)
    for sole, wrench in zip(model.description.soles, wrenches, strict=True):
        J = pin.getFrameJacobian(model.pin, data, model.frame_id(sole.frame), pin.LOCAL)
        effort -= np.array(J).T @ wrench
    return effort[6:]


@pytest.mark.parametrize("seed", range(10))
def test_wrenches_on_soles_at_rest_are_found(model, seed):
    rng = np.random.default_rng(seed)
    wrenches = rng.normal(0.0, 1.0, (2, 6)) * [20.0, 20.0, 60.0, 5.0, 5.0, 2.0] + [0, 0, 170.0, 0, 0, 0]
    q = model.q_home.copy()
    turn = poses.rotation_from_vector(rng.uniform(-0.2, 0.2, 3))
    q[3:7] = poses.quaternion_from_rotation(turn)
    imu = model.frame_pose(q, model.description.imu_link)[:3, :3]

    found = LegWrench(model).update(
        0.0,
        q[7:],
        np.zeros(len(model.joints)),
        efforts_of(model, q, wrenches),
        np.zeros(3),
        imu.T @ [0.0, 0.0, 9.81],
    )

    assert found == pytest.approx(wrenches, abs=1e-6)


def test_the_same_readings_change_nothing(model):
    felt, rest = LegWrench(model), np.zeros(len(model.joints))
    readings = (0.1, model.q_home[7:], rest, rest, np.zeros(3), np.array([0.0, 0.0, 9.81]))

    before = felt.update(*readings).copy()

    assert felt.update(*readings) == pytest.approx(before, abs=0.0)


def stretched_knee(model, q):
    """The knee's position at which the left leg's Jacobian has no inverse."""
    data, sole = model.pin.createData(), model.description.soles[0]
    columns, knee = 6 + model.group("left_leg"), 7 + model.joint_index("left_knee_joint")

    def determinant(at):
        q[knee] = at
        pin.computeJointJacobians(model.pin, data, q)
        pin.updateFramePlacements(model.pin, data)
        J = pin.getFrameJacobian(model.pin, data, model.frame_id(sole.frame), pin.LOCAL)
        return np.linalg.det(np.array(J)[:, columns])

    low, high = -1.0, 1.0
    assert determinant(low) * determinant(high) < 0.0
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if determinant(low) * determinant(middle) > 0.0 else (low, middle)
    return low


def test_a_stretched_leg_keeps_its_last_wrench(model):
    felt, rest = LegWrench(model), np.zeros(len(model.joints))
    gravity, q = np.array([0.0, 0.0, 9.81]), model.q_home.copy()
    before = felt.update(0.0, q[7:], rest, rest, np.zeros(3), gravity).copy()

    stretched_knee(model, q)
    found = felt.update(0.01, q[7:], rest, rest + 5.0, np.zeros(3), gravity)

    assert found[0] == pytest.approx(before[0], abs=0.0)
    assert found[1] != pytest.approx(before[1])
