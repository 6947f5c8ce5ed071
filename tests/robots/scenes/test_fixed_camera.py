"""Cameras that stand in a room, as scenes declare them."""

import numpy as np
import pytest

from robots.errors import SceneError
from robots.scenes.fixed_camera import FixedCamera
from robots.scenes.scene_file import load_scene, read_scene
from robots.scenes.scene_writer import dump

CORNER = """
[[camera]]
name = "corner camera"
position_m = [1.6, 0.8, 1.7]
looks_at_m = [0.7, 0.0, 0.8]
rate_hz = 10.0
width_px = 320
[camera.errors]
turn_rad = 0.001
"""


@pytest.mark.requirement("P3")
def test_a_scene_declares_a_camera_that_stands_in_the_room():
    (camera,) = read_scene(CORNER, "scene.toml", "scene").cameras

    assert (camera.name, camera.lens.rate_hz, camera.lens.width_px) == ("corner camera", 10.0, 320)
    assert camera.lens.errors.turn_rad == 0.001
    assert camera.lens.errors.shift_m == 0.002


def test_the_place_that_a_camera_looks_at_is_in_the_middle_of_its_pictures():
    (camera,) = read_scene(CORNER, "scene.toml", "scene").cameras
    at = np.linalg.inv(camera.world_T_camera) @ np.array([*camera.looks_at_m, 1.0])

    assert at[:2] == pytest.approx([0.0, 0.0], abs=1e-12)
    assert at[2] > 0.0


def test_the_upper_edge_of_a_cameras_pictures_is_up():
    (camera,) = read_scene(CORNER, "scene.toml", "scene").cameras

    assert camera.world_T_camera[2, 0] == pytest.approx(0.0, abs=1e-12)
    assert camera.world_T_camera[2, 1] < 0.0


def test_a_camera_may_look_straight_down():
    pose = FixedCamera("lamp", (0.5, 0.0, 2.4), (0.5, 0.0, 0.0)).world_T_camera

    assert pose[:3, 2] == pytest.approx([0.0, 0.0, -1.0])
    assert np.linalg.det(pose[:3, :3]) == pytest.approx(1.0)


def test_a_camera_that_is_written_is_read_back():
    scene = read_scene(CORNER, "scene.toml", "scene")

    assert read_scene(dump(scene), "scene.toml", "scene").cameras == scene.cameras


@pytest.mark.parametrize(
    ("old", "new", "key"),
    [
        ("[0.7, 0.0, 0.8]", "[1.6, 0.8, 1.7]", "camera[0].looks_at_m"),
        ("corner camera", "head camera", "camera[0].name"),
        ("rate_hz = 10.0", "rate_hz = 0.0", "camera[0].rate_hz"),
        ("rate_hz = 10.0", "range_m = [3.0, 1.0]", "camera[0].range_m"),
        ("turn_rad = 0.001", "turn_rad = -0.001", "camera[0].errors.turn_rad"),
        ("looks_at_m", "look_at_m", "camera[0].look_at_m"),
    ],
)
def test_a_camera_that_cannot_be_is_refused_with_its_key(old, new, key):
    with pytest.raises(SceneError) as refused:
        read_scene(CORNER.replace(old, new), "scene.toml", "scene")

    assert refused.value.key == key


def test_a_camera_has_a_name_of_its_own():
    with pytest.raises(SceneError, match="corner camera"):
        read_scene(CORNER + CORNER, "scene.toml", "scene")


@pytest.mark.requirement("P3")
def test_a_scene_that_everybody_has_shows_a_second_camera():
    assert [camera.name for camera in load_scene("watched").cameras] == ["ceiling camera"]
