from types import SimpleNamespace

import numpy as np
import pytest

from robots.control.guarded.guarded_motion import MotionBounds
from robots.control.motion_handle import MotionStatus

LEFT = "gripper_left_joint"


@pytest.fixture
def left(rig):
    return rig.loop.grippers["left"]


def close_on(rig, left, fingers_rad):
    rig.robot.obstacle_rad[LEFT] = fingers_rad
    handle = left.close()
    rig.run_until(lambda: handle.finished)
    assert handle.status is MotionStatus.DONE
    rig.run(0.3)


def test_an_empty_gripper_closes_fully_and_says_that_it_holds_nothing(rig, left):
    handle = left.close()
    rig.run_until(lambda: handle.finished)
    rig.run(0.2)

    assert handle.status is MotionStatus.DONE
    assert left.reading().opening_m == pytest.approx(0.0, abs=1e-4)
    assert not left.reading().holding


@pytest.mark.parametrize("fingers_rad", [-0.095, -0.233, -0.364])
def test_closed_on_something_it_presses_with_the_described_effort(rig, left, fingers_rad):
    close_on(rig, left, fingers_rad)

    reading = left.reading()
    assert reading.holding
    assert reading.effort_nm == pytest.approx(rig.robot.hardware.grips["left"].effort_nm, abs=0.1)


def test_the_grip_goes_on_while_the_body_moves_and_when_it_is_stopped(rig, left, motions):
    close_on(rig, left, -0.233)
    rig.loop.motion.start(motions.arms(rig.loop.motion.reference()))
    rig.run(0.5)
    rig.loop.stop(1, "a person wants it")
    rig.run(1.0)

    assert left.reading().holding
    assert left.reading().effort_nm > 3.3


def test_a_grip_at_rest_does_not_stir_the_setpoint(rig, left):
    close_on(rig, left, -0.233)
    before = len(rig.robot.commands)
    rig.run(1.0)

    assert np.ptp(rig.commanded(LEFT)[before:, 0]) == 0.0
    assert rig.robot.commands[-1].owner == "hold"


@pytest.mark.requirement("M2")
@pytest.mark.parametrize("fingers_rad", [-0.095, -0.233, -0.364])
def test_an_emptied_gripper_closes_and_soon_says_so(rig, left, fingers_rad):
    close_on(rig, left, fingers_rad)

    del rig.robot.obstacle_rad[LEFT]
    rig.run(0.1)
    assert not left.reading().holding
    rig.run(0.5)

    assert left.reading().position_rad < rig.robot.hardware.grips["left"].empty_below_rad
    assert rig.loop.statistics.refused == 0


def test_opening_lets_go_and_stays_open(rig, left):
    close_on(rig, left, -0.233)

    handle = left.open()
    rig.run_until(lambda: handle.finished)
    rig.run(0.5)

    assert handle.status is MotionStatus.DONE
    assert left.reading().opening_m == pytest.approx(0.092)
    assert left.reading().effort_nm == pytest.approx(0.0, abs=1e-6)


def test_a_cancelled_closing_holds_the_opening_that_it_has(rig, left):
    handle = left.close()
    rig.run(0.4)

    rig.loop.motion.cancel(handle, "enough")
    opening_m = left.reading().opening_m
    rig.run(0.5)

    assert handle.status is MotionStatus.CANCELED
    assert left.reading().opening_m == pytest.approx(opening_m, abs=0.01)
    assert rig.loop.statistics.refused == 0


def test_a_second_motion_of_the_same_gripper_is_refused_while_the_first_runs(rig, left):
    first = left.close()
    rig.run(0.1)

    second = left.open()

    assert second.status is MotionStatus.REFUSED
    assert LEFT in second.reason
    assert first.status is MotionStatus.RUNNING


def test_the_other_gripper_is_left_alone(rig, left):
    close_on(rig, left, -0.233)

    assert np.ptp(rig.commanded("gripper_right_joint")[:, 0]) == 0.0


def test_a_gripper_that_cannot_open_is_given_up_after_its_declared_time(rig, left):
    close_on(rig, left, -0.364)
    rig.robot.stuck_rad[LEFT] = -0.2

    handle = left.open()
    rig.run(3.0)

    assert handle.status is MotionStatus.REFUSED
    assert "duration" in handle.reason
    assert rig.loop.statistics.refused == 1


def test_a_refused_motion_of_head_and_gripper_leaves_the_grip_its_joint(rig, left, motions):
    close_on(rig, left, -0.233)
    rig.loop.motion.start(motions.arms(rig.loop.motion.reference()))
    one = np.ones(2)
    both = SimpleNamespace(
        name="nod and close",
        bounds=MotionBounds(("head_1_joint", LEFT), -one, one, one, one, 1.0),
        sample=lambda elapsed_s, state: None,
    )

    refused = rig.loop.motion.start(both)
    del rig.robot.obstacle_rad[LEFT]
    rig.run(0.6)

    assert refused.status is MotionStatus.REFUSED
    assert "head_1_joint is held by" in refused.reason
    assert left.reading().opening_m < 0.01
    assert rig.loop.statistics.refused == 0


def require_limits_kept(rig):
    """Speed, acceleration and jerk of all that reached the robot, as differences of the setpoints."""
    limits = rig.description.limits[LEFT]
    v = np.concatenate([[0.0, 0.0], rig.commanded(LEFT)[:, 1]])
    a = np.diff(v) / 0.002
    assert np.abs(v).max() > 0.5
    assert np.abs(a).max() <= limits.acceleration
    assert np.abs(np.diff(a)).max() / 0.002 <= limits.jerk


@pytest.mark.requirement("S1")
def test_a_grip_that_forms_gives_way_and_opens_keeps_acceleration_and_jerk_limits(rig, left):
    close_on(rig, left, -0.233)
    rig.robot.obstacle_rad[LEFT] = -0.4  # it slips, and is met again
    rig.run(0.5)
    del rig.robot.obstacle_rad[LEFT]
    rig.run(0.5)
    left.open()
    rig.run(0.3)
    left.close()
    rig.run(1.0)

    require_limits_kept(rig)
    assert rig.loop.statistics.refused == 0


@pytest.mark.requirement("S4")
@pytest.mark.parametrize("after_s", [0.004, 0.03, 0.3, 0.43, 0.45, 0.47, 0.49, 0.51])
def test_a_stop_at_any_instant_of_a_closing_keeps_acceleration_and_jerk_limits(rig, left, after_s):
    rig.robot.obstacle_rad[LEFT] = -0.233
    handle = left.close()
    rig.run(after_s)
    rig.loop.emergency_stop("by the test", 2)
    rig.run(0.1)
    del rig.robot.obstacle_rad[LEFT]  # what was about to be held is gone
    rig.run(1.0)

    i = rig.description.actuated.index(LEFT)
    v = np.array([0.0, 0.0, *(command.v[i] for command in rig.robot.commands)])
    a = np.diff(v) / 0.002
    assert handle.finished
    assert v[-1] == 0.0
    assert np.abs(a).max() <= rig.description.limits[LEFT].acceleration
    assert np.abs(np.diff(a)).max() / 0.002 <= rig.description.limits[LEFT].jerk
