"""A shut door tells where its fridge is; an open one does not."""

import pytest

from kinematics.geometry.planar import PlanarPose
from kinematics.geometry.shapes import Box
from robots.perception.object_estimate import ObjectEstimate
from trees.beliefs.grounding.destination import Place
from trees.skills.walk_to.see_front import behind

FRIDGE = Place("fridge", "furniture", Box((0.6, 0.6, 0.02)), PlanarPose(5.0, 1.0, 0.5).transform(1.7), 0.9)


def door(x_m, y_m, yaw_rad):
    """Seen in the frame of the fridge as it was believed to stand."""
    pose = (PlanarPose(5.0, 1.0, 0.5) @ PlanarPose(x_m, y_m, yaw_rad)).transform(0.9)
    return ObjectEstimate("furniture", "door", None, pose, Box((0.04, 0.6, 1.6)), 0.9, 8, 0.0)


def test_a_shut_door_moves_the_fridge_behind_it():
    place = behind(FRIDGE, door(-0.30, 0.02, 0.01))

    moved = PlanarPose(5.0, 1.0, 0.5).to(PlanarPose.of(place.odom_T_place))
    assert (moved.x_m, moved.y_m) == pytest.approx((0.03, 0.02))
    assert place.odom_T_place[2, 3] == FRIDGE.odom_T_place[2, 3]


def test_an_open_door_leaves_it_where_it_was_believed_to_be():
    assert behind(FRIDGE, door(-0.6, 0.3, 1.2)) is FRIDGE
