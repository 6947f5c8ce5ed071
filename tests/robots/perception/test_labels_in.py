"""What a scene lets perception tell is known without a world, and is what the stub declares."""

import numpy as np
import pytest

from robots.clock import ManualClock
from robots.interface.hardware import RobotData
from robots.models.description import load_robot
from robots.perception.stub import PerceptionStub
from robots.perception.told_labels import labels_in
from robots.scenes.scene_file import known_scenes, load_scene
from robots.simulated.world import build_world


@pytest.mark.parametrize("name", known_scenes())
def test_a_scene_tells_what_its_stub_declares(name):
    scene, data = load_scene(name), load_robot("talos")
    rng = np.random.default_rng(0)
    world = build_world(RobotData(data.description, data.hardware), scene, rng)
    stub = PerceptionStub(world.truth, data.description.camera, scene.perception, ManualClock(), rng)

    assert labels_in(scene) == stub.labels
