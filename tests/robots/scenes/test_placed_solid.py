"""Where solids lie to each other: what is under one, and whether two share room."""

import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Ball, Box, Cylinder
from robots.scenes.placed_solid import TOUCH_TOLERANCE_M, PlacedSolid, fall_m, lowest_m, overlap, top_m


def solid(shape, *place, yaw_rad=0.0):
    return PlacedSolid("a solid", shape, poses.transform(poses.rotation_z(yaw_rad), place))


CUBE = Box((0.2, 0.2, 0.2))


@pytest.mark.parametrize("shape", [CUBE, Cylinder(0.1, 0.2), Ball(0.1)])
def test_a_solid_reaches_half_its_height_up_and_down(shape):
    placed = solid(shape, 0.0, 0.0, 1.0)

    assert (lowest_m(placed), top_m(placed)) == pytest.approx((0.9, 1.1))


@pytest.mark.parametrize("shape", [CUBE, Cylinder(0.1, 0.2), Ball(0.1)])
def test_solids_that_touch_share_no_room_and_those_that_are_deeper_do(shape):
    below = solid(CUBE, 0.0, 0.0, 0.1)

    assert not overlap(solid(shape, 0.0, 0.0, 0.3 - 0.5 * TOUCH_TOLERANCE_M), below)
    assert overlap(solid(shape, 0.0, 0.0, 0.3 - 4.0 * TOUCH_TOLERANCE_M), below)


def test_a_turned_box_is_clear_of_a_corner_that_its_axes_would_meet():
    corner = solid(Box((0.02, 0.02, 0.2)), 0.13, 0.13, 0.1)

    assert not overlap(solid(CUBE, 0.0, 0.0, 0.1, yaw_rad=0.785), corner)
    assert overlap(solid(Box((0.3, 0.3, 0.2)), 0.0, 0.0, 0.1), corner)


def test_what_is_not_over_anything_falls_to_the_floor():
    table = solid(CUBE, 0.0, 0.0, 0.1)

    assert fall_m(solid(Ball(0.05), 0.0, 0.0, 0.3), [table]) == pytest.approx(0.05)
    assert fall_m(solid(Ball(0.05), 0.5, 0.0, 0.3), [table]) == pytest.approx(0.25)
