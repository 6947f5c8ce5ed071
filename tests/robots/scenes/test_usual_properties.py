"""What a scene does not say about an object is as household things of its kind and size are."""

import pytest

from kinematics.geometry.shapes import Ball, Box, Cylinder
from robots.outside import known_scenes
from robots.scenes.scene_file import load_scene, read_scene
from robots.scenes.scene_words import CYLINDER_KINDS, HOLLOW_KINDS, OBJECT_KINDS
from robots.scenes.usual_properties import HEAVIEST_KG, LIGHTEST_KG, USUAL_FRICTION, usual_mass_kg

IT = '[[object]]\nname = "it"\nposition_m = [1.0, 0.0, 0.05]\n'
TABLE = """
[[furniture]]
name = "table"
kind = "table"
size_m = [0.6, 1.2, 0.9]
position_m = [0.65, 0.0]
"""


def size_of(kind):
    if kind == "ball":
        return "radius_m = 0.03"
    return "radius_m = 0.03\nheight_m = 0.11" if kind in CYLINDER_KINDS else "size_m = [0.06, 0.08, 0.1]"


@pytest.mark.parametrize("kind", OBJECT_KINDS)
def test_name_kind_and_size_are_enough_for_an_object_on_a_table(kind):
    text = f'{TABLE}[[object]]\nname = "thing"\nkind = "{kind}"\n{size_of(kind)}\non = "table"\n'
    (item,) = read_scene(text, "kitchen.toml", "kitchen").objects

    assert item.friction == USUAL_FRICTION
    assert LIGHTEST_KG < item.mass_kg < 0.6
    assert item.world_T_object[:2, 3] == pytest.approx([0.65, 0.0])


@pytest.mark.parametrize("kind", HOLLOW_KINDS)
def test_a_hollow_thing_has_the_mass_of_its_walls(kind):
    shape = Cylinder(0.08, 0.06) if kind == "bowl" else Box((0.2, 0.24, 0.1))

    masses = [usual_mass_kg(kind, shape, wall_m) for wall_m in (0.003, 0.006, 0.012)]

    assert masses == sorted(masses)
    assert 0.2 < masses[1] < 1.0


@pytest.mark.parametrize("name", known_scenes())
def test_the_usual_mass_is_near_to_what_the_scenes_that_come_along_say(name):
    for item in load_scene(name).objects:
        assert 0.5 < usual_mass_kg(item.kind, item.shape, item.wall_m) / item.mass_kg < 2.0, item.name


def test_no_mass_is_absurd():
    assert usual_mass_kg("box", Box((2.0, 2.0, 2.0))) == HEAVIEST_KG
    assert usual_mass_kg("ball", Ball(0.002)) == LIGHTEST_KG
    assert usual_mass_kg("ball", Ball(1e200)) == HEAVIEST_KG
    assert usual_mass_kg("box", Box((-1.0, 1.0, 1.0)), 0.5) == LIGHTEST_KG


@pytest.mark.parametrize("kind", ["cup", "bottle", "can", "bowl"])
def test_what_a_file_does_not_say_weighs_as_its_own_kind_does(kind):
    (item,) = read_scene(f'{IT}kind = "{kind}"\nradius_m = 0.04\nheight_m = 0.1', "a.toml", "a").objects

    assert item.mass_kg == usual_mass_kg(kind, item.shape)


def test_a_kind_of_ones_own_weighs_as_what_it_is_shaped_like():
    (item,) = read_scene(f'{IT}kind = "sponge"\nsize_m = [0.1, 0.06, 0.1]', "a.toml", "a").objects

    assert item.mass_kg == usual_mass_kg("box", item.shape)
