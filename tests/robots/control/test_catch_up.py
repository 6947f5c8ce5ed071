"""However late a period begins: no setpoint jumps, and nothing is stopped for it."""

import numpy as np
import pytest

from robots.control.events import StopStarted
from robots.control.motion_handle import MotionStatus

PERIOD_S = 0.002


def play(rig, handle, lateness):
    """Run a motion to its end; before each decision so many periods are missed."""
    for missed in lateness:
        rig.loop.catch_up(missed)
        rig.loop.step()
        if handle.finished:
            return
    raise AssertionError("the motion did not end")


def lateness(seed):
    """Mostly in time, often some periods late, sometimes 87 ms and more."""
    rng = np.random.default_rng(seed)
    while True:
        yield int(rng.choice([0, 0, 0, 1, 3, 10, 50], p=[0.4, 0.2, 0.2, 0.1, 0.05, 0.03, 0.02]))


@pytest.mark.requirement("F4")
@pytest.mark.parametrize("seed", [0, 1])
def test_a_motion_with_late_periods_sends_the_very_setpoints_of_one_in_time(new_rig, motions, seed):
    in_time, late = new_rig(), new_rig()
    for rig, periods in ((in_time, iter(lambda: 0, 1)), (late, lateness(seed))):
        play(rig, rig.loop.motion.start(motions.arms(rig.loop.motion.reference())), periods)

    assert not late.of_kind(StopStarted)
    assert late.loop.statistics.refused == 0
    sent = [np.array([s.q for s in rig.robot.commands]) for rig in (in_time, late)]
    np.testing.assert_array_equal(sent[0], sent[1])


@pytest.mark.requirement("F4")
def test_a_stop_that_comes_in_a_late_period_brakes_without_a_jump(rig, motions):
    handle = rig.loop.motion.start(motions.arms(rig.loop.motion.reference()))
    rig.run(0.5)
    rig.loop.catch_up(45)
    rig.loop.stop(1, "test")
    rig.run(1.0)

    assert handle.status is MotionStatus.CANCELED
    assert rig.loop.statistics.refused == 0
    assert rig.loop.motion.resting
    steps = np.abs(np.diff([s.q for s in rig.robot.commands], axis=0))
    assert steps.max() < 2.0 * PERIOD_S


def test_time_passes_for_robot_and_sensors_while_nobody_decides(rig):
    called = []
    rig.run(0.1)
    commands, before_s = len(rig.robot.commands), rig.clock.now_s()

    rig.loop.catch_up(30, lambda: called.append(1))

    assert rig.clock.now_s() == pytest.approx(before_s + 0.06)
    assert rig.loop.sensing.state().readings.stamp_s == pytest.approx(rig.clock.now_s())
    assert len(called) == 30
    assert len(rig.robot.commands) == commands
