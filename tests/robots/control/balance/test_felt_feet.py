"""A robot whose feet feel nothing is told what its legs feel."""

import numpy as np
import pytest

from kinematics.model.robot_model import RobotModel
from robots.clock import ManualClock
from robots.control.balance.felt_feet import FeltFeet, with_felt_feet
from robots.control.loop.control_loop import ControlLoop
from robots.models.description import load_robot
from robots.scenes.scene_description import SceneDescription
from robots.simulated.world import build_world


@pytest.fixture(scope="module")
def small():
    robot = load_robot("g1")
    world = build_world(robot, SceneDescription("floor"), np.random.default_rng(1), drawn=False)
    return world, ControlLoop(world.robot, RobotModel(robot.description), ManualClock(), lambda _event: None)


def test_the_weight_is_felt_and_the_simulators_own_sensors_are_not_read(small):
    world, loop = small
    for _ in range(400):
        loop.step()

    felt = loop.sensing.state().readings.foot_wrench

    assert not world.robot.read().foot_wrench.any()
    assert felt[:, 2].sum() == pytest.approx(loop.model.mass_kg * 9.81, rel=0.04)
    assert felt[:, 2].min() > 100.0
    assert loop.sensing.state().readings.feet_estimated
    assert not world.robot.read().feet_estimated


def test_readings_are_estimated_once_a_period(small):
    world, loop = small
    feet = FeltFeet(world.robot, loop.model)

    assert feet.read() is feet.read()


def test_a_robot_whose_feet_feel_is_left_as_it_is(small):
    world, _ = small
    talos = RobotModel(load_robot("talos").description)

    assert with_felt_feet(world.robot, talos) is world.robot
