"""Doors and drawers of fixtures, as scene files say them."""

import math

import numpy as np
import pytest

from kinematics.geometry import poses
from robots.errors import SceneError
from robots.scenes.furniture import floor_pose
from robots.scenes.moving_parts import moving_parts
from robots.scenes.scene_file import load_scene, read_scene
from robots.scenes.scene_writer import dump

PIECE = """
robot_start = { x_m = -2.0, y_m = 0.0 }
[[furniture]]
name = "oven 2"
kind = "fixture"
size_m = [0.4, 0.5, 1.2]
position_m = [1.0, 0.0]
yaw_rad = 0.4
foot_m = 0.8
[[furniture.box]]
size_m = [0.4, 0.5, 0.01]
position_m = [0.0, 0.0, 1.195]
"""
DOOR = """
[[furniture.opening]]
name = "door"
kind = "door"
travel = 1.5
hinge = "left"
[[furniture.opening.box]]
size_m = [0.02, 0.5, 0.2]
position_m = [-0.21, 0.0, 1.05]
[furniture.opening.bar]
position_m = [-0.26, -0.2, 1.05]
length_m = 0.12
radius_m = 0.008
upright = true
"""
DRAWER = """
[[furniture.opening]]
name = "drawer"
kind = "drawer"
travel = 0.2
open = 0.1
[[furniture.opening.box]]
size_m = [0.02, 0.5, 0.1]
position_m = [-0.21, 0.0, 0.9]
[[furniture.opening.box]]
size_m = [0.3, 0.4, 0.004]
position_m = [-0.05, 0.0, 0.86]
[[furniture.opening.box]]
size_m = [0.3, 0.004, 0.08]
position_m = [-0.05, 0.2, 0.9]
[furniture.opening.bar]
position_m = [-0.25, 0.0, 0.9]
length_m = 0.12
radius_m = 0.008
"""


def piece_of(text):
    return read_scene(PIECE + text, "oven.toml", "oven").furniture[0]


def part_of(text):
    (part,) = moving_parts(piece_of(text))
    return part


def test_a_file_with_openings_reads_back_as_it_was_written():
    scene = load_scene("cabinet")

    assert read_scene(dump(scene), "again.toml", "cabinet").furniture == scene.furniture
    assert sum(len(piece.openings) for piece in scene.furniture) == 4


def test_a_door_turns_about_the_edge_of_its_front_and_its_bar_with_it():
    piece, part = piece_of(DOOR), part_of(DOOR)
    front, bar, *posts = part.solids
    shut = floor_pose(piece) @ part.furniture_T_part @ front.part_T_solid
    ajar = floor_pose(piece) @ part.furniture_T_part @ part.opened(0.7) @ front.part_T_solid

    assert part.name == "oven 2/door"
    assert (front.kind, bar.kind, len(posts)) == ("door", "handle", 2)
    assert poses.yaw_of(ajar[:3, :3]) - poses.yaw_of(shut[:3, :3]) == pytest.approx(-0.7)
    hinge = shut @ [0.0, 0.25, 0.0, 1.0]
    np.testing.assert_allclose(ajar @ [0.0, 0.25, 0.0, 1.0], hinge, atol=1e-12)
    assert part.lever_m == pytest.approx(0.45)


def test_a_drawer_slides_out_with_its_bottom_and_walls():
    piece, part = piece_of(DRAWER), part_of(DRAWER)
    kinds = [solid.kind for solid in part.solids if not solid.grasped]
    inwards = floor_pose(piece)[:3, 0]
    front = part.solids[0]
    begins = part.world_T_solid(floor_pose(piece), front)
    shut = floor_pose(piece) @ part.furniture_T_part @ front.part_T_solid

    assert kinds == ["drawer", "drawer bottom", "drawer wall"]
    np.testing.assert_allclose(begins[:3, 3], shut[:3, 3] - 0.1 * inwards, atol=1e-12)


def test_a_detector_that_knows_the_piece_tells_where_each_solid_is_while_shut():
    piece, part = piece_of(DOOR), part_of(DOOR)
    front, bar, *_ = part.solids
    told = part.known_part(floor_pose(piece), front, "oven")
    bars = part.known_part(floor_pose(piece), bar, "oven")

    assert (told.of, told.part, told.travel, told.side) == ("oven", "door", 1.5, 1.0)
    assert told.hinge_m == pytest.approx((0.0, 0.25))
    assert told.is_of(bars)
    assert not told.is_same(bars)


@pytest.mark.parametrize("name", ["fridge", "drawers"])
def test_what_is_of_a_usual_kind_is_known_by_no_model(name):
    piece = load_scene(name).furniture[0]
    (part,) = moving_parts(piece)

    assert part.name == piece.name
    assert part.known_part(floor_pose(piece), part.solids[0], name) is None


@pytest.mark.parametrize(
    ("before", "after", "key"),
    [
        ("travel = 1.5", "travel = 4.0", "opening[0].travel"),
        ('hinge = "left"', "", "opening[0].hinge"),
        ("travel = 1.5", "travel = 1.5\nopen = 1.6", "opening[0].open"),
        ("travel = 1.5", "travel = 1.5\nopen = 0.5\nlocked = true", "opening[0].locked"),
        ("radius_m = 0.008", "radius_m = 0.08", "opening[0].bar.radius_m"),
        ('name = "door"', 'name = "a/door"', "opening[0].name"),
        ("size_m = [0.02, 0.5, 0.2]", "size_m = [0.0, 0.5, 0.2]", "opening[0].box"),
        ("travel = 1.5", "travle = 1.5", "opening[0]"),
    ],
)
def test_what_cannot_be_an_opening_is_refused_by_its_key(before, after, key):
    assert before in DOOR
    with pytest.raises(SceneError) as refused:
        piece_of(DOOR.replace(before, after, 1))

    assert f"furniture[0].{key}" in str(refused.value)


def test_two_parts_of_one_name_are_refused():
    with pytest.raises(SceneError, match="another one of its parts"):
        piece_of(DOOR + DOOR)


def test_the_edge_of_a_front_is_a_hinge_where_no_other_is_said():
    piece = piece_of(DOOR.replace("travel = 1.5", "travel = 1.5\nhinge_m = [-0.1, 0.24]"))
    (part,) = moving_parts(piece)

    assert part.furniture_T_part[:2, 3] == pytest.approx([-0.1, 0.24])
    assert math.isclose(part_of(DOOR).furniture_T_part[1, 3], 0.25)
