"""Whether a walk is needless."""

import numpy as np
import pytest

from executive.errands.nearness import Nearness, is_away, is_near
from kinematics.geometry import poses
from kinematics.geometry.planar import PlanarPose
from kinematics.geometry.shapes import Box, Cylinder
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from trees.beliefs.scene.believed_thing import surroundings
from trees.tasks import ObjectDescription, Relation

CUP = ObjectDescription("cup", "red")
TABLE = ObjectDescription("table")


def room(cup_m):
    """A robot at the origin, a table whose edge is 0.4 m ahead, and a red cup."""
    table = SceneObject("table", Box((0.6, 1.2, 0.9)), poses.translation(0.7, 0.0, 0.45), movable=False)
    cup = SceneObject("red cup", Cylinder(0.03, 0.1), poses.translation(*cup_m), movable=True)
    return PlanningScene().with_objects((table, cup))


def near(nearness, cup_m=(0.5, 0.1, 0.95), base=(0.0, 0.0, 0.0)):
    x, y, yaw = base
    standing = poses.transform(poses.rotation_z(yaw), (x, y, 1.0))
    scene = room(cup_m)
    return is_near(nearness, surroundings(scene, standing, 0.05), scene, standing)


def test_a_cup_half_a_metre_ahead_is_at_hand():
    assert near(Nearness(CUP))


@pytest.mark.parametrize("cup_m", [(0.9, 0.0, 0.95), (0.5, 0.55, 0.95), (0.5, -0.55, 0.95)])
def test_a_cup_far_over_the_table_is_not(cup_m):
    assert not near(Nearness(CUP), cup_m)


def test_behind_the_robot_nothing_is_at_hand():
    assert not near(Nearness(CUP), base=(0.0, 0.0, np.pi))
    assert not near(Nearness(TABLE), base=(0.0, 0.0, np.pi))


def test_a_cup_that_was_seen_need_not_be_searched_for_at_the_table():
    seen = ObjectDescription("cup", "red", relation=Relation("on", "table"))

    assert near(Nearness(seen, within_reach=False), base=(-3.0, 0.0, 0.0))
    assert not near(Nearness(ObjectDescription("bottle"), within_reach=False))


def test_who_stands_before_the_table_need_not_walk_to_it():
    assert near(Nearness(TABLE))
    assert not near(Nearness(TABLE), base=(-0.5, 0.0, 0.0))


@pytest.mark.parametrize(
    ("x_m", "yaw_rad", "away"),
    [(0.0, 0.0, False), (0.2, 0.3, False), (0.0, 3.1, True), (0.0, -1.0, True), (-0.7, 0.0, True)],
)
def test_a_robot_that_turned_or_went_has_left(x_m, yaw_rad, away):
    assert is_away(PlanarPose(x_m, 0.1, yaw_rad)) == away
