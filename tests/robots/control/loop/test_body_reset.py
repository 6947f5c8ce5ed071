"""The control loop's reset is the body's as well; a body that refuses keeps the emergency stop engaged."""

import pytest

from kinematics.model.robot_model import RobotModel
from robots.clock import ManualClock
from robots.control.loop.control_loop import ControlLoop
from robots.control.loop.emergency_stop import PersonsReset
from robots.models.description import load_robot
from robots.unitree.watch import Trouble
from tools.unitree.over_the_wire import wired
from tools.unitree.referee import PERIOD_S, WireFault, empty_world

ASKED = PersonsReset("Ana")


@pytest.fixture(scope="module")
def g1():
    data = load_robot("g1")
    return data, RobotModel(data.description)


def looped(g1, *faults):
    """A control loop that has a body behind a wire, in a harness."""
    data, model = g1
    clock = ManualClock()
    body, referee = wired(empty_world(data, 0), clock, take_up_s=0.3, held=True, faults=faults)
    return ControlLoop(body, model, clock, lambda _event: None), body, referee


def run(loop, seconds):
    for _ in range(round(seconds / PERIOD_S)):
        loop.step()


def test_a_wire_that_was_lost_keeps_the_stop_until_it_is_back_and_a_person_resets(g1):
    loop, body, referee = looped(g1, WireFault("silent", 0.5, 1.2))
    run(loop, 1.6)
    assert loop.emergency is not None
    assert "wire" in loop.emergency.reason

    assert "no state for more than 1 s" in loop.reset(ASKED)
    assert loop.emergency is not None

    run(loop, 0.3)
    assert [one.trouble for one in body.findings] == [Trouble.LOST]
    assert not referee.stiff
    assert loop.reset(ASKED) is None

    run(loop, 0.5)
    assert loop.emergency is None
    assert body.findings == ()
    assert referee.stiff
    assert referee.jump_rad < 0.01


def test_the_alarm_of_the_time_before_a_reset_does_not_engage_the_stop_again(g1):
    loop, _, _ = looped(g1, WireFault("motor", 0.3, 0.1))
    run(loop, 0.6)
    assert loop.emergency is not None

    assert loop.reset(ASKED) is None

    run(loop, 0.1)
    assert loop.emergency is None
