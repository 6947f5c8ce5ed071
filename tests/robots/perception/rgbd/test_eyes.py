from dataclasses import replace

import cv2
import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Ball, Box, Cylinder
from robots.perception.rgbd.eyes import LEAST_THERE, Eyes, as_frame
from robots.perception.rgbd.shapes import CUT_SHARE
from robots.scenes.scene_description import Furniture

RED, BLUE, GREEN = (217, 26, 20), (31, 77, 204), (38, 153, 51)
WHITE = (240, 240, 240)
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


@pytest.mark.parametrize("radius_m", [0.020, 0.026, 0.034, 0.040])
@pytest.mark.parametrize("place", [(0.45, 0.2), (0.6, 0.0), (0.75, -0.2)])
def test_what_is_open_at_the_top_is_a_cup_however_narrow(take, beaker, radius_m, place):
    low = poses.transform(_camera()[:3, :3], (0.1, 0.0, 1.25))

    seen = Eyes().look(take([(beaker(radius_m, 0.11), *place, 0.0, RED)], place=low))

    (thing,) = seen.things
    assert (thing.solid.form, thing.call.kind, thing.call.alike) == ("beaker", "cup", ())


@pytest.mark.requirement("P2")
@pytest.mark.parametrize("aside_m", [0.0, -0.03])
def test_what_stands_in_a_bowl_is_seen_with_the_bowl(take, beaker, aside_m):
    low = poses.transform(_camera()[:3, :3], (0.2, 0.0, 1.3))
    bowl = (beaker(0.095, 0.064, wall_m=0.006), 0.6, 0.0, 0.0, WHITE)
    can = (Cylinder(0.0375, 0.115), 0.6 + aside_m, aside_m, 0.0, RED)

    seen = Eyes().look(take([bowl, can], place=low))

    told = sorted((thing.color, thing.call.kind) for thing in seen.things)
    assert told == [("red", "can"), ("white", "bowl")]


@pytest.mark.requirement("P2")
@pytest.mark.parametrize("aside_m", [-0.03, 0.0, 0.03])
def test_what_ends_at_the_rim_of_its_bowl_is_a_thing_of_its_own(take, beaker, aside_m):
    bowl = (beaker(0.104, 0.082, wall_m=0.006), 0.55, 0.0, 0.0, WHITE)
    can = (Cylinder(0.03, 0.075), 0.55 + aside_m, 0.01, 0.0, RED, 0.008)
    above = poses.transform(_camera(tilt_rad=1.2)[:3, :3], (0.25, 0.0, 1.4))

    seen = Eyes().look(take([bowl, can], place=above))

    told = sorted((thing.color, thing.call.kind) for thing in seen.things if thing.there > LEAST_THERE)
    assert told == [("red", "can"), ("white", "bowl")]


def test_a_top_that_came_back_nowhere_may_be_open_or_not(take):
    picture = take([(Cylinder(0.03, 0.11), 0.6, 0.0, 0.0, RED)])
    camera_T_odom = poses.inverse(picture.odom_T_camera)
    top = picture.pixels_of((camera_T_odom @ np.array([0.6, 0.0, TABLE_M + 0.11, 1.0]))[None, :3])[0]
    u, v = np.round(top).astype(int)
    picture.depth_m[v - 8 : v + 6, u - 9 : u + 10] = 0.0

    seen = Eyes().look(picture)

    (thing,) = seen.things
    assert {thing.call.kind, *thing.call.alike} >= {"can", "cup"}


@pytest.mark.parametrize("share", [0.6, 0.8])
def test_what_the_edge_of_the_picture_cuts_is_as_wide_as_what_is_seen_of_it_is_bent(take, share):
    shape = Cylinder(0.035, 0.12)
    picture = take([(shape, 0.6, 0.0, 0.0, RED)])
    columns = np.flatnonzero((picture.color == RED).all(axis=2).any(axis=0))
    last = int(columns[0] + share * len(columns))
    seen = Eyes().look(_without_columns_from(picture, last))

    (thing,) = seen.things
    assert thing.solid.form == "cylinder"
    assert thing.solid.place_m[:2] == pytest.approx((0.6, 0.0), abs=0.008)
    assert thing.solid.shape.radius_m == pytest.approx(0.035, abs=0.006)


def test_what_the_upper_edge_of_the_picture_cuts_has_no_height_that_could_be_relied_on(take):
    looking_down = take([(Cylinder(0.035, 0.12), 0.75, 0.0, 0.0, RED)])
    rows = np.flatnonzero((looking_down.color == RED).all(axis=2).any(axis=1))
    looking_down.depth_m[: (rows[0] + rows[-1]) // 2] = 0.0

    (thing,) = Eyes().look(looking_down).things

    assert "top" not in thing.solid.measured
    assert thing.solid.sigma_m[-1] >= 0.1
    assert {thing.call.kind, *thing.call.alike} >= {"can", "bottle", "cup"}


@pytest.mark.parametrize("tilt_rad", [0.02, 0.035])
def test_a_camera_that_was_knocked_is_corrected_by_what_is_level_and_tells_its_tilt(take, tilt_rad):
    shape, at = Cylinder(0.035, 0.12), (0.75, 0.1)
    told = _camera()
    told[:3, :3] = poses.rotation_y(tilt_rad) @ told[:3, :3]

    picture = take([(shape, *at, 0.0, RED)], place=_camera(), told=told)
    seen = Eyes().look(picture)

    (thing,) = seen.things
    assert as_frame(seen, picture, 1).tilt_rad == pytest.approx(tilt_rad, abs=0.002)
    assert thing.solid.place_m[:2] == pytest.approx(at, abs=0.003)


@pytest.mark.requirement("P2")
@pytest.mark.parametrize("away_m", [0.34, 0.36, 0.38])
def test_a_bottle_whose_foot_is_below_the_picture_is_a_bottle(take, away_m):
    """The table before it is not in the picture either."""
    bottle = (Cylinder(0.032, 0.18), away_m, 0.0, 0.0, WHITE)
    place = poses.transform(_camera(tilt_rad=0.75)[:3, :3], (0.15, 0.0, 1.4))

    (thing,) = Eyes().look(take([bottle], place=place)).things

    assert thing.solid.form == "cylinder"
    assert thing.solid.border > CUT_SHARE
    np.testing.assert_allclose(thing.solid.place_m[:2], (away_m, 0.0), atol=0.006)


def test_what_is_unsure_is_told_with_its_picture(take):
    picture = take([(Cylinder(0.035, 0.12), 0.6, 0.0, 0.0, RED)])
    seen = Eyes().look(picture)
    unsure = replace(seen, things=tuple(replace(thing, confidence=0.3) for thing in seen.things))

    (sure,) = [one for one in as_frame(seen, picture, 1).detections if one.category == "object"]
    (doubted,) = [one for one in as_frame(unsure, picture, 1).detections if one.category == "object"]

    assert sure.picture is None
    assert doubted.picture is not None
    shown = cv2.imdecode(np.frombuffer(doubted.picture, np.uint8), cv2.IMREAD_COLOR)
    assert (shown == np.array(RED[::-1])).all(axis=2).any()


@pytest.mark.requirement("P2")
@pytest.mark.parametrize(("height_m", "count"), [(0.0075, 0), (0.02, 1)])
def test_what_is_no_higher_than_the_bottom_of_a_cup_is_no_thing(take, height_m, count):
    disc = (Cylinder(0.025, height_m), 0.5, 0.0, 0.0, RED)

    assert len(Eyes().look(take([disc])).things) == count


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


def _without_columns_from(picture, last):
    """The same picture, with nothing beyond a column: as if it ended there."""
    picture.depth_m[:, last:] = 0.0
    return picture


def _camera(tilt_rad=0.8):
    c, s = np.cos(tilt_rad), np.sin(tilt_rad)
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
