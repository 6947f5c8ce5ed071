"""A pause holds what is under way, within the limits and on its path; it goes on and arrives all the same."""

import dataclasses

import numpy as np
import pytest

from kinematics.checking.start_gap import LEAD_IN_M, start_gap
from kinematics.motion.lead_in import lead_in
from kinematics.motion.sampler import TrajectorySampler
from kinematics.stopping.resuming import rest_of
from robots.control.events import MotionPaused, MotionResumed
from robots.control.motion_handle import MotionStatus
from robots.control.streaming import body_track


def shares(rig, since=0):
    """Largest acceleration and jerk of the setpoints, as shares of the limits."""
    limits = [rig.description.limits[name] for name in rig.description.actuated]
    v = np.array([setpoint.v for setpoint in rig.robot.commands[since:]])
    a = np.diff(v, axis=0) / 0.002
    return (
        float((np.abs(a) / [limit.acceleration for limit in limits]).max()),
        float((np.abs(np.diff(a, axis=0)) / 0.002 / [limit.jerk for limit in limits]).max()),
    )


def off_the_path(rig, trajectory):
    """Farthest that a setpoint is from the path."""
    path = TrajectorySampler(trajectory).many(np.linspace(0.0, trajectory.duration_s, 4001)).q[:, 7:]
    told = np.array([s.q[: path.shape[1]] for s in rig.robot.commands])
    return max(float(np.abs(path - q).max(axis=1).min()) for q in told[::5])


def rests(rig, periods=50):
    return not any(setpoint.v.any() for setpoint in rig.robot.commands[-periods:])


@pytest.mark.parametrize("at_s", [0.02, 0.3, 0.5, 0.8, 0.97])
def test_a_paused_motion_rests_on_its_path_and_ends_where_it_was_to_end(rig, motions, at_s):
    motion = motions.arms(rig.loop.motion.reference(), amount=0.8, duration_s=1.5)
    handle = rig.loop.motion.start(motion)
    rig.run(1.5 * at_s)

    rig.loop.pause("by the test")
    rig.run(1.0)
    assert rests(rig)
    assert handle.status is MotionStatus.RUNNING or at_s > 0.9
    progress = handle.progress
    rig.run(2.0)
    assert rests(rig, 1000)
    assert handle.progress == progress

    rig.loop.resume()
    rig.run(3.0)

    assert handle.status is MotionStatus.DONE
    np.testing.assert_allclose(rig.loop.motion.reference(), motion.trajectory.q[-1], atol=1e-6)
    assert off_the_path(rig, motion.trajectory) < 2e-3
    assert max(shares(rig)) <= 1.005
    assert rig.loop.statistics.refused == 0
    assert len(rig.of_kind(MotionPaused)) == len(rig.of_kind(MotionResumed)) == 1


def test_a_motion_may_be_paused_again_and_again(rig, motions):
    motion = motions.arms(rig.loop.motion.reference(), amount=0.8, duration_s=2.0)
    handle = rig.loop.motion.start(motion)
    for _ in range(4):
        rig.run(0.35)
        rig.loop.pause("by the test")
        rig.run(0.25)
        rig.loop.resume()
    rig.run(4.0)

    assert handle.status is MotionStatus.DONE
    np.testing.assert_allclose(rig.loop.motion.reference(), motion.trajectory.q[-1], atol=1e-6)
    assert max(shares(rig)) <= 1.005


@pytest.mark.requirement("S6")
@pytest.mark.parametrize("at_s", [0.2, 0.3, 0.5, 0.8])
def test_what_goes_on_is_led_in_by_no_more_than_the_checker_leaves(rig, motions, monkeypatch, at_s):
    led_m = []

    def measured(trajectory, q_start, acceleration):
        led_m.append(start_gap(rig.model).moves_m(q_start, trajectory.q[0]))
        return lead_in(trajectory, q_start, acceleration)

    monkeypatch.setattr(body_track, "lead_in", measured)
    handle = rig.loop.motion.start(motions.arms(rig.loop.motion.reference(), amount=0.8, duration_s=1.5))
    rig.run(1.5 * at_s)
    rig.loop.pause("by the test")
    rig.run(1.0)
    rig.loop.resume()
    rig.run(3.0)

    assert handle.status is MotionStatus.DONE
    assert len(led_m) == 1
    assert led_m[0] <= LEAD_IN_M


@pytest.mark.requirement("S6")
def test_what_could_only_go_on_from_elsewhere_is_ended(rig, motions, monkeypatch):
    def elsewhere(model, trajectory, q, near_s, period_s):
        rest = rest_of(model, trajectory, q, near_s, period_s)
        return dataclasses.replace(rest, q=rest.q + 1e-3 * (np.arange(len(q)) == 27))

    monkeypatch.setattr(body_track, "rest_of", elsewhere)
    handle = rig.loop.motion.start(motions.arms(rig.loop.motion.reference(), amount=0.8, duration_s=1.5))
    rig.run(0.7)
    rig.loop.pause("by the test")
    rig.run(1.0)
    rig.loop.resume()
    rig.run(0.5)

    assert handle.status is MotionStatus.REFUSED
    assert rests(rig, 200)


def test_what_is_begun_in_a_pause_waits_at_its_start(rig, motions):
    rig.loop.pause("by the test")
    handle = rig.loop.motion.start(motions.arms(rig.loop.motion.reference()))
    rig.run(0.5)
    assert rests(rig, 200)
    assert handle.status is MotionStatus.RUNNING

    rig.loop.resume()
    rig.run(2.0)

    assert handle.status is MotionStatus.DONE


@pytest.mark.requirement("S4", "S7")
@pytest.mark.parametrize("end", ["emergency stop", "stop", "cancel"])
def test_what_is_paused_can_be_stopped_and_never_moves_again(rig, motions, end):
    handle = rig.loop.motion.start(motions.arms(rig.loop.motion.reference(), duration_s=2.0))
    rig.run(0.5)
    rig.loop.pause("by the test")
    rig.run(0.5)

    if end == "cancel":
        rig.loop.motion.cancel(handle, "by the test")
    elif end == "stop":
        rig.loop.stop(1, "by the test")
    else:
        rig.loop.emergency_stop("by the test")
    rig.loop.resume()
    rig.run(1.0)

    assert handle.status is MotionStatus.CANCELED
    assert rests(rig, 480)
    assert not rig.loop.paused
    if end != "emergency stop":
        after = rig.loop.motion.start(motions.arms(rig.loop.motion.reference(), amount=0.1))
        rig.run(1.5)
        assert after.status is MotionStatus.DONE


@pytest.mark.requirement("S4")
def test_an_emergency_stop_while_speed_is_gathered_again_is_a_stop_like_any_other(rig, motions):
    handle = rig.loop.motion.start(motions.arms(rig.loop.motion.reference(), amount=0.8, duration_s=2.0))
    rig.run(0.8)
    rig.loop.pause("by the test")
    rig.run(0.5)
    rig.loop.resume()
    rig.run(0.15)
    assert rig.robot.commands[-1].v.any()

    rig.loop.emergency_stop("by the test")
    rig.run(0.5)

    assert handle.status is MotionStatus.CANCELED
    assert rests(rig)
    assert max(shares(rig)) <= 1.005


def test_fingers_finish_their_way_in_a_pause(rig):
    handle = rig.loop.grippers["left"].close()
    rig.run(0.1)

    rig.loop.pause("by the test")
    rig.run(2.0)

    assert handle.status is MotionStatus.DONE
