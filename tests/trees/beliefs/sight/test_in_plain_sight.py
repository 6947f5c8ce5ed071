"""What was hidden, or cut off by the picture's edge, may still be where it was believed to be."""

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Box, Cylinder
from kinematics.scene.planning_scene import SceneObject
from trees.beliefs.sight.in_plain_sight import in_plain_sight
from trees.beliefs.sight.sight import Glimpse, in_view

WITHIN_M = 0.1
TABLE = SceneObject("table", Box((0.6, 1.2, 0.04)), poses.translation(0.9, 0.0, 0.88), movable=False)
BOTTLE = SceneObject("black bottle", Cylinder(0.035, 0.2), poses.translation(0.9, 0.0, 1.0))


@pytest.fixture
def seen(model):
    """Whether a look from 1.5 m above the floor, tilted down by some angle, shows the bottle past others."""

    def look(*others, tilt_rad=0.5, in_the_way=()):
        level = np.array([[0.0, 0.0, 1.0], [-1.0, 0.0, 0.0], [0.0, -1.0, 0.0]])
        pose = poses.transform(poses.rotation_y(tilt_rad) @ level, (0.1, 0.0, 1.5))
        glimpse = Glimpse(pose, in_the_way)
        camera = model.description.camera
        assert in_view(camera, pose, BOTTLE.world_T_object[:3, 3])
        return in_plain_sight(BOTTLE, glimpse, camera, (TABLE, BOTTLE, *others), WITHIN_M)

    return look


def standing(x_m, y_m, height_m=0.16):
    pose = poses.translation(x_m, y_m, 0.9 + 0.5 * height_m)
    return SceneObject("yellow box", Box((0.07, 0.07, height_m)), pose)


def test_what_stands_free_in_the_picture_would_have_been_seen(seen):
    assert seen()
    assert seen(standing(0.9, 0.15), standing(1.1, 0.0))


def test_what_stands_behind_something_else_may_have_been_missed(seen):
    assert not seen(standing(0.78, 0.0))


def test_what_is_hidden_by_less_than_a_quarter_would_have_been_seen(seen):
    assert seen(standing(0.78, 0.0, height_m=0.02))


def test_what_is_cut_off_by_the_edge_of_the_picture_may_have_been_missed(seen):
    assert not seen(tilt_rad=0.98)


def test_what_a_hand_may_hide_may_have_been_missed(seen):
    assert not seen(in_the_way=(np.array([0.5, 0.05, 1.25]),))
