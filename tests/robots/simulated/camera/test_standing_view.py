"""What a standing robot's camera shows: people as they are, and pictures on things."""

import math
from dataclasses import replace

import mujoco
import numpy as np
import pytest
from PIL import Image

from kinematics.geometry import poses
from robots.interface.depth_camera import DepthCamera
from robots.models.description import load_robot
from robots.perception.rgbd.eyes import Eyes
from robots.scenes.scene_description import Person, SceneDescription
from robots.scenes.scene_file import load_scene, read_scene
from robots.simulated.body import body_model
from robots.simulated.camera import studio
from robots.simulated.camera.orders import WorldState
from robots.simulated.camera.showing import shown_views
from robots.simulated.camera.standing_view import Gaze, standing_picture

pytestmark = [pytest.mark.opengl, pytest.mark.slow]
CAMERA = DepthCamera("beside", "nowhere", 60.0, width_px=96, height_px=72)
SOUP = """
[[furniture]]
name = "table"
kind = "table"
size_m = [0.7, 1.2, 0.75]
position_m = [0.95, 0.0]

[[object]]
name = "soup"
kind = "can"
color = "white"
radius_m = 0.035
height_m = 0.11
on = "table"
position_m = [-0.2, 0.0]
texture = "front.png"
"""


@pytest.fixture(scope="module")
def talos():
    return load_robot("talos")


def people_seen(talos, *people, tilt_rad=0.25):
    picture = standing_picture(talos, SceneDescription("p", people=people), Gaze(tilt_rad, 0.0, 0.0), 1)
    return Eyes().detect(picture, 0).detections, picture


@pytest.mark.parametrize(
    ("posture", "gesture", "tilt_rad"),
    [
        ("standing", "waving", 0.15),
        ("standing", "pointing right", 0.15),
        ("sitting", "raising right arm", 0.25),
        ("lying", None, 0.5),
    ],
)
def test_posture_gesture_and_clothes_of_a_person_are_seen(talos, posture, gesture, tilt_rad):
    ana = Person(
        "Ana", (2.4, 0.2), math.pi - 0.3, posture=posture, gesture=gesture,
        clothes=("red shirt", "blue trousers"),
    )  # fmt: skip

    (seen,), picture = people_seen(talos, ana, tilt_rad=tilt_rad)

    place = picture.odom_T_camera @ seen.camera_T_object
    assert set(seen.traits) == {posture, "red shirt", "blue trousers", *([gesture] if gesture else [])}
    assert np.linalg.norm(place[:2, 3] - ana.position_m) < 0.15


def test_the_side_of_an_arm_is_the_persons_own_from_behind_too(talos):
    ana = Person("Ana", (2.4, 0.2), 0.3, gesture="pointing left")

    (seen,), _ = people_seen(talos, ana)

    assert "pointing left" in seen.traits


def test_an_empty_room_holds_nobody(talos):
    assert people_seen(talos)[0] == ()


@pytest.fixture
def soup(tmp_path):
    front = np.zeros((64, 128, 3), np.uint8)
    front[:32], front[32:] = (220, 30, 30), (30, 60, 200)
    Image.fromarray(front).save(tmp_path / "front.png")
    scene = read_scene(SOUP, str(tmp_path / "scene.toml"), "scene")
    return replace(scene, perception=replace(scene.perception, kind="rgbd"))


def test_a_thing_with_two_colours_on_it_is_one_thing(talos, soup):
    seen = Eyes().look(standing_picture(talos, soup, Gaze(), 1))

    assert len(seen.things) == 1


def test_a_picture_is_the_right_way_up(talos, soup):
    (view,) = shown_views(talos, soup, 1, seed=1)

    rows = len(view.color)
    upper, lower = view.color[rows // 2, :], view.color[rows - 12, :]
    middle = view.color.shape[1] // 2
    assert upper[middle, 0] > upper[middle, 2]
    assert lower[middle, 2] > lower[middle, 0]


@pytest.mark.parametrize("robot", ["talos", "g1", "panda"])
def test_hulls_that_nobody_sees_make_no_difference_to_a_picture(monkeypatch, robot):
    data, scene = load_robot(robot), load_scene("bench" if robot == "panda" else "flat")
    sizes = []

    def seen():
        drawn = studio.Studio(data, scene, (96, 72))
        sizes.append(mujoco.mj_sizeModel(drawn.model))
        start = mujoco.MjData(drawn.model)
        drawn.place(WorldState(start.qpos, start.mocap_pos, start.mocap_quat))
        at_its_right = poses.transform(poses.rotation_x(-math.pi / 2), (0.2, -1.5, 0.4))
        pictures = drawn.draw(CAMERA, at_its_right, from_the_side=False)
        drawn.close()
        return pictures

    color, depth = seen()
    monkeypatch.setattr(studio, "robot_spec", lambda robot, **_: body_model.robot_spec(robot))
    same_color, same_depth = seen()

    assert ((depth > 0.5) & (depth < 2.5)).sum() > 100  # the robot is in the picture
    assert np.array_equal(color, same_color)
    assert np.array_equal(depth, same_depth)
    assert sizes[0] < sizes[1]
