"""What may stand inside a box or a bowl that is open at the top, and what may not."""

from dataclasses import replace

import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Ball, Box, Cylinder
from robots.errors import SceneError
from robots.scenes.hollow import hollow_parts
from robots.scenes.scene_description import SceneDescription, SceneItem
from robots.scenes.scene_rules import validate

WALL_M = 0.01
HEIGHT_M = 0.1


def item(name, shape, x, y, bottom_m=0.0, wall_m=None):
    kind = name.split()[-1]
    pose = poses.translation(x, y, bottom_m + 0.5 * shape.height_m)
    return SceneItem(name, kind, "red", shape, 0.2, 0.6, pose, wall_m)


BOX = item("box", Box((0.3, 0.2, HEIGHT_M)), 1.0, 0.0, wall_m=WALL_M)
BOWL = item("bowl", Cylinder(0.12, HEIGHT_M), 1.0, 0.0, wall_m=WALL_M)
BALL, CAN = Ball(0.035), Cylinder(0.03, 0.12)


def wrong_with(*items):
    scene = SceneDescription("kitchen", objects=items)
    try:
        validate(scene, "kitchen.toml")
    except SceneError as error:
        return error.reason
    return None


@pytest.mark.parametrize("hollow", [BOX, BOWL], ids=["box", "bowl"])
@pytest.mark.parametrize("order", [1, -1], ids=["after it", "before it"])
@pytest.mark.parametrize(
    "inner", [item("ball", BALL, 1.03, 0.01, WALL_M), item("can", CAN, 0.95, 0.0, WALL_M)]
)
def test_what_the_walls_leave_room_for_stands_inside(hollow, order, inner):
    assert wrong_with(*[hollow, inner][::order]) is None


def test_two_things_stand_side_by_side_inside():
    assert wrong_with(BOX, item("ball", BALL, 0.92, 0.0, WALL_M), item("can", CAN, 1.08, 0.0, WALL_M)) is None


@pytest.mark.parametrize(
    ("hollow", "inner"),
    [
        (BOX, item("ball", BALL, 1.11, 0.0, WALL_M)),  # through a wall
        (BOX, item("can", CAN, 1.0, 0.062, WALL_M)),  # 2 mm into a wall
        (BOX, item("ball", BALL, 1.0, 0.0, 0.0)),  # through the bottom
        (BOX, item("flat box", Box((0.285, 0.1, 0.05)), 1.0, 0.0, WALL_M)),  # wider than its inside
        (BOWL, item("ball", BALL, 1.08, 0.0, WALL_M)),
        (BOWL, item("can", CAN, 0.93, 0.07, WALL_M)),
    ],
)
@pytest.mark.parametrize("order", [1, -1], ids=["after it", "before it"])
def test_what_walls_or_bottom_are_in_the_way_of_is_refused(hollow, inner, order):
    assert "overlaps object" in wrong_with(*[hollow, inner][::order])


def test_nothing_stands_inside_a_solid_box():
    solid = replace(BOX, wall_m=None)

    assert wrong_with(solid, item("ball", BALL, 1.03, 0.01, WALL_M)) == "object 'ball' overlaps object 'box'"


@pytest.mark.parametrize("hollow", [BOX, BOWL], ids=["box", "bowl"])
def test_what_is_above_the_bottom_hangs_in_the_air(hollow):
    assert "hangs 0.0200 m" in wrong_with(hollow, item("ball", BALL, 1.0, 0.0, WALL_M + 0.02))


@pytest.mark.parametrize("hollow", [BOX, BOWL], ids=["box", "bowl"])
def test_a_lid_lies_on_the_rim_and_a_ball_does_not(hollow):
    lid = item("flat box", Box((0.4, 0.4, 0.02)), 1.0, 0.0, HEIGHT_M)

    assert wrong_with(hollow, lid) is None
    assert "hangs 0.0900 m" in wrong_with(hollow, item("ball", BALL, 1.0, 0.0, HEIGHT_M))


@pytest.mark.parametrize("hollow", [BOX, BOWL], ids=["box", "bowl"])
def test_its_parts_share_its_mass(hollow):
    assert sum(share for _, _, _, share in hollow_parts(hollow)) == pytest.approx(1.0)
