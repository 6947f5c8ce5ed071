"""The map of a scene's rooms: in the odometry frame, and not quite right."""

import math
from dataclasses import replace

import numpy as np
import pytest

from kinematics.geometry.planar import PlanarPose
from robots.perception.place_map import START_M, START_RAD, place_map
from robots.scenes.scene_description import Region, RobotStart, SceneDescription

KITCHEN = Region("kitchen", (4.0, 1.0), (3.0, 4.0), 0.3)


def errors(start, count=400):
    scene = SceneDescription("flat", start, places=(KITCHEN,))
    true = PlanarPose(start.x_m, start.y_m, start.yaw_rad).to(PlanarPose(4.0, 1.0, 0.3))
    found = []
    for seed in range(count):
        region = place_map(scene, np.random.default_rng(seed))["kitchen"]
        found.append((*np.subtract(region.position_m, (true.x_m, true.y_m)), region.yaw_rad - true.yaw_rad))
    return np.array(found)


@pytest.mark.requirement("P1")
@pytest.mark.parametrize("start", [RobotStart(), RobotStart(1.0, -2.0, 2.5)])
def test_the_map_is_wrong_by_what_is_declared(start):
    off = errors(start)

    turn = off[:, 2]
    assert np.std((turn + math.pi) % (2.0 * math.pi) - math.pi) == pytest.approx(START_RAD, rel=0.15)
    far_m = math.dist((start.x_m, start.y_m), KITCHEN.position_m)
    along = START_M**2 + 0.5 * (START_RAD * far_m) ** 2
    assert np.mean(off[:, :2] ** 2) == pytest.approx(along, rel=0.2)


def test_a_scene_without_places_has_an_empty_map():
    scene = replace(SceneDescription("floor"))

    assert dict(place_map(scene, np.random.default_rng(0))) == {}
