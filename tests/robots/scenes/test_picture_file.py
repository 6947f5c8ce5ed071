"""The picture on an object: found beside the scene, or refused with a word that helps."""

import pytest
from PIL import Image

from robots.errors import SceneError
from robots.scenes.scene_file import read_scene
from robots.scenes.scene_writer import dump

SCENE = """
[[object]]
name = "soup"
kind = "can"
radius_m = 0.035
height_m = 0.11
position_m = [0.5, 0.0, 0.055]
texture = {texture!r}
"""
BALL = """
[[object]]
name = "ball"
kind = "ball"
radius_m = 0.035
position_m = [0.5, 0.0, 0.035]
texture = "front.png"
"""


def read(folder, texture):
    return read_scene(SCENE.format(texture=texture), str(folder / "scene.toml"), "scene")


@pytest.fixture
def folder(tmp_path):
    Image.new("RGB", (8, 8)).save(tmp_path / "front.png")
    return tmp_path


def test_a_picture_is_looked_for_beside_the_scene(folder):
    assert read(folder, "front.png").objects[0].texture == str(folder / "front.png")


def test_a_scene_with_a_picture_is_written_and_read_back(folder):
    scene = read(folder, "front.png")

    assert read_scene(dump(scene), "elsewhere.toml", "scene").objects[0].texture == scene.objects[0].texture


def test_a_picture_that_is_not_there_is_refused_with_those_that_are(folder):
    with pytest.raises(SceneError, match=r"there is no file .*frnt.png; there are front.png"):
        read(folder, "frnt.png")


def test_a_file_that_is_no_picture_is_refused(folder):
    with pytest.raises(SceneError, match=r"must be a picture .* not 'front.txt'"):
        read(folder, "front.txt")


def test_a_ball_carries_no_picture(folder):
    with pytest.raises(SceneError, match="a ball carries no picture"):
        read_scene(BALL, str(folder / "scene.toml"), "scene")
