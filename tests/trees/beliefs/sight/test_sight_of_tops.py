import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from kinematics.scene.planning_scene import SceneObject
from trees.beliefs.sight.sight import Glimpse
from trees.beliefs.sight.sight_of_tops import SightOfTops, is_over

TOP = SceneObject("table", Box((0.8, 1.2, 0.04)), poses.translation(0.7, 0.0, 0.88), 0.015, False)
PLACE = np.array([0.6, 0.0, 0.90])
# A camera 0.6 m over the top that looks straight down: its x to the right, its z along the view.
DOWN = np.diag([1.0, -1.0, -1.0])


def looked(camera, *places, in_the_way=()):
    glimpses = [
        Glimpse(poses.transform(DOWN, (x, y, 1.5)), tuple(np.array(part) for part in in_the_way))
        for x, y in places
    ]
    return SightOfTops(tuple(glimpses), camera, 0.10).about(TOP, 0.03, np.eye(4))


@pytest.fixture
def camera(model):
    return model.description.camera


def test_what_was_never_looked_at_is_not_known_to_be_free(camera):
    assert not looked(camera)(PLACE)


def test_a_place_that_was_seen_with_all_about_it_is_known(camera):
    assert looked(camera, (0.5, 0.0))(PLACE)


def test_a_place_at_the_edge_of_the_picture_is_not_known(camera):
    assert not looked(camera, (0.5, 0.25))(PLACE)


def test_two_looks_that_each_show_one_half_make_a_place_known(camera):
    assert looked(camera, (0.5, 0.25), (0.5, -0.25))(PLACE)


def test_a_place_is_not_known_where_the_wrist_of_a_slanting_hand_comes_over_what_was_not_seen(camera):
    # what is about the spot is in the picture, and so is what is straight before it
    aslant = poses.transform(poses.rotation_z(0.4) @ DOWN, (0.49, -0.16, 1.5))

    assert not SightOfTops((Glimpse(aslant, ()),), camera, 0.10).about(TOP, 0.03, np.eye(4))(PLACE)


def test_a_place_behind_a_hand_is_not_known(camera):
    assert not looked(camera, (0.5, 0.0), in_the_way=[(0.57, 0.0, 1.1)])(PLACE)


def test_beyond_the_edge_of_a_top_nothing_can_stand(camera):
    at_the_edge = np.array([0.33, 0.0, 0.90])

    assert looked(camera, (0.53, 0.0))(at_the_edge)


@pytest.mark.parametrize(("x", "y"), [(0.39, 0.0), (-0.39, 0.0), (0.0, 0.59), (0.0, -0.59), (0.39, -0.59)])
def test_a_top_reaches_to_its_edges_however_it_is_turned(x, y):
    turned = poses.transform(poses.rotation_z(0.7), (0.7, 0.2, 0.88))
    top = SceneObject("table", TOP.shape, turned, 0.015, False)

    assert is_over(top, (turned @ [x, y, 0.02, 1.0])[:3])
    for beyond in ((x + np.sign(x) * 0.02, y), (x, y + np.sign(y) * 0.02)):
        if beyond != (x, y):
            assert not is_over(top, (turned @ [*beyond, 0.02, 1.0])[:3])
