"""A scene's truth as solids."""

import numpy as np

from kinematics.geometry.shapes import Cylinder
from robots.scenes.scene_description import Person, SceneDescription
from robots.scenes.scene_file import load_scene
from robots.scenes.scene_solids import planning_scene


def test_every_thing_of_a_scene_is_a_solid_where_the_file_says():
    scene = load_scene("tabletop")

    solids = planning_scene(scene).objects

    assert set(solids) == {"table/top", *(f"table/leg_{i}" for i in range(1, 5)), "red cup", "blue box"}
    cup = next(item for item in scene.objects if item.name == "red cup")
    assert solids["red cup"].shape == cup.shape
    assert np.array_equal(solids["red cup"].world_T_object, cup.world_T_object)
    assert not solids["table/top"].movable
    assert {item.margin_m for item in solids.values()} == {0.0}


def test_the_margin_is_kept_from_each_of_them():
    solids = planning_scene(load_scene("clutter"), margin_m=0.02).objects

    assert {item.margin_m for item in solids.values()} == {0.02}


def test_a_person_stands_in_a_cylinder_on_the_floor():
    solids = planning_scene(SceneDescription("room", people=(Person("Ana", (1.5, 0.8), 3.14),))).objects

    person = solids["Ana"]
    assert isinstance(person.shape, Cylinder)
    assert np.allclose(person.world_T_object[:3, 3], (1.5, 0.8, person.shape.height_m / 2))
