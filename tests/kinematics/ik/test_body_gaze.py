"""Looking at something with the head, the trunk, and at last the pelvis."""

import numpy as np
import pytest

from kinematics.ik.body_gaze import (
    AIMED_RAD,
    DOUBTFUL_RAD,
    body_gaze,
    off_axis_rad,
    pelvis_offset,
    with_joints,
)
from kinematics.ik.gaze import gaze_joints
from kinematics.model.robot_model import RobotModel
from robots.models.description import load_description


@pytest.fixture(scope="module")
def model():
    return RobotModel(load_description("talos"))


@pytest.fixture(scope="module")
def small():
    """A humanoid of a child's size whose camera sits on a trunk without a neck, and looks down."""
    return RobotModel(load_description("g1"))


def aimed(model, gaze):
    """The configuration that a gaze stands for, from home."""
    q = model.q_home.copy()
    q[:3] += pelvis_offset(q, gaze.pelvis_m)
    for joint, angle in gaze.joints.items():
        q[7 + model.joint_index(joint)] = angle
    return q


def test_the_head_alone_looks_at_what_stands_well_ahead(model):
    point = np.array([0.9, 0.2, 1.0])

    gaze = body_gaze(model, model.q_home, point, "torso_1_joint")

    assert gaze.joints["torso_2_joint"] == gaze.joints["torso_1_joint"] == 0.0
    assert gaze.pelvis_m == (0.0, 0.0, 0.0)
    assert off_axis_rad(model, aimed(model, gaze), point) <= AIMED_RAD


def test_what_stands_at_the_edge_of_a_high_table_is_looked_at_with_the_pelvis_drawn_back(model):
    point = np.array([0.4135, 0.1676, 1.0409])

    gaze = body_gaze(model, model.q_home, point, "torso_1_joint")

    assert gaze.pelvis_m[0] < 0.0
    assert off_axis_rad(model, aimed(model, gaze), point) == pytest.approx(gaze.off_rad, abs=1e-9)
    assert gaze.off_rad <= DOUBTFUL_RAD


def test_what_is_behind_is_not_looked_at(model):
    assert body_gaze(model, model.q_home, np.array([-1.0, 0.0, 1.0]), "torso_1_joint") is None


@pytest.mark.parametrize("place", [(0.45, 0.15, 0.75), (0.9, -0.6, 0.5), (1.3, 0.6, 0.3)])
def test_a_trunk_without_a_neck_turns_and_bends_to_what_is_looked_at(small, place):
    point = np.array(place)

    gaze = body_gaze(small, small.q_home, point, "waist_yaw_joint")

    assert set(gaze.joints) == {"waist_yaw_joint", "waist_pitch_joint"}
    assert off_axis_rad(small, aimed(small, gaze), point) <= AIMED_RAD


def test_a_trunk_bends_back_no_farther_than_the_robot_stands_safely(small):
    trunk = small.description.camera.trunk

    assert body_gaze(small, small.q_home, np.array([2.0, 0.0, 1.6])) is None
    assert small.description.camera.aimed(0.0, -0.5)[trunk.bow_joint] == trunk.bow_rad[0]


@pytest.mark.parametrize("pan_rad", [-0.85, 0.0, 0.85])
def test_a_level_gaze_of_a_trunk_shows_who_stands_some_way_off(small, pan_rad):
    camera = small.description.camera
    joints = camera.aimed(pan_rad, 0.15)
    far_m, middle_m = 2.5, 0.85
    point = np.array([far_m * np.cos(pan_rad), far_m * np.sin(pan_rad), middle_m])

    pose = small.frame_pose(with_joints(small.q_home, small, joints), camera.frame)
    x, y, z = pose[:3, :3].T @ (point - pose[:3, 3])

    assert abs(np.arctan2(x, z)) <= 0.5 * camera.horizontal_fov_rad
    assert abs(np.arctan2(y, z)) <= 0.5 * camera.vertical_fov_rad


def test_what_the_picture_holds_already_turns_no_trunk(small):
    camera = small.description.camera
    held = camera.aimed(0.3, camera.trunk.down_rad + 0.2)

    assert set(held.values()) == {0.0}


def test_a_trunk_is_told_how_far_down_the_camera_looks(small):
    camera = small.description.camera
    ahead = small.frame_pose(small.q_home, camera.frame)[:3, 2]

    assert np.arcsin(-ahead[2]) == pytest.approx(camera.trunk.down_rad, abs=0.01)


def test_what_plans_for_a_neck_leaves_a_trunk_alone(small):
    assert gaze_joints(small, small.q_home, np.array([0.5, 0.3, 0.7])) == {}
