"""Fingers that close on a palm take a thing of any shape where they meet one width of it, by that width."""

from dataclasses import replace

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from kinematics.model.robot_model import RobotModel
from kinematics.planning.grasps import ABOVE_MIDDLE, OTHER_HEIGHTS, grasp_table
from kinematics.planning.grasps_of_shapes import any_grasp_table, no_grasp_reason
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
