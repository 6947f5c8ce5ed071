"""Furniture of a map that is wrong by centimetres, as a picture of it shows where it is and how far open."""

import math
from dataclasses import replace

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Box, Cylinder
from robots.interface.depth_camera import DepthCamera
from robots.perception.rgbd.eyes import Eyes
from robots.scenes.articulated import furniture_T_part, moving_solids, opened
from robots.scenes.furniture import floor_pose, solids
from robots.scenes.scene_description import Furniture, MovingPart
from tests.robots.perception.rgbd.conftest import EXACT, TABLE_M, traced

CAMERA = DepthCamera("test", "optical", 260.0, 320, 240, errors=EXACT)
WHITE, GREEN = (225, 228, 230), (38, 153, 51)
AHEAD_M = 6.0
"""Far beyond the table that every traced picture has."""


def fridge(hinge="left", opening=0.0):
    part = MovingPart(hinge=hinge, mass_kg=10.0, friction=2.0, opening=opening, handle_height_m=1.05)
    return Furniture("fridge", "fridge", (0.64, 0.60, 1.7), (AHEAD_M, 0.3), 0.1, opens=part)


def chest(opening=0.0):
    part = MovingPart(
        hinge=None, mass_kg=4.0, friction=8.0, opening=opening, handle_height_m=0.0, handle_length_m=0.16
    )
    return Furniture("chest", "drawers", (0.50, 0.45, 1.02), (AHEAD_M, 0.3), 0.0, opens=part)


def boxes_of(piece):
    """The piece as things of a picture."""
    placed = [(one.shape, one.world_T_solid) for one in solids(piece)]
    part = floor_pose(piece) @ furniture_T_part(piece) @ opened(piece, piece.opens.opening)
    placed += [(one.shape, part @ one.part_T_solid) for one in moving_solids(piece)]
    made = []
    for shape, pose in placed:
        if isinstance(shape, Cylinder) and abs(pose[2, 2]) < 0.5:  # a bar that lies
            shape = Box((2 * shape.radius_m, shape.height_m, 2 * shape.radius_m))
        low = pose[2, 3] - 0.5 * shape.height_m
        yaw = poses.yaw_of(pose[:3, :3]) if isinstance(shape, Box) else 0.0
        made.append((shape, pose[0, 3], pose[1, 3], yaw, WHITE, low - TABLE_M))
    return made


def seen_by_eyes(piece, *more, height_m=1.55, away_m=1.15, tilt_rad=0.45, turn_rad=0.15, whole_first=False):
    """What eyes find of a piece that stands elsewhere than on their map.

    With ``whole_first`` they have seen it before, without what is before it.
    """
    c, s = np.cos(tilt_rad), np.sin(tilt_rad)
    level = np.array([[0.0, -s, c], [-1.0, 0.0, 0.0], [0.0, -c, -s]])
    place = poses.transform(poses.rotation_z(turn_rad) @ level, (AHEAD_M - away_m, 0.1, height_m))
    x, y = piece.position_m
    believed = replace(
        piece,
        position_m=(x + 0.05, y - 0.04),
        yaw_rad=piece.yaw_rad + 0.01,
        opens=replace(piece.opens, opening=0.0),
    )
    eyes = Eyes([believed])
    if whole_first:
        eyes.look(traced(boxes_of(piece), camera=CAMERA, place=place))
    return eyes.look(traced([*boxes_of(piece), *more], camera=CAMERA, place=place))


def told(seen, kind):
    (piece,) = [one for one in seen.furniture if one.kind == kind]
    return piece


def truth(piece, kind):
    part = floor_pose(piece) @ furniture_T_part(piece) @ opened(piece, piece.opens.opening)
    return part @ next(one for one in moving_solids(piece) if one.kind == kind).part_T_solid


@pytest.mark.parametrize("hinge", ["left", "right"])
@pytest.mark.parametrize("degrees", [0.0, 15.0, 45.0])
def test_a_door_is_seen_where_it_is_and_as_far_open(hinge, degrees):
    piece = fridge(hinge, math.radians(degrees))

    door = told(seen_by_eyes(piece), "door").odom_T_solid

    real = truth(piece, "door")
    assert door[:3, 3] == pytest.approx(real[:3, 3], abs=0.010)
    assert poses.yaw_of(door[:3, :3]) == pytest.approx(poses.yaw_of(real[:3, :3]), abs=math.radians(1.0))


@pytest.mark.parametrize("hinge", ["left", "right"])
def test_a_handle_is_a_bar_that_is_measured_before_the_door(hinge):
    piece = fridge(hinge)

    bar = told(seen_by_eyes(piece), "handle")

    assert bar.odom_T_solid[:2, 3] == pytest.approx(truth(piece, "handle")[:2, 3], abs=0.006)
    assert bar.shape.radius_m == pytest.approx(0.0125, abs=0.004)
    assert abs(bar.odom_T_solid[2, 2]) > 0.99


def test_a_drawer_is_seen_as_far_open_with_its_inside():
    piece = chest(0.22)

    seen = seen_by_eyes(piece, tilt_rad=0.6)

    front, real = told(seen, "drawer").odom_T_solid, truth(piece, "drawer")
    assert front[:3, 3] == pytest.approx(real[:3, 3], abs=0.008)
    assert told(seen, "drawer bottom").odom_T_solid[:3, 3] == pytest.approx(
        truth(piece, "drawer bottom")[:3, 3], abs=0.010
    )


def test_the_bar_of_a_drawer_lies():
    bar = told(seen_by_eyes(chest(), tilt_rad=0.6), "handle")

    assert abs(bar.odom_T_solid[2, 2]) < 0.01
    assert bar.odom_T_solid[:3, 3] == pytest.approx(truth(chest(), "handle")[:3, 3], abs=0.010)


def test_a_fridge_is_nobody_and_its_walls_are_no_things():
    seen = seen_by_eyes(fridge("left", math.radians(75.0)))

    assert not seen.people
    assert not seen.things


def test_what_stands_in_an_open_fridge_is_a_thing():
    piece = fridge("left", math.radians(80.0))
    board_m = 0.65 * 1.7 + 0.01
    bottle = (Cylinder(0.033, 0.18), AHEAD_M - 0.13, 0.28, 0.0, GREEN, board_m - TABLE_M)

    seen = seen_by_eyes(piece, bottle, tilt_rad=0.5)

    (thing,) = seen.things
    assert (thing.color, thing.call.kind) == ("green", "bottle")
    assert thing.solid.place_m == pytest.approx((AHEAD_M - 0.13, 0.28, board_m + 0.09), abs=0.008)


def test_a_front_whose_outline_is_out_of_the_picture_is_where_the_map_has_it():
    """Its points are in the picture, its edges are not: only the middle of a wide board close by."""
    wide = replace(chest(), size_m=(0.50, 2.4, 1.9))

    seen = seen_by_eyes(wide)

    assert {one.kind for one in seen.furniture} == {"drawers"}
    assert not seen.things


@pytest.mark.parametrize("whole_first", [True, False])
def test_a_handle_of_which_a_part_is_hidden_is_as_long_as_it_was_seen_before(whole_first):
    piece = fridge()
    handle = truth(piece, "handle")[:3, 3]
    arm = (Box((0.06, 0.12, 0.12)), handle[0] - 0.15, handle[1], 0.0, GREEN, handle[2] + 0.1 - TABLE_M)
    bar = told(seen_by_eyes(piece, arm, whole_first=whole_first), "handle")

    length_m = next(one for one in moving_solids(piece) if one.kind == "handle").shape.height_m
    assert (abs(bar.shape.height_m - length_m) < 0.03) == whole_first
    assert (abs(bar.odom_T_solid[2, 3] - handle[2]) < 0.02) == whole_first
