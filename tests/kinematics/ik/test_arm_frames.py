"""Places of an arm's parts beside a configuration are those of the configurations beside it."""

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.ik.arm_frames import arm_kinematics, arm_share, elbow_frame, link_moved_by
from kinematics.model.robot_model import RobotModel
from robots.models.description import load_description

STEP_RAD = 1e-6


@pytest.fixture(scope="module")
def model():
    return RobotModel(load_description("talos"))


def somewhere(model, seed):
    """A configuration beside home, turned about the vertical."""
    q = model.q_home.copy()
    rng = np.random.default_rng(seed)
    q[7:] += rng.uniform(-0.4, 0.4, len(q) - 7)
    q[3:7] = poses.quaternion_from_rotation(poses.rotation_z(rng.uniform(-3.0, 3.0)))
    return q


@pytest.mark.parametrize("hand", ["left", "right"])
def test_an_arm_is_where_pinocchio_has_its_frames(model, hand):
    q = somewhere(model, 1)

    at = arm_kinematics(model, hand).at(q)

    arm = model.description.groups[f"{hand}_arm"]
    assert at.world_T_tcp() == pytest.approx(model.frame_pose(q, model.description.tcp_frames[hand]))
    assert at.elbow_m[0] == pytest.approx(model.frame_pose(q, elbow_frame(model, hand))[:3, 3])
    assert at.shoulder_m[0] == pytest.approx(model.frame_pose(q, link_moved_by(model, arm[1]))[:3, 3])


@pytest.mark.parametrize("hand", ["left", "right"])
@pytest.mark.parametrize("trunk", [False, True])
def test_what_is_beside_a_configuration_is_where_moved_joints_bring_it(model, hand, trunk):
    arm = arm_kinematics(model, hand, trunk)
    q = somewhere(model, 2)

    rows = arm.around(q, STEP_RAD)

    assert len(arm.joints) == 7 + trunk
    for row, column in enumerate([None, *arm.columns]):
        moved = q.copy()
        if column is not None:
            moved[column] += STEP_RAD
        there = arm.at(moved)
        for part in ("shoulder_m", "elbow_m", "tcp_m", "world_R_tcp", "chest_m", "heading_rad"):
            assert getattr(rows, part)[row] == pytest.approx(getattr(there, part)[0], abs=1e-11), part


def test_a_gesture_is_as_large_as_the_arm_is_long(model):
    small = RobotModel(load_description("g1"))

    assert {arm_share(model, hand) for hand in ("left", "right")} == {1.0}
    assert 0.6 < arm_share(small, "left") < 0.7


def test_the_chest_faces_where_the_robot_does_at_home(model):
    q = model.q_home.copy()
    q[3:7] = poses.quaternion_from_rotation(poses.rotation_z(0.7))

    at = arm_kinematics(model, "left").at(q)

    assert at.heading_rad[0] == pytest.approx(0.7)
    ahead = at.chest_m[0] + poses.rotation_z(0.7) @ (1.0, 0.0, 0.0)
    assert at.turned_past_rad(ahead)[0] == pytest.approx(0.0, abs=1e-9)
