"""What a hand feels."""

import numpy as np
import pinocchio as pin
import pytest

from kinematics.estimation.hand_force import HandForce

FORCES = [np.array([30.0, 0.0, 0.0]), np.array([0.0, -25.0, 10.0]), np.array([-15.0, 10.0, 20.0])]


def efforts_under(talos, q, force):
    """Efforts of a robot that stands still while something pushes on its left hand."""
    data = talos.pin.createData()
    frame = talos.frame_id("tcp_left")
    pin.computeJointJacobians(talos.pin, data, q)
    pin.updateFramePlacement(talos.pin, data, frame)
    jacobian = pin.getFrameJacobian(talos.pin, data, frame, pin.LOCAL_WORLD_ALIGNED)[:3, 6:]
    rest = np.zeros(talos.nv)
    return pin.rnea(talos.pin, data, q, rest, rest)[6:] - jacobian.T @ force


@pytest.mark.parametrize("force", FORCES, ids=str)
def test_a_push_on_the_hand_is_felt_with_its_size_and_direction(talos, force):
    q, rest = talos.q_home, np.zeros(talos.nv)
    feeling = HandForce(talos, "left", 0.0)

    felt = feeling.estimate(q, rest, rest, efforts_under(talos, q, force))

    assert felt[:3] == pytest.approx(force, abs=2.0)


def test_a_stretched_arm_does_not_make_large_forces_out_of_noise(talos):
    q, rest = talos.q_home.copy(), np.zeros(talos.nv)
    q[7 + talos.joint_index("arm_left_4_joint")] = -0.02
    noise = np.random.default_rng(3).normal(0.0, 1.0, (200, len(talos.joints)))
    feeling = HandForce(talos, "left", 0.0)
    quiet = efforts_under(talos, q, np.zeros(3))

    felt = [np.linalg.norm(feeling.estimate(q, rest, rest, quiet + row)[:3]) for row in noise]

    assert np.percentile(felt, 95) < 20.0


def test_friction_of_moving_joints_is_not_taken_for_a_push(talos):
    q, rest = talos.q_home, np.zeros(talos.nv)
    v = np.zeros(talos.nv)
    v[6 + talos.group("left_arm")] = 0.5
    rubbing = efforts_under(talos, q, np.zeros(3)) + 1.0 * v[6:]

    coriolis = HandForce(talos, "left", 0.0).estimate(q, v, rest, rubbing - 1.0 * v[6:])
    known = HandForce(talos, "left", 1.0).estimate(q, v, rest, rubbing)
    unknown = HandForce(talos, "left", 0.0).estimate(q, v, rest, rubbing)

    assert known == pytest.approx(coriolis, abs=1e-9)
    assert np.linalg.norm((unknown - coriolis)[:3]) > 1.0
