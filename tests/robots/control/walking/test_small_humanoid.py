"""A small humanoid, whose legs have no closed form, walks with the same pattern and the same stabiliser."""

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.model.robot_model import RobotModel
from kinematics.walking.pattern.steering import VelocitySteering
from robots.clock import ManualClock
from robots.control.loop.control_loop import ControlLoop
from robots.control.motion_handle import MotionStatus
from robots.models.description import load_robot
from robots.scenes.scene_description import SceneDescription
from robots.simulated.world import build_world

UPRIGHT_RAD = 0.05


@pytest.fixture
def small():
    robot = load_robot("g1")
    world = build_world(robot, SceneDescription("floor"), np.random.default_rng(3), drawn=False)
    loop = ControlLoop(world.robot, RobotModel(robot.description), ManualClock(), lambda _event: None)

    def run(seconds):
        tilts = []
        for _ in range(round(seconds / 0.002)):
            loop.step()
            tilts.append(np.arccos(min(1.0, world.truth.world_T_base()[2, 2])))
        return max(tilts)

    return world.truth, loop, run


def test_it_stands(small):
    truth, _, run = small
    before = truth.world_T_base()

    assert run(4.0) < UPRIGHT_RAD
    assert np.linalg.norm(truth.world_T_base()[:3, 3] - before[:3, 3]) < 0.003


@pytest.mark.parametrize(("ahead_m_s", "turn_rad_s"), [(0.3, 0.0), (-0.3, 0.0), (0.0, 0.4)])
def test_it_walks_at_the_speed_that_is_asked_for_and_ends_standing(small, ahead_m_s, turn_rad_s):
    truth, loop, run = small
    run(0.5)
    handle = loop.walking.walk(VelocitySteering(loop.model.description.walking, ahead_m_s, turn_rad_s), "w")
    assert run(3.0) < UPRIGHT_RAD
    before = truth.world_T_base()

    worst = run(4.0)  # eight steps

    moved = poses.inverse(before) @ truth.world_T_base()
    assert worst < UPRIGHT_RAD
    assert moved[0, 3] / 4.0 == pytest.approx(ahead_m_s, abs=0.021)
    assert poses.yaw_of(moved[:3, :3]) / 4.0 == pytest.approx(turn_rad_s, abs=0.028)
    loop.walking.finish(handle)
    assert run(3.0) < UPRIGHT_RAD
    assert handle.status is MotionStatus.DONE
