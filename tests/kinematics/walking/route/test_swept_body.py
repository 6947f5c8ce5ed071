"""A robot moved over the floor as one piece: every link and what it holds, among what is believed."""

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.planar import PlanarPose
from kinematics.geometry.shapes import Box, Cylinder
from kinematics.model.robot_model import RobotModel
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from kinematics.walking.route.swept_body import SweptBody
from robots.models.description import load_description

MODEL = RobotModel(load_description("talos"))
SETTINGS = MODEL.description.walking
HAND = MODEL.frame_pose(MODEL.q_home, "tcp_right")[:3, 3]
AHEAD = [PlanarPose(x, 0.0, 0.0) for x in np.linspace(0.0, 0.3, 7)]


def wall(x):
    return SceneObject("wall", Box((0.1, 3.0, 2.0)), poses.translation(x, 0.0, 1.0), 0.01, movable=False)


@pytest.mark.parametrize(("away_m", "meets"), [(0.55, True), (0.8, False)])
def test_what_is_within_the_way_is_met_and_what_is_beyond_it_is_not(away_m, meets):
    body = SweptBody(MODEL, MODEL.q_home, PlanningScene().with_object(wall(away_m)), SETTINGS)

    assert (body.meets(AHEAD) is not None) is meets


def test_what_is_held_counts_where_it_is():
    board = SceneObject("board", Cylinder(0.02, 0.6), np.eye(4), 0.01, movable=True)
    along = poses.transform(
        MODEL.frame_pose(MODEL.q_home, "tcp_right")[:3, :3].T @ poses.rotation_y(np.pi / 2), np.zeros(3)
    )
    free = PlanningScene().with_object(wall(HAND[0] + 0.48))
    scene = free.with_object(board).with_attached("board", "tcp_right", along, ())

    assert SweptBody(MODEL, MODEL.q_home, free, SETTINGS).meets(AHEAD[:4]) is None
    assert SweptBody(MODEL, MODEL.q_home, scene, SETTINGS).meets(AHEAD[:4]).part == "the board in its hand"


def test_a_robot_that_is_turned_goes_where_it_looks():
    q = MODEL.q_home.copy()
    q[3:7] = poses.quaternion_from_rotation(poses.rotation_z(np.pi))
    body = SweptBody(MODEL, q, PlanningScene().with_object(wall(0.5)), SETTINGS)

    assert body.meets(AHEAD) is None
    assert body.meets([PlanarPose(-place.x_m, 0.0, 0.0) for place in AHEAD]) is not None
