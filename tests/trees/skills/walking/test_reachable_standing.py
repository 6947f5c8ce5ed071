"""Places to stand for an object: near the usual one, with room for body and arms."""

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.planar import PlanarPose
from kinematics.geometry.shapes import Box, Cylinder
from kinematics.model.stance import stance_at
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from kinematics.walking.route.path_planning import clearance_m, footprints
from robots.models.description import load_description
from trees.beliefs.grounding.destination import Place
from trees.skills.walking.reachable_standing import Stand, StandingRoom, places_about, stance_of

SETTINGS = load_description("talos").walking
USUAL = PlanarPose(5.25, 0.9, 0.0)
BOTTLE_M = (5.74, 0.9)
DOOR = SceneObject(
    "door", Box((0.04, 0.6, 1.6)), PlanarPose(5.25, 1.1, np.radians(70.0)).transform(0.9), movable=False
)
FRIDGE = SceneObject("fridge", Box((0.64, 0.6, 1.7)), poses.translation(5.88, 0.9, 0.85), movable=False)


def tried(*solids):
    about = footprints(PlanningScene().with_objects(solids))
    room = StandingRoom(USUAL, about, about, SETTINGS)
    return list(filter(room.has, places_about(USUAL, BOTTLE_M)))


def test_with_nothing_about_the_usual_place_comes_first():
    assert tried()[0] == USUAL


def test_nobody_stands_where_the_arms_would_be_in_an_open_door():
    door = footprints(PlanningScene().with_objects([DOOR]))

    places = tried(FRIDGE, DOOR)

    assert places
    assert USUAL not in places
    for body in places:
        hands = [body @ PlanarPose(0.2, side * 0.75) for side in (-1.0, 1.0)]
        assert min(clearance_m(door, hand) for hand in hands) > 0.03


def test_the_usual_place_keeps_its_own_distance_from_what_is_low_and_others_need_room():
    stool = SceneObject("stool", Box((0.3, 0.3, 0.4)), USUAL.transform(0.2), movable=False)
    room = StandingRoom(USUAL, footprints(PlanningScene().with_objects([stool])), (), SETTINGS)

    assert room.has(USUAL)
    assert not room.has(USUAL @ PlanarPose(-0.1))
    assert room.has(USUAL @ PlanarPose(0.0, 2.0))


def test_no_place_is_farther_from_the_object_than_an_arm_reaches():
    assert all(body.distance_m(PlanarPose(*BOTTLE_M)) <= 1.15 for body in tried())


def test_a_place_from_which_hands_get_there_better_is_asked_about_sooner():
    def reach(body):
        return 1.0 if body.to(USUAL).y_m > 0.05 else 0.1

    places = places_about(USUAL, BOTTLE_M, reach=reach)

    assert places[0].to(USUAL).y_m > 0.05
    assert USUAL in places


def test_where_no_hand_gets_there_one_is_asked_to_stand_after_places_farther_away():
    def reach(body):
        return 0.0 if body.distance_m(USUAL) < 0.15 else 0.9

    places = places_about(USUAL, BOTTLE_M, reach=reach)

    assert places[0].distance_m(USUAL) > 0.15
    assert set(places) == set(tried())


def test_a_stand_moves_with_the_thing_that_it_is_for():
    seen = Place("bottle", "object", Cylinder(0.03, 0.2), poses.translation(5.74, 0.9, 1.2), 0.9)
    again = Place("bottle", "object", Cylinder(0.03, 0.2), poses.translation(5.76, 0.87, 1.2), 0.9)

    stand = Stand.beside(seen, USUAL)

    assert stand.body(again).to(USUAL @ PlanarPose(0.02, -0.03)).x_m == pytest.approx(0.0)


def test_the_feet_are_moved_with_the_body(model):
    stance = stance_at(model, model.q_home)
    here = PlanarPose(0.3, -0.2, 0.4)

    moved = stance_of(stance, here, here @ PlanarPose(1.0, 0.0, 0.5))

    left, right = (PlanarPose.of(sole) for _, sole in moved.soles)
    apart = [PlanarPose.of(sole) for _, sole in stance.soles]
    assert left.distance_m(right) == pytest.approx(apart[0].distance_m(apart[1]))
    assert here.to(moved_middle := PlanarPose.between(left, right)).distance_m(PlanarPose()) > 0.5
    assert moved_middle.yaw_rad == pytest.approx(PlanarPose.between(*apart).yaw_rad + 0.5)


def cup_at(x_m, y_m):
    return Place("red cup", "object", Cylinder(0.03, 0.1), poses.translation(x_m, y_m, 0.9), 1.0)


def test_a_stand_holds_to_the_edge_that_is_seen_again_and_not_to_the_thing_alone():
    # From afar the table's edge was seen 2 cm nearer than it is.
    stand = Stand.beside(cup_at(2.0, 0.0), PlanarPose(1.4, 0.3), PlanarPose(1.4, 0.0))

    there = stand.seen_again(cup_at(2.0, 0.01), PlanarPose(1.42, 0.01))

    assert (there.x_m, there.y_m, there.yaw_rad) == pytest.approx((1.42, 0.31, 0.0))


def test_another_side_of_the_table_is_not_the_same_edge_seen_again():
    stand = Stand.beside(cup_at(2.0, 0.0), PlanarPose(1.4, 0.3), PlanarPose(1.4, 0.0))

    there = stand.seen_again(cup_at(2.0, 0.01), PlanarPose(2.0, 0.6, -1.57))

    assert (there.x_m, there.y_m) == pytest.approx((1.4, 0.31))
