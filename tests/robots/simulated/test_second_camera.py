"""What a scene's second camera shows, by the stub."""

import numpy as np
import pytest

from robots.clock import ManualClock
from robots.models.description import load_robot
from robots.scenes.scene_file import load_scene
from robots.simulated.eyes import placed_cameras, simulated_perception
from robots.simulated.world import build_world

TICKS = 100


def seen_by(scene_name):
    robot, scene, clock = load_robot("talos"), load_scene(scene_name), ManualClock()
    world = build_world(robot, scene, np.random.default_rng(0))
    perception = simulated_perception(world, robot, scene, clock, np.random.default_rng(5), None, None)
    for _ in range(TICKS):
        for eye in (perception, *perception.cameras):
            eye.latest()
        perception.tick()
        clock.advance(0.002)
    return perception, placed_cameras(perception, scene), world


@pytest.mark.requirement("P3")
def test_the_stub_of_a_camera_in_the_room_tells_the_backs_of_things_where_they_are():
    _, (camera,), world = seen_by("watched")

    told = {(one.color, one.kind): one for one in camera.detector.latest().detections}
    can = camera.odom_T_camera @ told["green", "can"].camera_T_object
    assert np.linalg.norm(can[:3, 3] - world.truth.world_T_object("green can")[:3, 3]) < 0.03


@pytest.mark.requirement("P3")
def test_a_camera_that_is_blind_leaves_the_other_one_seeing():
    perception, (camera,), _ = seen_by("watched")
    perception.cameras[0].faults.blind = True
    for _ in range(TICKS):
        perception.latest(), camera.detector.latest()
        perception.tick()

    assert perception.latest().detections


def test_a_scene_without_a_second_camera_has_none():
    perception, cameras, _ = seen_by("tabletop")

    assert (perception.cameras, cameras) == ((), ())
