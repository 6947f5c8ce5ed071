"""What a scene lets perception tell is known without a world, and is what the stub declares."""

from dataclasses import replace

import numpy as np
import pytest

from robots.clock import ManualClock
from robots.interface.hardware import RobotData
from robots.models.description import load_robot
from robots.perception.rgbd.eyes import Eyes
from robots.perception.stub import PerceptionStub
from robots.perception.told_labels import labels_in, told_fronts
from robots.scenes.scene_file import known_scenes, load_scene
from robots.simulated.eyes import simulated_perception
from robots.simulated.world import build_world


@pytest.mark.parametrize("name", known_scenes())
def test_a_scene_tells_what_its_stub_declares(name):
    scene, data = load_scene(name), load_robot("talos")
    rng = np.random.default_rng(0)
    world = build_world(RobotData(data.description, data.hardware), scene, rng)
    stub = PerceptionStub(world.truth, data.description.camera, scene.perception, ManualClock(), rng)

    assert labels_in(scene) == stub.labels


def test_doors_and_drawers_are_told_by_all_that_their_piece_is_called():
    pieces = {"cabinet": ("Sideboard",), "microwave": ()}
    scene = load_scene("cabinet")
    named = tuple(replace(one, names=pieces.get(one.name, one.names)) for one in scene.furniture)
    scene = replace(scene, furniture=named)

    fronts = {"cabinet drawer", "sideboard drawer", "microwave door"}
    assert told_fronts(scene.furniture) == fronts
    assert not fronts & labels_in(scene)
    assert {"sideboard", "cabinet", "microwave"} <= labels_in(scene)


@pytest.fixture
def larder():
    scene = load_scene("fridge")
    pieces = [replace(one, names=("larder",)) if one.kind == "fridge" else one for one in scene.furniture]
    return replace(scene, furniture=tuple(pieces))


def test_a_fridge_of_another_name_has_a_door_by_that_name(larder):
    data, rng = load_robot("talos"), np.random.default_rng(0)
    robot = RobotData(data.description, data.hardware)
    world = build_world(robot, larder, rng)

    eyes = simulated_perception(world, robot, larder, ManualClock(), rng, None, None)

    assert {"fridge door", "larder door"} <= eyes.fronts
    assert "larder" in eyes.labels


def test_a_camera_knows_what_the_map_calls_furniture_but_for_what_it_cannot_see(larder):
    cabinets = [one for one in load_scene("cabinet").furniture if one.kind == "fixture"]
    fixtures = [replace(one, names=("cooker",)) for one in cabinets]

    labels = Eyes((*larder.furniture, *fixtures)).labels

    assert fixtures
    assert "larder" in labels
    assert "cooker" not in labels
