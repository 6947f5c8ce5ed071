import numpy as np
import pytest

from kinematics.ik.gaze import gaze_joints
from trees.beliefs.sight.sight import behind_a_hand, in_view, off_axis_rad


def camera_pose(model, q):
    return model.frame_pose(q, model.description.camera.frame)


def test_a_point_on_the_optical_axis_is_on_axis(model):
    pose = camera_pose(model, model.q_home)

    assert off_axis_rad(pose, pose[:3, 3] + pose[:3, 2]) == pytest.approx((0.0, 0.0), abs=1e-12)


def test_what_the_head_is_turned_to_is_in_view_and_what_is_behind_is_not(model):
    place, q = np.array([0.7, 0.2, 0.9]), model.q_home.copy()
    for joint, angle in gaze_joints(model, q, place).items():
        q[7 + model.joint_index(joint)] = angle

    assert in_view(model.description.camera, camera_pose(model, q), place)
    assert not in_view(model.description.camera, camera_pose(model, q), -place)


def test_something_too_far_for_the_camera_is_not_in_view(model):
    pose = camera_pose(model, model.q_home)

    assert not in_view(model.description.camera, pose, pose[:3, 3] + 50.0 * pose[:3, 2])


def test_a_point_right_behind_a_hand_may_be_hidden_by_it(model):
    q = model.q_home
    eye = camera_pose(model, q)[:3, 3]
    hand = model.frame_pose(q, "tcp_left")[:3, 3]

    assert behind_a_hand(model, q, eye, hand + 0.3 * (hand - eye), within_m=0.1)
    assert not behind_a_hand(model, q, eye, eye + 0.3 * (hand - eye), within_m=0.1)
