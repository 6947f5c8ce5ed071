"""What a document may loosen is a list that users can read, and holds for every robot."""

from pathlib import Path

import pytest

from kinematics.formats.loosening import LOOSENED, is_smaller, links_about, why_not_allowed
from kinematics.geometry import poses
from kinematics.geometry.shapes import Ball, Box, Cylinder
from kinematics.model.robot_model import RobotModel
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from robots.models.description import load_description

GUIDE = (Path(__file__).parents[3] / "docs" / "reference" / "trajectory.md").read_text()


@pytest.mark.parametrize("one", LOOSENED, ids=lambda one: one.what)
def test_the_guide_tells_what_may_be_loosened_by_how_much_and_why(one):
    assert f"| {one.what} | {one.bound} | {one.why} |" in GUIDE


def test_no_pair_of_links_may_be_said_to_touch(talos):
    links = sorted({talos.link_of(item) for item in talos.geometry().geometryObjects})
    scene = PlanningScene()

    pairs = [frozenset((one, other)) for one in links for other in links if one < other]

    assert all(why_not_allowed(pair, scene, talos, talos.q_home) for pair in pairs)


def test_a_welded_arm_may_stand_on_what_it_is_mounted_on_and_no_other_link_touch_it():
    panda = RobotModel(load_description("panda"))
    table = SceneObject("table", Box((1.0, 1.0, 0.1)), poses.translation(0.0, 0.0, -0.05))
    scene = PlanningScene().with_object(table)

    assert why_not_allowed(frozenset(("panda_link0", "table")), scene, panda, panda.q_home) is None
    assert why_not_allowed(frozenset(("panda_link4", "table")), scene, panda, panda.q_home) is not None


def test_the_links_about_a_hand_are_those_that_never_move_against_it(talos):
    assert links_about(talos, "tcp_left") >= set(talos.description.grippers["left"].links)
    assert not links_about(talos, "tcp_left") & {"arm_left_6_link", "gripper_right_base_link"}


@pytest.mark.parametrize(
    ("shape", "other", "smaller"),
    [
        (Ball(0.03), Ball(0.03), False),
        (Ball(0.03), Ball(0.038), False),
        (Ball(0.03), Ball(0.05), True),
        (Box((0.1, 0.2, 0.3)), Box((0.3, 0.1, 0.2)), False),
        (Cylinder(0.03, 0.1), Cylinder(0.03, 0.2), True),
        (Cylinder(0.04, 0.12), Box((0.08, 0.08, 0.12)), False),
    ],
)
def test_a_solid_is_smaller_where_one_of_its_sizes_is(shape, other, smaller):
    assert is_smaller(shape, other) is smaller
