"""What is put on top of another thing stands on what is flat, and covers what is open."""

from dataclasses import replace

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.convex_parts import ConvexParts
from kinematics.geometry.shapes import Ball, Box, Cylinder
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from kinematics.scene.support_of import furniture_right_below, support_of, supports_of
from robots.fake.fake_world import cup, table
from robots.perception.truth_view import TrueObject
from tests.trees.household_stage import run
from trees.beliefs.scene.believed_thing import Surroundings
from trees.skills.place.on_things import spots_on_thing, why_not_on
from trees.skills.place.placement import why_not_there
from trees.tasks import ObjectDescription, PickTask, PlaceTask

RED_CUP = ObjectDescription("cup", "red")
TABLE = SceneObject("table", Box((0.6, 1.2, 0.04)), poses.translation(0.6, 0.0, 0.88), movable=False)


def thing(shape, leans_rad=0.0, name="white box", place=(0.5, -0.1)):
    turn = poses.rotation_x(leans_rad)
    return SceneObject(name, shape, poses.transform(turn, (*place, 0.9 + 0.5 * shape.height_m)))


def box_of_parts(*sizes_and_places):
    """Boxes as convex parts: each (size, middle)."""
    unit = np.array([[x, y, z] for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)])
    hulls = [unit * size + place for size, place in sizes_and_places]
    ends = tuple(8 * (k + 1) for k in range(len(hulls)))
    return ConvexParts("boxes", np.concatenate(hulls), ends)


def open_box(wide_m, high_m):
    wall, half = 0.005, 0.5 * wide_m
    sides = [((wall, wide_m, high_m), (side * half, 0.0, 0.0)) for side in (1.0, -1.0)] + [
        ((wide_m, wall, high_m), (0.0, side * half, 0.0)) for side in (1.0, -1.0)
    ]
    bottom = ((wide_m, wide_m, wall), (0.0, 0.0, -0.5 * high_m))
    return Box((wide_m, wide_m, high_m), box_of_parts(*sides, bottom))


@pytest.mark.parametrize(
    ("below", "held", "told"),
    [
        (thing(Box((0.08, 0.06, 0.07))), Cylinder(0.03, 0.1), None),
        (thing(Cylinder(0.04, 0.02)), Cylinder(0.03, 0.1), None),
        (thing(Ball(0.05)), Cylinder(0.03, 0.1), "round"),
        (thing(Cylinder(0.012, 0.2)), Cylinder(0.03, 0.1), "too small"),
        (thing(Box((0.1, 0.1, 0.1)), 0.5), Cylinder(0.03, 0.1), "upright"),
        (thing(open_box(0.12, 0.08)), Cylinder(0.03, 0.1), "fall"),
        (thing(open_box(0.12, 0.08)), Box((0.19, 0.19, 0.02)), None),
    ],
)
def test_what_carries_and_what_does_not(below, held, told):
    failure = why_not_on(below, held)

    assert failure is None if told is None else told in failure.message


def spots(below, *others, shown=True):
    scene = PlanningScene().with_objects([TABLE, below, *others])
    return spots_on_thing(below, Cylinder(0.03, 0.1), scene, lambda _: 0.0, lambda _: shown)


def test_it_goes_on_the_middle_of_the_top():
    below = thing(Box((0.08, 0.06, 0.07)))

    (spot,) = spots(below)

    assert spot.place_m == pytest.approx((0.5, -0.1, 0.97))
    assert spots(below, shown=False) == []


def test_on_what_is_stacked_already_nothing_more_is_put_but_where_it_is_large():
    small, large = thing(Box((0.08, 0.06, 0.07))), thing(Box((0.3, 0.5, 0.07)))
    on_it = SceneObject("can", Cylinder(0.03, 0.1), poses.translation(0.5, -0.1, 1.02))

    assert "can is on the white box already" in spots(small, on_it).message
    assert all(np.linalg.norm(spot.place_m[:2] - (0.5, -0.1)) > 0.1 for spot in spots(large, on_it))


def test_what_stands_on_a_thing_is_on_the_furniture_below_that():
    below = thing(Box((0.08, 0.06, 0.07)))
    on_it = SceneObject("can", Cylinder(0.03, 0.1), poses.translation(0.5, -0.1, 1.02))
    scene = PlanningScene().with_objects([TABLE, below, on_it])

    assert supports_of(on_it, scene) == ["white box"]
    assert support_of(on_it, scene, 0.02).name == "table"
    assert support_of(on_it, scene.without_object("table"), 0.02) is None


def white_box(size=(0.10, 0.10, 0.06)):
    place = poses.translation(0.5, 0.15, 0.9 + 0.5 * size[2])
    return TrueObject("white box", "object", "box", "white", Box(size), place)


@pytest.mark.requirement("P4")
def test_a_cup_is_put_on_a_box_and_taken_off_it_again(stage_with):
    stage = stage_with(table(), cup(), white_box())

    tree = run(stage, PlaceTask("put the cup on the box", RED_CUP, on=ObjectDescription("box", "white")))

    place = stage.fake.world.object("red cup").world_T_object
    assert tree.status == "success", tree.failure
    assert tree.evidence["on"] == "white box"
    assert place[:3, 3] == pytest.approx((0.5, 0.15, 1.015), abs=0.015)

    again = run(stage, PickTask("pick up the cup", RED_CUP))

    assert again.status == "success", again.failure


@pytest.mark.parametrize(
    ("high_m", "told"), [(0.09, "no flat top of the wine rack seen"), (0.02, None)], ids=["high", "flat"]
)
def test_furniture_that_is_seen_and_has_no_flat_top_is_not_told_to_be_unseen(high_m, told):
    rack = SceneObject(
        "wine rack", Box((0.27, 0.14, high_m)), poses.translation(0.6, 0.3, 1.1), movable=False
    )
    scene = PlanningScene().with_objects([TABLE, rack])

    failure = why_not_there("wine rack", None, scene, Surroundings(()), 0.02)

    assert (failure.message if failure else None) == told


def test_furniture_that_is_not_seen_is_told_to_be_unseen():
    scene = PlanningScene().with_objects([TABLE])

    assert why_not_there("wine rack", None, scene, Surroundings(()), 0.02).message == "no wine rack seen"


STOVE = SceneObject("stove", Box((0.2, 0.4, 0.06)), poses.translation(0.5, 0.2, 0.93), 0.015, movable=False)
BURNER = SceneObject(
    "left burner", Box((0.15, 0.15, 0.002)), poses.translation(0.5, 0.3, 0.962), 0.015, movable=False
)
WITH_MARGIN = replace(TABLE, margin_m=0.015)


@pytest.mark.parametrize(
    ("place", "near"),
    [
        ((0.5, 0.3, 0.963), {"stove", "left burner"}),
        ((0.5, 0.1, 0.96), {"stove"}),
        ((0.5, -0.3, 0.9), {"table"}),
        ((0.5, -0.3, 0.912), {"table"}),
        ((0.5, -0.3, 0.95), set()),
    ],
    ids=["on a part of a stove", "on the stove", "on the table", "on a plate", "on a box"],
)
def test_what_is_put_down_may_come_near_the_furniture_right_below(place, near):
    scene = PlanningScene().with_objects([WITH_MARGIN, STOVE, BURNER])

    assert set(furniture_right_below(np.array(place), scene)) == near
