"""An arm that is bolted to the world of a scene."""

import math

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.model.robot_model import RobotModel
from kinematics.walking.pattern.steering import Halt
from robots.clock import ManualClock
from robots.control.loop.control_loop import ControlLoop
from robots.models.description import load_robot
from robots.scenes.scene_description import RobotStart, SceneDescription
from robots.simulated.world import build_world

START = RobotStart(0.4, -0.3, 0.6)


@pytest.fixture(scope="module")
def panda():
    return load_robot("panda")


@pytest.fixture
def world(panda):
    return build_world(panda, SceneDescription("room", START), np.random.default_rng(0))


def test_its_base_stands_where_the_scene_has_the_robot_at_the_height_of_its_mount(panda, world):
    turn = poses.rotation_z(START.yaw_rad)
    height_m = panda.description.mount_xyz_m[2]

    expected = poses.transform(turn, (START.x_m, START.y_m, height_m))
    assert world.truth.world_T_base() == pytest.approx(expected, abs=1e-9)


def test_model_and_simulator_have_hand_and_camera_at_the_same_places(panda, world):
    model, truth = RobotModel(panda.description), world.truth
    for frame, place in (
        (panda.description.tcp_frames["right"], truth.world_T_tcp("right")),
        (panda.description.camera.frame, truth.world_T_camera()),
    ):
        assert place == pytest.approx(truth.world_T_odom() @ model.frame_pose(model.q_home, frame), abs=1e-6)


def test_both_fingers_begin_open(world):
    opened = [world.physics.data.joint(f"panda_finger_joint{k}").qpos[0] for k in (1, 2)]

    assert opened == [0.04, 0.04]


def test_it_holds_still_under_control_and_cannot_fall(panda, world):
    loop = ControlLoop(world.robot, RobotModel(panda.description), ManualClock(), lambda _event: None)
    before = world.truth.joint_positions()
    for _ in range(500):
        loop.step()

    assert np.abs(world.truth.joint_positions() - before).max() < 1e-3
    assert not world.truth.fallen()
    assert loop.defects == ()


def test_what_it_knows_of_its_base_is_its_mount(panda, world):
    model = RobotModel(panda.description)
    loop = ControlLoop(world.robot, model, ManualClock(), lambda _event: None)
    loop.step()

    assert np.array_equal(loop.sensing.state().q[:7], model.q_home[:7])


def test_it_refuses_to_walk_with_the_reason(panda, world):
    loop = ControlLoop(world.robot, RobotModel(panda.description), ManualClock(), lambda _event: None)

    assert loop.walking.walk(Halt(), "walk").reason == "panda is not known to walk"


def test_its_balance_has_no_edge(world):
    assert world.truth.com_margin_m() == math.inf
