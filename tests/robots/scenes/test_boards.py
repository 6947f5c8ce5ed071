"""Shelves and counters: what they are made of, and where things stand on them."""

import numpy as np
import pytest

from robots.errors import SceneError
from robots.scenes import furniture
from robots.scenes.furniture import board_tops_m
from robots.scenes.scene_description import Furniture
from robots.scenes.scene_file import load_scene, read_scene
from robots.scenes.scene_writer import dump

SHELF = Furniture("shelf", "shelf", (0.34, 1.0, 1.22), (0.66, 0.1), yaw_rad=0.2)
COUNTER = Furniture("counter", "counter", (0.62, 1.8, 0.91), (0.64, 0.0))

FILE = """
[[furniture]]
name = "shelf"
kind = "shelf"
size_m = [0.34, 1.0, 1.22]
position_m = [0.66, 0.1]
yaw_rad = 0.2

[[object]]
name = "red cup"
kind = "cup"
radius_m = 0.03
height_m = 0.10
mass_kg = 0.2
friction = 0.6
on = "shelf"
position_m = [-0.10, -0.2]
"""


def corners(piece):
    """All corners of all its solids, in its own frame."""
    floor = np.linalg.inv(furniture.floor_pose(piece))
    for solid in furniture.solids(piece):
        pose = floor @ solid.world_T_solid
        for signs in np.ndindex(2, 2, 2):
            yield pose[:3, :3] @ ((np.array(signs) - 0.5) * solid.shape.size_m) + pose[:3, 3]


@pytest.mark.parametrize("piece", [SHELF, COUNTER], ids=lambda piece: piece.kind)
def test_a_piece_fills_its_size_and_no_more_and_its_top_comes_first(piece):
    found = np.array(list(corners(piece)))
    depth, width, height = piece.size_m

    assert found.min(axis=0) == pytest.approx([-depth / 2, -width / 2, 0.0])
    assert found.max(axis=0) == pytest.approx([depth / 2, width / 2, height])
    assert furniture.solids(piece)[0].name == f"{piece.name}/top"


def test_the_boards_of_a_shelf_are_about_forty_centimetres_apart():
    assert np.diff(board_tops_m(SHELF)) == pytest.approx([0.4, 0.4, 0.4])
    assert board_tops_m(COUNTER) == (0.91,)


def test_no_two_boards_and_sides_share_room():
    solids = furniture.solids(SHELF)
    floor = np.linalg.inv(furniture.floor_pose(SHELF))
    for i, one in enumerate(solids):
        for other in solids[:i]:
            apart = np.abs((floor @ (one.world_T_solid - other.world_T_solid))[:3, 3])
            room = 0.5 * (np.array(one.shape.size_m) + other.shape.size_m)
            assert np.any(apart >= room - 1e-9), (one.name, other.name)


@pytest.mark.parametrize(("board", "foot_m"), [(None, 1.22), (3, 1.22), (2, 0.82), (0, 0.02)])
def test_an_object_stands_on_the_board_that_is_named_or_on_the_top(board, foot_m):
    text = FILE if board is None else FILE.replace('on = "shelf"', f'on = "shelf"\nboard = {board}')
    item = read_scene(text, "a.toml", "a").objects[0]

    assert item.world_T_object[2, 3] - 0.05 == pytest.approx(foot_m)
    assert read_scene(dump(read_scene(text, "a.toml", "a")), "b.toml", "a").objects[0].world_T_object == (
        pytest.approx(item.world_T_object)
    )


@pytest.mark.parametrize("board", ["4", "-1", "1.0", "true", '"2"'])
def test_a_board_that_is_not_there_is_refused_with_its_key(board):
    with pytest.raises(SceneError, match="from 0 to 3") as caught:
        read_scene(FILE.replace('on = "shelf"', f'on = "shelf"\nboard = {board}'), "a.toml", "a")

    assert caught.value.key == "object[0].board"


def test_a_board_without_its_shelf_is_refused():
    free = FILE.replace('on = "shelf"', "board = 2").replace("[-0.10, -0.2]", "[0.6, 0.0, 0.87]")

    with pytest.raises(SceneError, match="needs the shelf"):
        read_scene(free, "a.toml", "a")


def test_what_stands_under_a_board_too_low_for_it_is_refused():
    tall = FILE.replace("height_m = 0.10", "height_m = 0.39").replace(
        '"shelf"\npos', '"shelf"\nboard = 1\npos'
    )

    with pytest.raises(SceneError, match="overlaps furniture 'shelf'"):
        read_scene(tall, "a.toml", "a")


def test_the_scenes_of_a_household_are_there():
    for name in ("shelf", "counter", "drawers", "fridge", "person", "dinner"):
        assert load_scene(name).name == name
