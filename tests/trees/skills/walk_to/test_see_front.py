"""A shut door tells where its fridge is; an open one does not."""

import pytest

from kinematics.geometry.planar import PlanarPose
from kinematics.geometry.shapes import Box
from robots.perception.object_estimate import ObjectEstimate
from trees.beliefs.grounding.destination import Place
from trees.failures import Failure
from trees.skills.walk_to.see_front import behind, told_by_front

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


def seen(kind, x_m, y_m):
    pose = PlanarPose(x_m, y_m).transform(0.4)
    return ObjectEstimate("furniture", kind, None, pose, Box((0.4, 0.6, 0.4)), 0.9, 8, 0.0)


CHEST = Place("drawers", "furniture", Box((0.4, 0.6, 0.4)), PlanarPose(1.0, 0.0).transform(0.3), 0.9)


def test_an_open_door_tells_nothing_new_and_leaves_the_fridge_where_it_was_believed_to_be():
    assert behind(FRIDGE, door(-0.6, 0.3, 1.2)) is None
    assert told_by_front(FRIDGE, "fridge", {"door": door(-0.6, 0.3, 1.2)}) is FRIDGE


def test_a_chest_that_shows_itself_beside_its_drawer_is_looked_at_itself():
    told = told_by_front(
        CHEST, "drawers", {"drawer": seen("drawer", 0.8, 0.0), "drawers 2": seen("drawers", 1.02, 0.01)}
    )

    assert isinstance(told, Failure)
    assert "seen itself" in told.message


def test_a_chest_of_which_only_a_drawer_is_seen_is_where_it_was_believed_to_be():
    assert told_by_front(CHEST, "drawers", {"drawer": seen("drawer", 0.8, 0.0)}) is CHEST


@pytest.mark.parametrize(
    "others", [{}, {"drawer": seen("drawer", 3.0, 0.0)}, {"door": seen("door", 0.8, 0.0)}]
)
def test_a_front_of_something_else_does_not_tell_where_a_chest_is(others):
    assert isinstance(told_by_front(CHEST, "drawers", others), Failure)
