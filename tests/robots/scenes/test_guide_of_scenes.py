"""What the guide writes down is a scene."""

import re
from pathlib import Path

from robots.scenes.importing.import_object import import_object
from robots.scenes.scene_file import read_scene
from tests import foreign_meshes as foreign

GUIDE = (Path(__file__).parents[3] / "docs" / "extend" / "a-scene.md").read_text("utf-8")
BLOCKS = re.findall(r"```toml\n(.*?)```", GUIDE, re.DOTALL)
BREAKFAST, MESH, FRIDGE, CABINET, STOVE, REGION, ROOMS, CAMERA = BLOCKS


def test_the_guides_scene_can_be_read():
    scene = read_scene(BREAKFAST, "breakfast.toml", "breakfast")

    assert [item.name for item in scene.objects] == ["yellow bowl", "red cup"]
    assert scene.people[0].takes


def test_the_guides_fridge_opens():
    scene = read_scene(FRIDGE, "fridge.toml", "fridge")

    assert scene.furniture[0].opens.hinge == "left"


def test_the_guides_cabinet_has_a_drawer_with_a_bar():
    (drawer,) = read_scene(CABINET, "cabinet.toml", "cabinet").furniture[0].openings

    assert (drawer.name, drawer.kind, drawer.bar.length_m) == ("top drawer", "drawer", 0.1)


def test_the_guides_stove_has_a_knob():
    scene = read_scene(STOVE, "stove.toml", "stove")

    assert [control.kind for control in scene.furniture[0].controls] == ["knob"]


def test_the_guides_burner_is_a_part_of_its_stove():
    scene = read_scene(STOVE + REGION, "stove.toml", "stove")

    assert [region.name for region in scene.furniture[0].regions] == ["left burner"]


def test_the_guides_rooms_are_on_the_map():
    scene = read_scene(ROOMS, "rooms.toml", "rooms")

    assert [place.name for place in scene.places] == ["kitchen"]


def test_the_guides_camera_looks_down_on_the_table():
    (camera,) = read_scene(CAMERA, "camera.toml", "camera").cameras

    assert camera.world_T_camera[2, 2] < -0.5


def test_the_thing_that_has_a_mesh_is_as_the_guide_says(tmp_path):
    import_object(foreign.written(foreign.can(), tmp_path, "soup_can.obj"))

    scene = read_scene(BREAKFAST + MESH, str(tmp_path / "breakfast.toml"), "breakfast")

    soup = next(item for item in scene.objects if item.model is not None)
    assert (soup.name, soup.kind) == ("tomato soup", "soup")
    assert soup.names == ("tomato soup", "the red tin")
    assert soup.mass_kg == 0.35
