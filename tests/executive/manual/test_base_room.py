"""Where a person may walk the robot with its hands anywhere: to nothing, and always away from it."""

import numpy as np
import pytest

from executive.manual.base_room import hand_meets, why_no_room
from executive.manual.words import BaseJog
from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from kinematics.model.robot_model import RobotModel
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from kinematics.walking.route.room import WalkingRoom
from robots.models.description import load_description

MODEL = RobotModel(load_description("talos"))
SETTINGS = MODEL.description.walking
Q = MODEL.q_home
HAND = MODEL.frame_pose(Q, "tcp_right")[:3, 3]
FORWARD, BACK, LEFT, RIGHT = BaseJog(0.2, 0.0), BaseJog(-0.2, 0.0), BaseJog(0.0, 0.3), BaseJog(0.0, -0.3)


def shelf(x, y, top_m=1.6):
    """A tall box of 0.2 m, seen from the right hand."""
    at = poses.translation(HAND[0] + x, HAND[1] + y, 0.5 * top_m)
    return PlanningScene().with_object(
        SceneObject("shelf", Box((0.2, 0.2, top_m)), at, margin_m=0.01, movable=False)
    )


@pytest.mark.requirement("S10")
@pytest.mark.parametrize(("away_m", "word", "goes_on"), [(0.35, FORWARD, BACK), (-0.35, BACK, FORWARD)])
def test_a_hand_that_would_come_to_something_ahead_is_told_and_the_way_back_is_free(away_m, word, goes_on):
    scene = shelf(away_m, 0.0)

    assert hand_meets(MODEL, Q, scene, SETTINGS, word) == "the right hand would come to the shelf"
    assert hand_meets(MODEL, Q, scene, SETTINGS, goes_on) == ""


@pytest.mark.requirement("S10")
def test_a_turn_takes_the_hand_to_something_one_way_round_alone():
    scene = shelf(0.4, 0.0)

    assert "shelf" in hand_meets(MODEL, Q, scene, SETTINGS, LEFT)
    assert hand_meets(MODEL, Q, scene, SETTINGS, RIGHT) == ""


@pytest.mark.parametrize("scene", [shelf(0.35, 0.0, top_m=0.9), shelf(0.9, 0.0)], ids=["low", "far"])
def test_what_is_low_or_far_is_not_met(scene):
    assert hand_meets(MODEL, Q, scene, SETTINGS, FORWARD) == ""


@pytest.mark.requirement("S10")
@pytest.mark.parametrize("word", [FORWARD, BACK])
def test_along_the_edge_of_a_table_beside_the_legs_both_ways_are_free(word):
    edge = np.array([[x, 0.5, 0.85] for x in np.linspace(-0.6, 0.6, 25)])

    assert why_no_room(WalkingRoom(SETTINGS), edge, SETTINGS, word) == ""


def test_what_is_ahead_of_the_legs_is_in_the_way_and_told_with_its_distance():
    edge = np.array([[0.45, y, 0.85] for y in np.linspace(-0.6, 0.6, 25)])

    assert "an obstacle is 0.14 m ahead" in why_no_room(WalkingRoom(SETTINGS), edge, SETTINGS, FORWARD)
    assert why_no_room(WalkingRoom(SETTINGS), edge, SETTINGS, BACK) == ""
