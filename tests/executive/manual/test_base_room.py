"""Where a person may walk the robot with its hands anywhere: to nothing, and always away from it."""

import numpy as np
import pytest

from executive.manual.base_room import body_meets, slower, why_no_room
from executive.manual.words import BaseJog
from kinematics.geometry import poses
from kinematics.geometry.shapes import Box, Cylinder
from kinematics.model.robot_model import RobotModel
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from kinematics.walking.route.room import WalkingRoom
from kinematics.walking.route.swept_body import SweptBody
from robots.models.description import load_description

MODEL = RobotModel(load_description("talos"))
SETTINGS = MODEL.description.walking
Q = MODEL.q_home
HAND = MODEL.frame_pose(Q, "tcp_right")[:3, 3]
FORWARD, BACK, LEFT, RIGHT = BaseJog(0.2, 0.0), BaseJog(-0.2, 0.0), BaseJog(0.0, 0.3), BaseJog(0.0, -0.3)


def met(scene, word, q=Q):
    return body_meets(SweptBody(MODEL, q, scene, SETTINGS), SETTINGS, word)


def shelf(x, y, top_m=1.6):
    """A tall box of 0.2 m, seen from the right hand."""
    at = poses.translation(HAND[0] + x, HAND[1] + y, 0.5 * top_m)
    return PlanningScene().with_object(
        SceneObject("shelf", Box((0.2, 0.2, top_m)), at, margin_m=0.01, movable=False)
    )


@pytest.mark.requirement("S10")
@pytest.mark.parametrize(
    ("away_m", "word", "goes_on", "part"),
    [(0.35, FORWARD, BACK, "hand"), (-0.45, BACK, FORWARD, "arm")],
    ids=["ahead", "behind the elbow"],
)
def test_what_would_come_to_something_is_told_and_the_way_back_is_free(away_m, word, goes_on, part):
    scene = shelf(away_m, 0.0)

    assert met(scene, word) == f"the right {part} would come to the shelf"
    assert met(scene, goes_on) == ""


@pytest.mark.requirement("S10")
def test_a_turn_takes_the_hand_to_something_one_way_round_alone():
    scene = shelf(0.4, 0.0)

    assert "shelf" in met(scene, LEFT)
    assert met(scene, RIGHT) == ""


@pytest.mark.parametrize("scene", [shelf(0.35, 0.0, top_m=0.9), shelf(0.9, 0.0)], ids=["low", "far"])
def test_what_is_low_or_far_is_not_met(scene):
    assert met(scene, FORWARD) == ""


@pytest.mark.requirement("S10")
@pytest.mark.parametrize("word", [FORWARD, BACK])
def test_along_the_edge_of_a_table_beside_the_legs_both_ways_are_free(word):
    edge = np.array([[x, 0.5, 0.85] for x in np.linspace(-0.6, 0.6, 25)])

    assert why_no_room(WalkingRoom(SETTINGS), edge, SETTINGS, word) == ""


def test_what_is_ahead_of_the_legs_is_in_the_way_and_told_with_its_distance():
    edge = np.array([[0.45, y, 0.85] for y in np.linspace(-0.6, 0.6, 25)])

    assert "an obstacle is 0.14 m ahead" in why_no_room(WalkingRoom(SETTINGS), edge, SETTINGS, FORWARD)
    assert why_no_room(WalkingRoom(SETTINGS), edge, SETTINGS, BACK) == ""


def table(edge_x, top_m):
    """A thin board ahead of the robot, which a range sensor may look over and under."""
    at = poses.translation(edge_x + 0.3, 0.0, top_m - 0.02)
    return PlanningScene().with_object(
        SceneObject("table", Box((0.6, 1.4, 0.04)), at, margin_m=0.015, movable=False)
    )


@pytest.mark.requirement("S10")
@pytest.mark.parametrize(
    "word", [FORWARD, BaseJog(0.3, 0.4), BaseJog(0.3, -0.4)], ids=["ahead", "left", "right"]
)
def test_the_body_keeps_from_a_board_that_the_range_sensor_does_not_see(word):
    scene = table(0.29, 0.995)

    assert met(scene, word).endswith("would come to the table")
    assert met(scene, BACK) == ""


@pytest.mark.requirement("S10")
def test_a_turn_keeps_an_elbow_from_a_cup_that_the_hand_does_not_come_by():
    scene = PlanningScene().with_object(
        SceneObject("cup", Cylinder(0.03, 0.3), elbow_ahead(), margin_m=0.01, movable=True)
    )

    assert met(scene, LEFT) == "the right arm would come to the cup"
    assert met(scene, RIGHT) == ""


def elbow_ahead():
    """A place that the right elbow comes by when the robot turns to the left, and the hand does not."""
    elbow = MODEL.frame_pose(Q, "arm_right_4_link")[:3, 3]
    out_m, way = np.hypot(*elbow[:2]), np.arctan2(elbow[1], elbow[0])
    at = way + 0.55
    return poses.translation(out_m * np.cos(at), out_m * np.sin(at), elbow[2])


@pytest.mark.requirement("S10")
def test_an_arm_that_a_walk_would_sway_into_something_beside_it_is_in_the_way_of_every_walk():
    beside = poses.translation(HAND[0], HAND[1] - 0.13, HAND[2])
    scene = PlanningScene().with_object(
        SceneObject("cup", Cylinder(0.03, 0.3), beside, margin_m=0.01, movable=True)
    )

    assert "would come to the cup" in met(scene, BACK)


@pytest.mark.requirement("S10")
def test_a_walk_that_has_no_room_to_stop_at_its_speed_has_some_at_a_lower_one():
    edge = np.array([[-0.60, y, 0.85] for y in np.linspace(-0.3, 0.3, 13)])
    whys = [why_no_room(WalkingRoom(SETTINGS), edge, SETTINGS, one) for one in slower(BaseJog(-0.3, 0.4))]

    assert "an obstacle is 0.35 m behind" in whys[0]
    assert whys[1] == ""
    assert [one.angular_rad_s / one.linear_m_s for one in slower(BaseJog(-0.3, 0.4))] == pytest.approx(
        [-4.0 / 3.0] * 4
    )
