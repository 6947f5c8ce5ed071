"""Where the robot stands before a person: an arm's length from who stands, sits or lies."""

import math

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.planar import PlanarPose
from kinematics.geometry.shapes import Box, Cylinder
from kinematics.scene.planning_scene import PlanningScene
from trees.beliefs.grounding.destination import Place
from trees.skills.walking.standing_place import PERSON_M, standing_place

STANDING, LYING = Cylinder(0.24, 1.75), Box((1.75, 0.6, 0.34))


def stands(shape, yaw_rad=0.0):
    at = poses.translation(3.0, 0.0, 0.5 * shape.height_m) @ PlanarPose(yaw_rad=yaw_rad).transform()
    return standing_place(Place("Ana", "person", shape, at, 0.9), PlanningScene(), PlanarPose(), 0.05)


def test_before_who_stands_it_is_near_enough_to_talk():
    assert stands(STANDING).x_m == pytest.approx(3.0 - PERSON_M)


@pytest.mark.parametrize(("yaw_rad", "half_m"), [(0.0, 0.875), (0.5 * math.pi, 0.3)])
def test_before_who_lies_it_keeps_off_the_whole_body(yaw_rad, half_m):
    assert stands(LYING, yaw_rad).x_m == pytest.approx(3.0 - half_m - (PERSON_M - 0.24))


def test_in_a_room_it_stands_clear_of_whoever_was_only_felt_there():
    kitchen = Place("kitchen", "region", Box((3.7, 4.8, 2.0)), poses.translation(4.3, 0.0, 1.0), 1.0)
    somebody = np.array([[4.3, 0.6]])

    usual = standing_place(kitchen, PlanningScene(), PlanarPose(), 0.05)
    beside = standing_place(kitchen, PlanningScene(), PlanarPose(), 0.05, points=somebody)

    assert (usual.x_m, usual.y_m) == pytest.approx((4.3, 0.0), abs=0.13)
    assert math.hypot(beside.x_m - 4.3, beside.y_m - 0.6) >= 0.75
