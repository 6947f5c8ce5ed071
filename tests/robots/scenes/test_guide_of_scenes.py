"""What the guide writes down is a scene."""

import re
from pathlib import Path

from robots.scenes.scene_file import read_scene

GUIDE = (Path(__file__).parents[3] / "docs" / "extend" / "a-scene.md").read_text("utf-8")
BREAKFAST, FRIDGE, ROOMS, CAMERA = re.findall(r"```toml\n(.*?)```", GUIDE, re.DOTALL)


def test_the_guides_scene_can_be_read():
    scene = read_scene(BREAKFAST, "breakfast.toml", "breakfast")

    assert [item.name for item in scene.objects] == ["yellow bowl", "red cup"]
    assert scene.people[0].takes


def test_the_guides_fridge_opens():
    scene = read_scene(FRIDGE, "fridge.toml", "fridge")

    assert scene.furniture[0].opens.hinge == "left"


def test_the_guides_rooms_are_on_the_map():
    scene = read_scene(ROOMS, "rooms.toml", "rooms")

    assert [place.name for place in scene.places] == ["kitchen"]


def test_the_guides_camera_looks_down_on_the_table():
    (camera,) = read_scene(CAMERA, "camera.toml", "camera").cameras

    assert camera.world_T_camera[2, 2] < -0.5
