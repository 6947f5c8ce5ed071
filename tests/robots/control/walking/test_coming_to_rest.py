"""A robot with narrow soles comes to rest at the end of paths and turns."""

import numpy as np
import pytest

from kinematics.geometry.planar import PlanarPose
from kinematics.model.robot_model import RobotModel
from kinematics.walking.pattern.steering import PathSteering
from robots.clock import ManualClock
from robots.control.loop.control_loop import ControlLoop
from robots.control.motion_handle import MotionStatus
from robots.models.description import load_robot
from robots.scenes.scene_description import PerceptionModel, RobotStart, SceneDescription
from robots.simulated.world import build_world

PERIOD_S, WITHIN_S = 0.002, 30.0
GOALS = {"ahead": PlanarPose(x_m=0.5), "turned": PlanarPose(yaw_rad=1.9)}


@pytest.mark.parametrize("goal", GOALS.values(), ids=GOALS)
def test_a_small_humanoid_stands_at_the_end_of_its_way(goal):
    data = load_robot("g1")
    scene = SceneDescription("floor", RobotStart(), PerceptionModel())
    world = build_world(data, scene, np.random.default_rng(1))
    loop = ControlLoop(world.robot, RobotModel(data.description), ManualClock(), lambda _event: None)
    way = PathSteering(data.description.walking, (PlanarPose(), goal))

    for _ in range(150):
        loop.step()

    handle = loop.walking.walk(way, "walk")
    for _ in range(round(WITHIN_S / PERIOD_S)):
        if handle.finished:
            break
        loop.step()

    truth = world.truth.world_T_base()
    assert handle.status is MotionStatus.DONE, handle.reason
    assert np.hypot(truth[0, 3] - goal.x_m, truth[1, 3] - goal.y_m) < 0.1
    assert not world.truth.fallen()
