import numpy as np
import pytest

from robots.clock import ManualClock
from robots.errors import SetpointRefusedError
from robots.fake.fake_robot import FakeRobot
from robots.interface.robot import JointSetpoint
from robots.models.description import load_robot

HARDWARE = load_robot("talos").hardware


@pytest.fixture
def robot(model):
    return FakeRobot(model, HARDWARE, ManualClock())


def setpoint(q):
    return JointSetpoint(0.0, 1, "test", q, np.zeros_like(q), np.zeros_like(q))


def test_it_starts_at_home(robot):
    home = [robot.description.home[joint] for joint in robot.description.actuated]

    np.testing.assert_array_equal(robot.read().q, home)


def test_it_is_at_once_where_it_is_told_to_be(robot):
    q = robot.read().q + 0.1

    robot.command(setpoint(q))

    np.testing.assert_array_equal(robot.read().q, q)


def test_a_joint_that_is_stuck_stays(robot):
    joint = robot.description.actuated[7]
    robot.stuck.add(joint)
    before = robot.read().q

    robot.command(setpoint(before + 0.1))

    moved = robot.read().q - before
    assert moved[7] == 0.0
    assert np.all(np.delete(moved, 7) > 0.0)


@pytest.mark.parametrize("q", [np.zeros(3), np.full(32, np.nan)])
def test_a_setpoint_that_is_none_is_refused(robot, q):
    with pytest.raises(SetpointRefusedError):
        robot.command(setpoint(q))


def test_its_readings_cannot_be_changed_from_outside(robot):
    robot.read().q[:] = 9.0

    assert np.all(robot.read().q < 9.0)
