import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Ball, Box, Cylinder
from robots.perception.rgbd.eyes import Eyes
from robots.scenes.scene_description import Furniture

RED, BLUE, GREEN = (217, 26, 20), (31, 77, 204), (38, 153, 51)
TABLE_M = 0.8


@pytest.mark.parametrize(
    ("shape", "form"),
    [
        (Cylinder(0.035, 0.12), "cylinder"),
        (Cylinder(0.025, 0.08), "cylinder"),
        (Box((0.06, 0.09, 0.10)), "box"),
        (Box((0.04, 0.05, 0.15)), "box"),
        (Ball(0.04), "ball"),
    ],
)
@pytest.mark.parametrize("place", [(0.6, 0.0), (0.7, 0.2), (0.55, -0.15)])
def test_a_thing_on_a_table_is_measured_to_two_millimetres(take, shape, form, place):
    seen = Eyes().look(take([(shape, *place, 0.4, RED)]))

    (thing,) = seen.things
    assert thing.solid.form == form
    middle = (*place, TABLE_M + 0.5 * shape.height_m)
    assert thing.solid.place_m == pytest.approx(middle, abs=0.002)
    assert extents(thing.solid.shape) == pytest.approx(extents(shape), abs=0.003)


def test_things_that_stand_apart_are_told_apart_with_their_colours(take):
    things = [
        (Cylinder(0.035, 0.12), 0.60, 0.15, 0.0, RED),
        (Box((0.06, 0.06, 0.10)), 0.60, -0.15, 0.3, BLUE),
        (Ball(0.04), 0.80, 0.0, 0.0, GREEN),
    ]

    seen = Eyes().look(take(things))

    assert {(thing.color, thing.call.kind) for thing in seen.things} == {
        ("red", "can"),
        ("blue", "box"),
        ("green", "ball"),
    }


def test_things_of_two_colours_that_touch_are_two(take):
    things = [
        (Box((0.06, 0.06, 0.10)), 0.6, 0.0305, 0.0, RED),
        (Box((0.06, 0.06, 0.10)), 0.6, -0.0305, 0.0, BLUE),
    ]

    seen = Eyes().look(take(things))

    assert sorted(str(thing.color) for thing in seen.things) == ["blue", "red"]


def test_warm_light_changes_no_colour(take):
    things = [(Cylinder(0.035, 0.12), 0.6, 0.0, 0.0, (242, 242, 242))]

    seen = Eyes().look(take(things, tint=(1.0, 0.76, 0.48)))

    assert seen.light.known
    assert [thing.color for thing in seen.things] == ["white"]


def test_a_camera_that_is_believed_to_look_elsewhere_is_corrected_by_what_is_level(take):
    """Three thousandths of a radian move what is a metre away by three millimetres."""
    shape, at = Cylinder(0.035, 0.12), (0.75, 0.1)
    real = poses.transform(np.eye(3), (0.0, 0.0, 0.0)) @ _camera()
    told = real.copy()
    told[:3, :3] = poses.rotation_y(0.006) @ real[:3, :3]

    seen = Eyes().look(take([(shape, *at, 0.0, RED)], place=real, told=told))

    (thing,) = seen.things
    assert seen.tilt_rad == pytest.approx(0.006, abs=0.001)
    assert thing.solid.place_m[:2] == pytest.approx(at, abs=0.002)


def test_what_a_hand_holds_over_the_table_hangs_there_and_does_not_stand(take):
    shape = Cylinder(0.03, 0.12)

    seen = Eyes().look(take([(shape, 0.6, 0.0, 0.0, RED, 0.08)]))

    (thing,) = seen.things
    assert thing.solid.lifted_m == pytest.approx(0.08, abs=0.01)
    assert thing.solid.place_m[2] == pytest.approx(TABLE_M + 0.08 + 0.06, abs=0.008)


def test_what_stands_behind_something_lower_still_stands(take):
    things = [
        (Box((0.05, 0.14, 0.06)), 0.55, 0.0, 0.0, BLUE),
        (Cylinder(0.03, 0.14), 0.65, 0.0, 0.0, RED),
    ]

    seen = Eyes().look(take(things))

    (behind,) = [thing for thing in seen.things if thing.color == "red"]
    assert behind.solid.lifted_m == 0.0
    assert behind.solid.place_m[2] == pytest.approx(TABLE_M + 0.07, abs=0.005)


def test_an_empty_table_shows_a_table_and_nothing_on_it(take):
    seen = Eyes().look(take([]))

    assert not seen.things
    assert seen.surfaces[0].height_m == pytest.approx(TABLE_M, abs=0.002)


def test_a_table_of_the_map_is_put_where_its_edges_are_seen(take):
    """The map has it five centimetres too far away, and turned."""
    known = Furniture("table", "table", (0.8, 1.2, 0.82), (0.75, 0.03), 0.015)

    seen = Eyes([known]).look(take([]))

    top = seen.furniture[0]
    assert top.kind == "table"
    assert top.odom_T_solid[:2, 3] == pytest.approx((0.7, 0.0), abs=0.012)
    assert poses.yaw_of(top.odom_T_solid[:3, :3]) == pytest.approx(0.0, abs=0.01)
    assert top.odom_T_solid[2, 3] + 0.5 * top.shape.height_m == pytest.approx(TABLE_M, abs=0.002)


def test_a_table_that_no_map_knows_is_told_as_far_as_it_is_seen(take):
    seen = Eyes().look(take([]))

    assert [(piece.kind, sorted(piece.assumed)) for piece in seen.furniture] == [("table", ["edges", "legs"])]


def test_what_is_the_robot_itself_is_no_thing(take):
    picture = take([(Cylinder(0.035, 0.12), 0.6, 0.0, 0.0, RED)])
    picture.own[:] = True

    assert not Eyes().look(picture).things


def test_a_picture_without_any_depth_shows_nothing(take):
    picture = take([])
    picture.depth_m[:] = 0.0

    seen = Eyes().look(picture)

    assert not seen.things
    assert not seen.furniture


def extents(shape):
    if isinstance(shape, Box):
        return (*sorted(shape.size_m[:2]), shape.size_m[2])
    return (2 * shape.radius_m, 2 * shape.radius_m, shape.height_m)


def _camera():
    c, s = np.cos(0.8), np.sin(0.8)
    rotation = np.array([[0.0, -s, c], [-1.0, 0.0, 0.0], [0.0, -c, -s]])
    return poses.transform(rotation, (0.1, 0.0, 1.5))


def crate(x, y, yaw, rgb, size=(0.18, 0.15, 0.10), wall_m=0.006):
    """An open box of four walls, as things of a picture; what it stands on is its bottom."""
    depth, width, height = size
    turn = poses.rotation_z(yaw)
    walls = [
        (Box((depth, wall_m, height)), (0.0, side * 0.5 * (width - wall_m), 0.0)) for side in (-1.0, 1.0)
    ] + [(Box((wall_m, width, height)), (side * 0.5 * (depth - wall_m), 0.0, 0.0)) for side in (-1.0, 1.0)]
    return [(wall, *np.add((turn @ place)[:2], (x, y)), yaw, rgb) for wall, place in walls]


BROWN = (120, 72, 40)


def test_an_open_box_is_one_thing_as_high_as_its_rim(take):
    seen = Eyes().look(take(crate(0.65, 0.0, 0.3, BROWN)))

    (thing,) = seen.things
    assert thing.call.kind == "box"
    assert extents(thing.solid.shape) == pytest.approx(extents(Box((0.18, 0.15, 0.10))), abs=0.012)
    assert thing.solid.shape.height_m == pytest.approx(0.10, abs=0.004)


def test_what_is_in_an_open_box_is_seen_with_the_box(take):
    can = (Cylinder(0.033, 0.11), 0.65, 0.01, 0.0, RED)

    seen = Eyes().look(take([*crate(0.65, 0.0, 0.3, BROWN), can]))

    assert sorted((thing.color, thing.call.kind) for thing in seen.things) == [
        ("brown", "box"),
        ("red", "can"),
    ]
