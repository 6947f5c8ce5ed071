"""Fingers that close on a palm take a thing of any shape where they meet one width of it, by that width."""

from dataclasses import replace

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Box, Cylinder
from kinematics.model.robot_model import RobotModel
from kinematics.planning.grasps import ABOVE_MIDDLE, OTHER_HEIGHTS, grasp_table
from kinematics.planning.grasps_of_shapes import any_grasp_table, every_height, no_grasp_reason
from kinematics.scene.planning_scene import SceneObject
from robots.models.description import load_description
from tests import foreign_meshes as foreign
from tests.kinematics.planning.conftest import as_wide_as, thing

HEIGHTS = (ABOVE_MIDDLE, *OTHER_HEIGHTS)
MUG = 0.045 / 0.055
"""Of the wide mug, so that 90 mm across are left."""


@pytest.fixture(scope="module")
def model():
    return RobotModel(load_description("g1"))


@pytest.fixture(scope="module")
def gripper(model):
    return model.description.grippers["left"]


def standing(mesh, key):
    return SceneObject(key, thing(mesh, key), poses.translation(0.4, 0.2, 0.8))


@pytest.mark.parametrize("radius_m", [0.027, 0.032, 0.037])
def test_a_bottle_is_taken_where_it_is_of_one_width_and_by_that(model, gripper, radius_m):
    bottle = standing(foreign.bottle(radius_m, 0.22), f"bottle {radius_m}")

    table = any_grasp_table(bottle, model, "left", 0.0, 0.1, HEIGHTS, 0.0)

    by_outline = grasp_table(bottle, gripper, 0.0, 0.1, HEIGHTS)
    assert 0 < len(table) < len(by_outline)
    level = np.abs(table.world_T_tcp[:, 2, 0]) < 0.05
    assert table.world_T_tcp[level, 2, 3].max() < by_outline.world_T_tcp[:, 2, 3].max() - 0.03
    np.testing.assert_allclose(table.diameter_m[level], 2.0 * radius_m, atol=0.004)
    tcp_T_bottle = np.linalg.inv(table.world_T_tcp[level]) @ bottle.world_T_object
    np.testing.assert_allclose(tcp_T_bottle[:, 0, 3], 0.0, atol=0.004)
    np.testing.assert_allclose(tcp_T_bottle[:, 1, 3], gripper.grasped_at_m(2.0 * radius_m), atol=0.004)


@pytest.mark.parametrize(("height_m", "shoulder"), [(0.22, 0.38), (0.22, 0.40), (0.18, 0.46)])
def test_a_bottle_with_a_long_neck_is_taken_by_its_belly(model, gripper, height_m, shoulder):
    bottle = standing(foreign.bottle(0.032, height_m, shoulder), f"long neck {height_m} {shoulder}")

    usual = any_grasp_table(bottle, model, "left", 0.0, 0.1, HEIGHTS, 0.0)
    every = any_grasp_table(bottle, model, "left", 0.0, 0.1, every_height([gripper]), 0.0)

    level = every.world_T_tcp[np.abs(every.world_T_tcp[:, 2, 0]) < 0.05]
    foot_m = bottle.world_T_object[2, 3] - 0.5 * height_m
    assert len(usual) < len(every)
    assert len(level) > 0
    assert no_grasp_reason(bottle, model, "left") is None
    assert level[:, 2, 3].min() > foot_m + gripper.side_gap_m - 1e-6
    assert level[:, 2, 3].min() < bottle.world_T_object[2, 3] - 0.005


def slim(belly_m):
    """A slim bottle 157 mm high: its belly ends all at once."""
    return foreign.trimesh.util.concatenate([disc(0.0225, 0.0, belly_m), disc(0.008, belly_m, 0.157)])


def disc(radius_m, low_m, high_m):
    return foreign.lathe([(0, low_m), (radius_m, low_m), (radius_m, high_m), (0, high_m)])


def test_a_bottle_whose_belly_ends_before_the_thumb_is_taken_from_every_side(model, gripper):
    bottle = standing(slim(0.065), "slim")

    table = any_grasp_table(bottle, model, "left", 0.0, 0.1, (-0.1,), 0.0)

    level = np.abs(table.world_T_tcp[:, 2, 0]) < 0.05
    outline = grasp_table(bottle, gripper, 0.0, 0.1, (-0.1,))
    assert level.sum() == (np.abs(outline.world_T_tcp[:, 2, 0]) < 0.05).sum()
    np.testing.assert_allclose(table.diameter_m[level], 0.045, atol=0.002)
    lowest_m = bottle.world_T_object[2, 3] - 0.5 * 0.157 + gripper.side_gap_m
    np.testing.assert_allclose(table.world_T_tcp[level, 2, 3], lowest_m, atol=1e-6)


def test_a_bottle_whose_belly_ends_below_the_thumb_is_refused(model):
    bottle = standing(slim(0.056), "slimmer")

    table = any_grasp_table(bottle, model, "left", 0.0, 0.1, (-0.1,), 0.0)

    assert not np.any(np.abs(table.world_T_tcp[:, 2, 0]) < 0.05)


def test_what_is_thin_before_the_lower_finger_is_refused_whatever_is_above_that(model):
    goblet = foreign.trimesh.util.concatenate([disc(0.012, 0.0, 0.08), disc(0.03, 0.08, 0.18)])

    table = any_grasp_table(standing(goblet, "goblet"), model, "left", 0.0, 0.1, (0.0,), 0.0)

    assert not np.any(np.abs(table.world_T_tcp[:, 2, 0]) < 0.05)


def test_only_fingers_that_close_on_a_palm_look_for_a_belly(gripper):
    usual = load_description("talos").grippers["left"]

    assert every_height([usual]) == HEIGHTS
    assert set(every_height([usual, gripper])) > set(HEIGHTS)
    assert min(every_height([gripper])) < 0.0


def test_what_is_of_one_width_all_the_way_up_is_taken_below_its_middle_before_it_is_taken_above(
    model, gripper
):
    post = SceneObject("post", Cylinder(0.025, 0.2), poses.translation(0.4, 0.2, 0.8))

    table = any_grasp_table(post, model, "left", 0.0, 0.1, every_height([gripper])[1:], 0.0)

    assert table.world_T_tcp[0, 2, 3] < 0.8


def test_a_mug_whose_handle_does_not_go_into_the_hand_is_refused_in_words(model, wide_mug):
    slimmer = replace(
        wide_mug, radius_m=MUG * wide_mug.radius_m, parts=as_wide_as(wide_mug.parts, MUG, "90 mm across")
    )
    mug = SceneObject("mug", slimmer, poses.translation(0.4, 0.2, 0.8))

    assert len(any_grasp_table(mug, model, "left", 0.0, 0.1, HEIGHTS, 0.0)) == 0
    assert no_grasp_reason(mug, model, "left").startswith("nowhere is the mug of one width")


@pytest.mark.parametrize(("depth_m", "goes"), [(0.085, True), (0.10, False)])
def test_fingers_close_around_what_is_no_deeper_than_they_reach(gripper, depth_m, goes):
    box = SceneObject("box", Box((depth_m, 0.03, 0.15)), poses.translation(0.4, 0.2, 0.8))

    assert bool(len(grasp_table(box, gripper, 0.0, 0.1))) == goes
