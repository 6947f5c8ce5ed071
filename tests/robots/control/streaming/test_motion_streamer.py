import dataclasses

import numpy as np
import pytest

from kinematics.model.stance import Stance
from robots.control.events import MotionEnded, MotionStarted
from robots.control.motion_handle import MotionStatus

ELBOW = "arm_left_2_joint"


def limits_kept(rig):
    """Every setpoint, as differences of what the robot really got."""
    v = np.array([setpoint.v for setpoint in rig.robot.commands])
    limit = np.array([rig.description.limits[name].acceleration for name in rig.description.actuated])
    return bool((np.abs(np.diff(v, axis=0)) <= limit * 0.002 * 1.005).all())


@pytest.mark.requirement("S6")
@pytest.mark.parametrize("what", ["trajectory", None, 3, object()])
def test_only_checked_trajectories_and_guarded_motions_can_be_streamed(rig, motions, what):
    if what == "trajectory":
        what = motions.arms(rig.loop.motion.reference()).trajectory

    with pytest.raises(TypeError, match="only a CheckedTrajectory or a GuardedMotion"):
        rig.loop.motion.start(what)

    assert rig.robot.commands == []


def test_a_trajectory_is_streamed_to_its_exact_end(rig, motions):
    motion = motions.arms(rig.loop.motion.reference(), amount=0.2, duration_s=0.501)

    handle = rig.loop.motion.start(motion)
    rig.run(0.25)
    assert handle.status is MotionStatus.RUNNING
    assert handle.progress == pytest.approx(0.5, abs=0.01)
    rig.run(0.26)

    assert (handle.status, handle.progress) == (MotionStatus.DONE, 1.0)
    np.testing.assert_allclose(rig.loop.motion.reference(), motion.trajectory.q[-1], atol=1e-15)
    assert rig.loop.statistics.refused == 0
    assert [event.status for event in rig.of_kind(MotionEnded)] == ["done"]


def test_what_the_robot_gets_is_the_trajectory_itself(rig, motions):
    motion = motions.arms(rig.loop.motion.reference())
    rig.loop.motion.start(motion)
    rig.run(1.0)

    i = rig.description.actuated.index(ELBOW)
    got = rig.commanded(ELBOW)[4::5]  # the samples lie five periods apart
    np.testing.assert_allclose(got[:, 0], motion.trajectory.q[1:, 7 + i], atol=1e-12)
    np.testing.assert_allclose(got[:-1, 1], motion.trajectory.v[1:-1, 6 + i], atol=1e-12)


def test_a_trajectory_that_starts_elsewhere_is_refused_with_joint_and_numbers(rig, motions):
    q = rig.loop.motion.reference()
    q[7 + rig.model.joint_index(ELBOW)] += 0.002

    handle = rig.loop.motion.start(motions.arms(q))

    assert handle.status is MotionStatus.REFUSED
    assert ELBOW in handle.reason
    rig.run(0.1)
    assert np.ptp(rig.commanded(ELBOW)[:, 0]) == 0.0


@pytest.mark.requirement("S6")
@pytest.mark.parametrize("place", [0, 7 + 3, 7 + 20])
def test_a_start_that_would_have_to_be_led_in_farther_than_was_checked_is_refused(rig, motions, place):
    q = rig.loop.motion.reference()
    q[place] += 0.0009

    handle = rig.loop.motion.start(motions.arms(q))

    assert handle.status is MotionStatus.REFUSED
    assert "nobody checked" in handle.reason


def test_a_start_within_what_the_checker_leaves_is_led_in_without_a_jump(rig, motions):
    q = rig.loop.motion.reference()
    q[7 + rig.model.joint_index(ELBOW)] += 5e-6

    handle = rig.loop.motion.start(motions.arms(q))
    rig.run(2.0)

    assert handle.status is MotionStatus.DONE
    assert rig.loop.statistics.refused == 0


@pytest.mark.requirement("S6")
def test_a_motion_that_waits_for_a_brake_is_refused_where_that_did_not_end_as_foreseen(rig, motions):
    streamer = rig.loop.motion
    first = streamer.start(motions.arms(streamer.reference(), amount=0.8))
    rig.run_until(lambda: first.progress >= 0.5)
    streamer.cancel(first, "enough")
    waiting = streamer.start(motions.arms(streamer.reference()))
    rig.run(0.02)
    assert waiting.status is MotionStatus.RUNNING

    streamer.halt()
    streamer.propose(rig.robot.read())
    streamer.commit()

    assert waiting.status is MotionStatus.REFUSED
    assert "nobody checked" in waiting.reason
    assert streamer.resting


def test_a_trajectory_for_other_feet_is_refused(rig, motions):
    checked = motions.arms(rig.loop.motion.reference())
    (frame, pose), right = checked.trajectory.stance.soles
    moved = pose.copy()
    moved[0, 3] += 0.002
    elsewhere = dataclasses.replace(checked.trajectory, stance=Stance(((frame, moved), right)))

    handle = rig.loop.motion.start(motions.sealed(elsewhere))

    assert handle.status is MotionStatus.REFUSED
    assert frame in handle.reason


@pytest.mark.parametrize(("index", "word"), [(0, "start"), (-1, "end")])
def test_a_trajectory_that_does_not_begin_and_end_at_rest_is_refused(rig, motions, index, word):
    trajectory = motions.arms(rig.loop.motion.reference()).trajectory
    v = trajectory.v.copy()
    v[index, 20] = 0.01

    handle = rig.loop.motion.start(motions.sealed(dataclasses.replace(trajectory, v=v)))

    assert handle.status is MotionStatus.REFUSED
    assert f"does not {word} at rest" in handle.reason


def test_the_body_follows_one_trajectory_at_a_time(rig, motions):
    motion = motions.arms(rig.loop.motion.reference())
    first = rig.loop.motion.start(motion)

    second = rig.loop.motion.start(motion)
    rig.run(1.1)

    assert second.status is MotionStatus.REFUSED
    assert "held by" in second.reason
    assert first.status is MotionStatus.DONE


def test_a_gripper_closes_beside_a_trajectory(rig, motions):
    body = rig.loop.motion.start(motions.arms(rig.loop.motion.reference()))
    gripper = rig.loop.grippers["right"].close()
    rig.run(1.2)

    assert body.status is gripper.status is MotionStatus.DONE
    assert rig.loop.statistics.refused == 0


@pytest.mark.requirement("S7")
@pytest.mark.parametrize("share", [0.02, 0.1, 0.3, 0.5, 0.7, 0.9, 0.97])
def test_a_cancelled_motion_brakes_on_its_path_within_limits(rig, motions, share):
    motion = motions.arms(rig.loop.motion.reference(), amount=0.8)
    handle = rig.loop.motion.start(motion)
    rig.run_until(lambda: handle.progress >= share)
    began = len(rig.robot.commands)

    rig.loop.motion.cancel(handle, "enough")
    rest = rig.loop.motion.reference()
    rig.run(0.6)

    assert (handle.status, handle.reason) == (MotionStatus.CANCELED, "enough")
    assert rig.loop.statistics.refused == 0
    assert limits_kept(rig)
    left, right = (rig.commanded(f"arm_{hand}_2_joint") for hand in ("left", "right"))
    np.testing.assert_allclose(left[:, 0] - left[0, 0], -(right[:, 0] - right[0, 0]), atol=1e-9)
    assert (np.diff(left[:, 0]) >= -1e-12).all()  # never backwards
    assert not rig.robot.commands[-1].v.any()
    np.testing.assert_array_equal(rig.robot.commands[-1].q[:30], rest[7:])
    assert len(rig.robot.commands) > began


def test_a_motion_from_where_a_cancelled_one_will_rest_waits_until_it_rests(rig, motions):
    first = rig.loop.motion.start(motions.arms(rig.loop.motion.reference(), amount=0.8))
    rig.run(0.5)
    rig.loop.motion.cancel(first, "change of mind")

    second = rig.loop.motion.start(motions.arms(rig.loop.motion.reference(), amount=-0.2))
    rig.run(1.5)

    assert second.status is MotionStatus.DONE
    assert rig.loop.statistics.refused == 0
    assert limits_kept(rig)


def test_cancelling_a_waiting_motion_or_a_finished_one_moves_nothing(rig, motions):
    first = rig.loop.motion.start(motions.arms(rig.loop.motion.reference(), amount=0.8))
    rig.run(0.5)
    rig.loop.motion.cancel(first, "change of mind")
    rest = rig.loop.motion.reference()
    second = rig.loop.motion.start(motions.arms(rest))

    rig.loop.motion.cancel(second, "another one")
    rig.loop.motion.cancel(first, "again")
    rig.run(1.5)

    assert second.status is MotionStatus.CANCELED
    assert first.reason == "change of mind"
    np.testing.assert_array_equal(rig.loop.motion.reference(), rest)


def test_events_tell_of_start_and_end_with_the_owner(rig, motions):
    handle = rig.loop.motion.start(motions.arms(rig.loop.motion.reference()))
    rig.run(1.1)

    (started,), (ended,) = rig.of_kind(MotionStarted), rig.of_kind(MotionEnded)
    assert started.owner == ended.owner == handle.owner
    assert started.t_s == 0.0
    assert ended.t_s == pytest.approx(1.0, abs=0.003)
