"""Where there is room on a top, and beside what stands on it."""

import math

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from kinematics.scene.free_spots import GAP_M, spots_beside, spots_on
from kinematics.scene.planning_scene import PlanningScene, SceneObject

RADIUS_M = 0.04


def nowhere_in_particular(_place):
    return 0.0


def in_front_of(make, edge_m):
    """Spots on the robot's side of a cup whose middle is so far from the table's front edge."""
    table, cup = make.table(), make.cup(x=0.32 + edge_m)
    scene = PlanningScene().with_objects([table, cup])
    found = spots_beside(cup, table, scene, RADIUS_M, [math.pi], nowhere_in_particular)
    return cup, [spot.place_m for spot in found]


def turned_away_rad(cup, place):
    way = place[:2] - cup.world_T_object[:2, 3]
    return abs(math.remainder(math.atan2(way[1], way[0]) - math.pi, 2.0 * math.pi))


@pytest.mark.requirement("M3")
def test_what_goes_in_front_goes_straight_in_front_where_there_is_room(make):
    cup, places = in_front_of(make, 0.30)

    assert turned_away_rad(cup, places[0]) == pytest.approx(0.0, abs=1e-9)


@pytest.mark.requirement("M3")
def test_near_the_edge_it_goes_to_one_side_and_is_still_more_in_front_than_beside(make):
    cup, places = in_front_of(make, 0.172)

    assert places
    assert all(math.radians(30.0) < turned_away_rad(cup, place) < math.radians(45.0) for place in places)


@pytest.mark.requirement("M3")
def test_where_there_is_too_little_room_for_comfort_it_goes_as_near_to_the_edge_as_it_stands(make):
    cup, places = in_front_of(make, 0.14)

    assert places
    for place in places:
        assert place[0] - RADIUS_M >= 0.32 + 0.01 - 1e-9
        assert (
            np.linalg.norm(place[:2] - cup.world_T_object[:2, 3]) - RADIUS_M - cup.shape.radius_m
            >= 0.045 - 1e-9
        )
        assert turned_away_rad(cup, place) <= math.radians(45.0) + 1e-9


def test_a_tight_spot_is_not_taken_as_long_as_a_better_one_may_only_be_unseen(make):
    table, cup = make.table(), make.cup(x=0.32 + 0.172)
    scene = PlanningScene().with_objects([table, cup])

    found = spots_beside(
        cup, table, scene, RADIUS_M, [math.pi], nowhere_in_particular, known=lambda place: place[0] < 0.38
    )

    assert found == []


def test_at_the_very_edge_nothing_goes_in_front(make):
    _, places = in_front_of(make, 0.08)

    assert places == []


@pytest.mark.requirement("M3")
def test_every_spot_keeps_its_distance_from_what_stands_there(make):
    table, cups = make.table(), [make.cup(y=y, name=f"cup {y}") for y in (-0.3, 0.0, 0.25)]
    scene = PlanningScene().with_objects([table, *cups])

    found = spots_on(table, scene, RADIUS_M, nowhere_in_particular)

    assert found
    for spot in found:
        for cup in cups:
            apart_m = float(np.linalg.norm(spot.place_m[:2] - cup.world_T_object[:2, 3]))
            assert apart_m - RADIUS_M - cup.shape.radius_m >= GAP_M - 1e-9


def test_a_spot_whose_surroundings_were_not_seen_is_not_free(make):
    table = make.table()
    scene = PlanningScene().with_objects([table])

    found = spots_on(table, scene, RADIUS_M, nowhere_in_particular, known=lambda place: place[1] > 0.0)

    assert found
    assert all(spot.place_m[1] > 0.0 for spot in found)


@pytest.mark.requirement("M3")
@pytest.mark.parametrize("yaw_rad", [0.0, 0.3])
def test_a_wall_behind_a_table_takes_no_room_on_it_but_what_is_beside_the_wall(make, yaw_rad):
    table, cup = make.table(), make.cup(x=0.52)
    place = poses.translation(1.08, 0.0, 0.8) @ poses.transform(poses.rotation_z(yaw_rad), np.zeros(3))
    wall = SceneObject("wall", Box((0.1, 3.0, 1.6)), place, margin_m=0.015, movable=False)
    scene = PlanningScene().with_objects([table, cup, wall])

    beside = spots_beside(cup, table, scene, RADIUS_M, [0.5 * math.pi], nowhere_in_particular)
    anywhere = spots_on(table, scene, RADIUS_M, lambda spot: float(-spot[0]))

    assert beside
    assert anywhere
    for spot in (*beside, *anywhere):
        behind_m = -(poses.inverse(place) @ [*spot.place_m, 1.0])[0] - 0.05
        assert behind_m - RADIUS_M >= GAP_M - 1e-9
