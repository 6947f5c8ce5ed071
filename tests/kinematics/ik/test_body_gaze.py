"""Looking at something with the head, the trunk, and at last the pelvis."""

import numpy as np
import pytest

from kinematics.ik.body_gaze import AIMED_RAD, DOUBTFUL_RAD, body_gaze, off_axis_rad, pelvis_offset
from kinematics.model.robot_model import RobotModel
from robots.models.description import load_description


@pytest.fixture(scope="module")
def model():
    return RobotModel(load_description("talos"))


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
