"""Fingers open beside a bar as far as what is around it allows."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinematics.geometry import poses
from kinematics.geometry.shapes import Box, Cylinder
from kinematics.planning.finger_room import BESIDE_M, boxes_meet, fitting_opening_m, stands_out, thick_m
from kinematics.scene.planning_scene import SceneObject
from robots.models.description import load_robot

GRIPPER = load_robot("panda").description.grippers["right"]
OUTWARD = np.array([-1.0, 0.0, 0.0])
PLACE = st.floats(-0.2, 0.2)
ANGLE = st.floats(-3.0, 3.0)


def beside(aside_m, turned_rad=0.0):
    """A rod across the fingers, with its near side so far from the middle between them."""
    rod = Box((0.3, 0.02, 0.3))
    place = poses.translation(0.0, aside_m + 0.01, 0.0)
    return SceneObject("rod", rod, poses.transform(poses.rotation_x(turned_rad), place[:3, 3]), movable=False)


def test_with_nothing_around_it_opens_all_the_way():
    assert fitting_opening_m(GRIPPER, np.eye(4), [], 0.02) == GRIPPER.max_opening_m


@pytest.mark.parametrize("aside_m", [0.03, 0.04, 0.05])
def test_it_opens_until_the_finger_would_come_to_what_is_beside(aside_m):
    opening_m = fitting_opening_m(GRIPPER, np.eye(4), [beside(aside_m)], 0.005)

    assert opening_m is not None
    left_m = aside_m - (0.5 * opening_m + thick_m(GRIPPER))
    assert BESIDE_M <= left_m < BESIDE_M + 0.003


def test_there_is_no_opening_where_not_even_the_bar_fits():
    assert fitting_opening_m(GRIPPER, np.eye(4), [beside(0.025)], 0.03) is None


def test_what_is_flush_with_a_front_stands_not_out_of_it():
    front = SceneObject("front", Box((0.02, 0.3, 0.1)), poses.translation(0.5, 0.0, 1.0), movable=False)
    panel = SceneObject("panel", Box((0.2, 0.3, 0.1)), poses.translation(0.6, 0.0, 1.1), movable=False)
    bar = SceneObject("bar", Cylinder(0.008, 0.1), poses.translation(0.45, 0.0, 1.1), movable=False)

    assert not stands_out(panel, front, OUTWARD)
    assert stands_out(bar, front, OUTWARD)


@given(PLACE, PLACE, PLACE, ANGLE, ANGLE)
def test_boxes_meet_where_a_point_of_one_is_in_the_other(x, y, z, a, b):
    first, half = np.eye(4), np.array([0.05, 0.08, 0.02])
    second = poses.transform(poses.rotation_z(a) @ poses.rotation_x(b), (x, y, z))
    other = np.array([0.03, 0.06, 0.04])
    grid = np.stack(np.meshgrid(*3 * (np.linspace(-1.0, 1.0, 5),)), axis=-1).reshape(-1, 3)
    points = grid * other @ second[:3, :3].T + second[:3, 3]

    if np.any(np.all(np.abs(points) <= half, axis=1)):
        assert boxes_meet(first, half, second, other)
    assert boxes_meet(first, half, second, other) == boxes_meet(second, other, first, half)


def test_boxes_apart_along_an_edge_pair_alone_do_not_meet():
    first = poses.transform(poses.rotation_x(0.785), (0.0, 0.0, 0.0))
    second = poses.transform(poses.rotation_y(0.785), (0.0, 0.0, 0.15))
    half = np.array([0.05, 0.05, 0.05])

    assert not boxes_meet(first, half, second, half)
    assert boxes_meet(first, half, poses.transform(poses.rotation_y(0.785), (0.0, 0.0, 0.12)), half)
