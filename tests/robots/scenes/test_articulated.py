"""Scene files of what opens."""

import math

import pytest

from robots.errors import SceneError
from robots.scenes.articulated import moving_solids
from robots.scenes.scene_file import load_scene, read_scene
from robots.scenes.scene_writer import dump

FRIDGE = """
[[furniture]]
name = "fridge"
kind = "fridge"
size_m = [0.64, 0.60, 1.70]
position_m = [1.14, 0.50]
hinge = "right"
mass_kg = 11.0
friction_nm = 1.5
seal_n = 25.0
open_rad = 0.5
"""


def read(text):
    return read_scene(text, "kitchen.toml", "kitchen")


@pytest.mark.parametrize("name", ["fridge", "drawers"])
def test_a_scene_with_something_that_opens_is_written_as_it_is_read(name):
    scene = load_scene(name)

    assert read_scene(dump(scene), name, name) == scene


def test_a_door_takes_hinge_mass_friction_and_seal():
    part = read(FRIDGE).furniture[0].opens

    assert (part.hinge, part.mass_kg, part.friction, part.seal_n) == ("right", 11.0, 1.5, 25.0)
    assert part.opening == 0.5
    assert not part.locked


@pytest.mark.parametrize(
    ("line", "instead", "key"),
    [
        ('hinge = "right"', 'hinge = "top"', "furniture[0].hinge"),
        ("mass_kg = 11.0", "mass_kg = 0.0", "furniture[0].mass_kg"),
        ("open_rad = 0.5", "open_rad = 2.5", "furniture[0].open_rad"),
        ("open_rad = 0.5", "open_rad = 0.5\nlocked = true", "furniture[0].locked"),
        ("seal_n = 25.0", "seal_n = -1.0", "furniture[0].seal_n"),
        ('kind = "fridge"', 'kind = "drawers"', "furniture[0].hinge"),
        ("seal_n = 25.0", "handle_height_m = 3.0", "furniture[0].handle_height_m"),
    ],
)
def test_an_impossible_door_is_refused_with_its_key(line, instead, key):
    with pytest.raises(SceneError) as caught:
        read(FRIDGE.replace(line, instead))

    assert caught.value.key == key


def test_a_handle_is_on_the_side_away_from_the_hinge():
    (piece,) = read(FRIDGE).furniture

    bar = next(solid for solid in moving_solids(piece) if solid.kind == "handle")

    assert bar.part_T_solid[1, 3] > 0.4  # the hinge is on the right, at negative y
    assert bar.part_T_solid[0, 3] < -0.05  # before the door


def test_a_door_that_begins_open_reaches_into_the_room():
    scene = read(FRIDGE.replace("open_rad = 0.5", f"open_rad = {math.radians(60)}").replace("1.14", "0.70"))

    assert scene.furniture[0].opens is not None
