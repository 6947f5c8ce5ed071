"""A force on the hand is felt by all joints of its arm, a jam by one."""

import numpy as np
import pinocchio as pin
import pytest

from kinematics.estimation.hand_touch import HandTouch

FORCES = [np.array([40.0, 0.0, 0.0]), np.array([0.0, -35.0, 10.0]), np.array([-25.0, 10.0, 50.0])]


def outside_of(talos, q, force):
    """What the joints give when something pushes on the left hand."""
    data, frame = talos.pin.createData(), talos.frame_id("tcp_left")
    pin.computeJointJacobians(talos.pin, data, q)
    pin.updateFramePlacement(talos.pin, data, frame)
    jacobian = pin.getFrameJacobian(talos.pin, data, frame, pin.LOCAL_WORLD_ALIGNED)[:3, 6:]
    return -jacobian.T @ force


@pytest.mark.parametrize("force", FORCES, ids=str)
def test_the_other_joints_foretell_what_a_pushed_hand_asks_of_each(talos, force):
    touch, outside = HandTouch(talos, "left"), outside_of(talos, talos.q_home, force)

    for joint in touch.joints:
        if abs(outside[joint]) > 6.0:
            foretold = touch.foretold_nm(talos.q_home, outside, int(joint))
            assert foretold == pytest.approx(outside[joint], rel=0.3)


def test_what_one_joint_feels_alone_is_foretold_by_none(talos):
    touch = HandTouch(talos, "left")
    for joint in talos.group("left_arm"):
        outside = np.zeros(len(talos.joints))
        outside[joint] = 12.0

        assert touch.foretold_nm(talos.q_home, outside, int(joint)) == 0.0


def test_a_joint_of_the_other_arm_is_none_of_its_joints(talos):
    touch = HandTouch(talos, "left")
    with pytest.raises(ValueError):
        touch.foretold_nm(talos.q_home, np.zeros(len(talos.joints)), int(talos.group("right_arm")[0]))
