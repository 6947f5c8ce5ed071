"""What somebody holds out is a thing; the arm and the fist are none."""

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Ball, Box, Cylinder
from robots.perception.rgbd.cloud import cloud_of
from robots.perception.rgbd.colors import smoothed_tint
from robots.perception.rgbd.labels import Call
from robots.perception.rgbd.people.find import SeenPerson
from robots.perception.rgbd.people.hands import held, in_hands
from tests.robots.perception.rgbd.conftest import TABLE_M, odom_T_camera, traced

SHIRT, SKIN, GREEN = (45, 67, 89), (167, 131, 109), (20, 120, 30)
AXIS_X = 1.5
TRUNK = (Cylinder(0.15, 0.55), AXIS_X, 0.0, 0.0, SHIRT, 0.1)
FOREARM = (Box((0.30, 0.07, 0.07)), AXIS_X - 0.25, -0.1, 0.0, SHIRT, 0.24)
FIST = (Ball(0.035), AXIS_X - 0.40, -0.1, 0.0, SKIN, 0.24)
PERSON = SeenPerson(poses.translation(AXIS_X, 0.0, 0.9), Cylinder(0.24, 1.75), ("standing",), 0.95, True)


def found(*more, people=(PERSON,), camera=None):
    """Places of the pieces that are found in the hands of somebody who holds these, shape (n, 3)."""
    camera = odom_T_camera(height_m=1.4, ahead_m=0.2, tilt_rad=0.25) if camera is None else camera
    cloud = cloud_of(traced([TRUNK, FOREARM, FIST, *more], place=camera))
    others = cloud.z < TABLE_M + 0.02
    held_out = in_hands(cloud, people, others, smoothed_tint(cloud.picture.color))
    pieces = held_out.segments
    assert len(held_out.lowest_m) == len(held_out.distinct) == pieces.count
    masks = [pieces.labels == number for number in range(1, pieces.count + 1)]
    return np.array([[np.median(axis[mask]) for axis in (cloud.x, cloud.y, cloud.z)] for mask in masks])


@pytest.mark.requirement("P2")
@pytest.mark.parametrize("color", [GREEN, SHIRT], ids=["of another colour", "of the shirt's colour"])
def test_what_stands_on_a_fist_is_one_piece(color):
    box = (Box((0.05, 0.05, 0.13)), AXIS_X - 0.40, -0.1, 0.0, color, 0.31)
    (place,) = found(box)

    assert place == pytest.approx([AXIS_X - 0.42, -0.1, TABLE_M + 0.375], abs=0.03)


@pytest.mark.requirement("P2")
def test_an_empty_hand_holds_nothing():
    assert len(found()) == 0


@pytest.mark.requirement("P2")
def test_what_is_held_right_before_the_trunk_is_told_by_its_colour():
    can = (Cylinder(0.03, 0.12), AXIS_X - 0.20, 0.02, 0.0, GREEN, 0.30)
    (place,) = found(can)

    assert place == pytest.approx([AXIS_X - 0.23, 0.02, TABLE_M + 0.36], abs=0.03)


def test_a_patch_on_the_clothes_is_nothing_that_is_held():
    belt = (Cylinder(0.152, 0.10), AXIS_X, 0.0, 0.0, GREEN, 0.30)
    patch = (Box((0.04, 0.10, 0.12)), AXIS_X - 0.132, 0.0, 0.0, GREEN, 0.45)

    assert len(found(belt)) == 0
    assert len(found(patch)) == 0


def test_the_body_of_who_stands_beside_is_not_in_ones_hands():
    beside = (Box((0.15, 0.16, 0.16)), AXIS_X, 0.55, 0.0, SKIN, 0.3)
    neighbour = SeenPerson(
        poses.translation(AXIS_X, 0.55, 0.9), Cylinder(0.24, 1.75), ("standing",), 0.95, True
    )
    assert len(found(beside, people=(PERSON, neighbour))) == 0


@pytest.mark.parametrize(("size_m", "told"), [((0.06, 0.06, 0.20), 1), ((0.06, 0.16, 0.20), 0)])
def test_what_goes_on_below_the_picture_is_a_leg_only_where_it_is_wide(size_m, told):
    hangs = (Box(size_m), AXIS_X - 0.24, 0.0, 0.0, GREEN, 0.02)
    low = odom_T_camera(height_m=1.4, ahead_m=0.4, tilt_rad=0.17)

    assert len(found(hangs, camera=low)) == told


def test_a_slim_thing_on_a_hand_may_be_any_slim_kind():
    assert set(held(Call("can", 0.9)).alike) == {"cup", "bottle", "box"}
    assert held(Call("ball", 0.9)).alike == ()
