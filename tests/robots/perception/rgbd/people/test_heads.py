"""A head is seen whole: what the picture cuts off is not known to be free above."""

import pytest

from kinematics.geometry.shapes import Ball, Cylinder
from robots.perception.rgbd.eyes import Eyes
from tests.robots.perception.rgbd.conftest import TABLE_M, odom_T_camera, traced

CLOTHES, SKIN = (45, 67, 89), (167, 131, 109)
AHEAD_M, TRUNK_M = 1.6, 1.40
TRUNK = (Cylinder(0.12, TRUNK_M), AHEAD_M, 0.0, 0.0, CLOTHES, -TABLE_M + 0.05)
HEAD = (Ball(0.11), AHEAD_M, 0.0, 0.0, SKIN, TRUNK_M + 0.12 - TABLE_M)


@pytest.mark.requirement("P2")
@pytest.mark.parametrize("tilt_rad", [0.5, 0.6, 0.7])
def test_nobody_is_seen_whose_head_is_out_of_the_picture(tilt_rad):
    place = odom_T_camera(height_m=1.5, ahead_m=0.2, tilt_rad=tilt_rad)

    assert not Eyes().look(traced([TRUNK, HEAD], place=place)).people


NEAR_M = 0.95
CHEST = (Cylinder(0.15, 1.42), NEAR_M, 0.0, 0.0, CLOTHES, -TABLE_M)
NECK = (Cylinder(0.055, 0.14), NEAR_M, 0.0, 0.0, SKIN, 1.42 - TABLE_M)
ABOVE = (Ball(0.11), NEAR_M, 0.0, 0.0, SKIN, 1.53 - TABLE_M)


@pytest.mark.requirement("P2")
@pytest.mark.parametrize("tilt_rad", [0.44, 0.47, 0.5])
def test_a_neck_is_no_head(tilt_rad):
    place = odom_T_camera(height_m=1.65, ahead_m=0.2, tilt_rad=tilt_rad)

    assert not Eyes().look(traced([CHEST, NECK, ABOVE], place=place)).people
