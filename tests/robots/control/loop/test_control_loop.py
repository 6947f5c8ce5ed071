import dataclasses

import numpy as np
import pytest

from robots.control.events import HealthChanged, SetpointRefused, StopStarted
from robots.control.guarded.guarded_motion import MotionBounds
from robots.control.loop.emergency_stop import PersonsReset
from robots.control.motion_handle import MotionStatus

ELBOW = "arm_left_2_joint"
NECK = "head_1_joint"


class Sway:
    """A guarded motion of one joint of the head at constant acceleration."""

    name = "sway"

    def __init__(self, start_rad, acceleration=1.0, velocity=1.0, effort=50.0, duration_s=1.0, span_rad=0.5):
        self.acceleration, self.start_rad = acceleration, start_rad
        self.bounds = MotionBounds(
            (NECK,),
            np.array([start_rad - span_rad]),
            np.array([start_rad + span_rad]),
            np.array([velocity]),
            np.array([effort]),
            duration_s,
        )
        self.ends_s = np.inf
        self.raises_at_s = np.inf

    def sample(self, elapsed_s, state):
        t = elapsed_s + 0.002
        if elapsed_s >= self.raises_at_s:
            raise RuntimeError("the sway has a bug")
        if elapsed_s >= self.ends_s:
            return None
        q = self.start_rad - 0.5 * self.acceleration * t * t
        return np.array([q]), np.array([-self.acceleration * t])


@pytest.fixture
def sway(rig):
    start = rig.description.home[NECK]
    return lambda **bounds: Sway(start, **bounds)


def with_a_bump(motions, q, model):
    """A trajectory whose elbow goes over its acceleration limit half way."""
    checked = motions.arms(q, amount=0.3)
    v = checked.trajectory.v.copy()
    v[60, 6 + model.joint_index(ELBOW)] += 0.2
    return motions.sealed(dataclasses.replace(checked.trajectory, v=v))


def resting_at_the_end(rig):
    q = [setpoint.q for setpoint in rig.robot.commands[-100:]]
    return not rig.robot.commands[-1].v.any() and not np.ptp(q, axis=0).any()


def test_each_step_commands_the_robot_once_and_moves_time_by_a_period(rig):
    rig.run(0.1)

    assert len(rig.robot.commands) == 50
    assert rig.clock.now_s() == pytest.approx(0.1)
    assert [setpoint.sequence for setpoint in rig.robot.commands] == list(range(1, 51))


def test_a_holding_robot_gets_the_same_setpoint_again_and_again(rig):
    rig.run(0.2)

    first, last = rig.robot.commands[0], rig.robot.commands[-1]
    np.testing.assert_array_equal(first.q, last.q)
    np.testing.assert_array_equal(first.tau, last.tau)
    assert not last.v.any()
    assert last.owner == "hold"


@pytest.mark.requirement("S1")
def test_a_refused_setpoint_starts_the_stop_and_the_robot_holds(rig, motions):
    handle = rig.loop.motion.start(with_a_bump(motions, rig.loop.motion.reference(), rig.model))
    rig.run(2.0)

    (refused,), (stopped,) = rig.of_kind(SetpointRefused), rig.of_kind(StopStarted)
    assert (refused.limit, refused.joint) == ("acceleration limit", ELBOW)
    assert abs(refused.value) > abs(refused.bound) == 8.0
    assert refused.owner == handle.owner
    assert ELBOW in stopped.reason
    assert handle.status is MotionStatus.REFUSED
    assert ELBOW in handle.reason
    assert resting_at_the_end(rig)
    assert rig.loop.statistics.stops == (stopped,)


@pytest.mark.requirement("S1")
def test_no_refused_value_ever_reaches_the_robot(rig, motions):
    rig.loop.motion.start(with_a_bump(motions, rig.loop.motion.reference(), rig.model))
    rig.run(2.0)

    v = np.array([setpoint.v for setpoint in rig.robot.commands])
    limit = np.array([rig.description.limits[name].acceleration for name in rig.description.actuated])
    assert (np.abs(np.diff(v, axis=0)) <= limit * 0.002 * 1.005).all()


def test_after_a_stop_the_robot_can_be_moved_again(rig, motions):
    rig.loop.motion.start(with_a_bump(motions, rig.loop.motion.reference(), rig.model))
    rig.run(2.0)

    handle = rig.loop.motion.start(motions.arms(rig.loop.motion.reference(), amount=-0.1))
    rig.run(1.1)

    assert handle.status is MotionStatus.DONE


def test_a_motion_towards_a_position_limit_is_held_before_it(rig, motions):
    q = rig.loop.motion.reference()
    upper = rig.description.limits[ELBOW].position[1]
    checked = motions.joint(q, ELBOW, upper - q[7 + rig.model.joint_index(ELBOW)] + 0.05, duration_s=3.0)

    handle = rig.loop.motion.start(checked)
    rig.run(4.0)

    assert handle.status is MotionStatus.REFUSED
    assert "position limit" in handle.reason
    assert rig.commanded(ELBOW)[:, 0].max() <= upper + 1e-8
    assert resting_at_the_end(rig)
    assert len(rig.of_kind(StopStarted)) == 1


@pytest.mark.requirement("S7")
@pytest.mark.parametrize("category", [1, 2])
def test_a_stop_brings_the_body_to_rest_within_its_limits(rig, motions, category):
    handle = rig.loop.motion.start(motions.arms(rig.loop.motion.reference(), amount=0.8))
    rig.run(0.3)

    rig.loop.stop(category, "a person wants it")
    late = rig.loop.motion.start(motions.arms(rig.loop.motion.reference()))
    rig.run(0.8)

    assert (handle.status, handle.reason) == (MotionStatus.CANCELED, "a person wants it")
    assert late.status is MotionStatus.REFUSED
    assert resting_at_the_end(rig)
    jerk = np.diff([setpoint.v[:30] for setpoint in rig.robot.commands], n=2, axis=0) / 0.002**2
    assert np.abs(jerk).max() <= 120.0 * 1.005
    assert rig.loop.statistics.refused == 0
    assert [(stop.category, stop.reason) for stop in rig.loop.statistics.stops] == [
        (category, "a person wants it")
    ]


def test_stop_category_two_is_sooner_at_rest_than_one(rig, motions):
    def time_to_rest(category):
        rig.loop.motion.start(motions.arms(rig.loop.motion.reference(), amount=0.5))
        rig.run(0.5)
        began = len(rig.robot.commands)
        rig.loop.stop(category, "test")
        rig.run_until(lambda: rig.loop.motion.resting)
        return len(rig.robot.commands) - began

    assert time_to_rest(2) <= time_to_rest(1)


def test_a_stop_of_category_zero_takes_the_effort_away_for_good(rig, motions):
    rig.loop.stop(0, "power off")
    handle = rig.loop.motion.start(motions.arms(rig.loop.motion.reference()))
    rig.run(0.1)

    last = rig.robot.commands[-1]
    np.testing.assert_array_equal(last.q, rig.loop.sensing.state().readings.q)
    assert not last.tau.any()
    assert handle.status is MotionStatus.REFUSED


def test_there_is_no_fourth_stop_category(rig):
    with pytest.raises(ValueError, match="no stop category 3"):
        rig.loop.stop(3, "why not")


def test_a_guarded_motion_of_the_head_ends_in_rest(rig, sway):
    motion = sway()
    motion.ends_s = 0.3
    handle = rig.loop.motion.start(motion)
    rig.run(1.0)

    assert handle.status is MotionStatus.DONE
    assert rig.loop.statistics.refused == 0
    assert resting_at_the_end(rig)


@pytest.mark.requirement("S6")
@pytest.mark.parametrize("joint", ["arm_right_2_joint", "torso_1_joint", "leg_left_4_joint"])
def test_a_guarded_motion_whose_collisions_and_balance_cannot_be_judged_is_not_begun(rig, sway, joint):
    motion = sway()
    motion.bounds = dataclasses.replace(motion.bounds, joints=(joint,))

    handle = rig.loop.motion.start(motion)
    rig.run(0.5)

    assert handle.status is MotionStatus.REFUSED
    assert f"sway moves {joint}" in handle.reason
    assert "only a BodyMotion" in handle.reason
    assert rig.loop.still
    assert rig.loop.statistics.refused == 0


@pytest.mark.parametrize(
    ("bounds", "limit"),
    [
        ({"span_rad": 0.02}, "position limit"),
        ({"velocity": 0.2}, "velocity limit"),
        ({"effort": 1e-6}, "measured effort"),
        ({"duration_s": 0.1}, "duration"),
        ({"acceleration": 8.5, "velocity": 9.0}, "acceleration limit"),
    ],
)
def test_a_guarded_motion_that_breaks_its_bounds_is_stopped_with_the_reason(rig, sway, bounds, limit):
    handle = rig.loop.motion.start(sway(**bounds))
    rig.run(1.0)

    assert handle.status is MotionStatus.REFUSED
    assert handle.reason.startswith(limit)
    assert rig.of_kind(SetpointRefused)[0].limit == limit
    assert rig.loop.statistics.refused == 1
    assert resting_at_the_end(rig)


@pytest.mark.requirement("S8")
def test_a_guarded_motion_that_raises_fails_alone_and_the_loop_goes_on(rig, sway):
    motion = sway()
    motion.raises_at_s = 0.2
    handle = rig.loop.motion.start(motion)
    rig.run(1.0)

    assert handle.status is MotionStatus.REFUSED
    assert "the sway has a bug" in handle.reason
    assert resting_at_the_end(rig)


@pytest.mark.requirement("S8")
def test_a_defect_of_the_loop_itself_leaves_the_robot_holding_and_is_raised(rig, motions, monkeypatch):
    handle = rig.loop.motion.start(motions.arms(rig.loop.motion.reference()))
    rig.loop.grippers["left"].close()
    rig.run(0.3)
    before = rig.robot.commands[-1]
    with monkeypatch.context() as patch:
        patch.setattr(rig.loop.motion, "propose", lambda state: 1 / 0)
        with pytest.raises(ZeroDivisionError):
            rig.loop.step()

    held = rig.robot.commands[-1]
    assert held.sequence == before.sequence + 1
    np.testing.assert_array_equal(held.q, before.q)
    assert not held.v.any()
    assert rig.clock.now_s() == pytest.approx(0.302)
    assert handle.status is MotionStatus.REFUSED
    assert "ZeroDivisionError" in handle.reason
    rig.run(0.5)
    assert rig.loop.statistics.refused == 0
    assert resting_at_the_end(rig)


def test_the_past_can_be_asked_for_by_its_stamp(rig):
    rig.run(1.5)

    assert rig.loop.sensing.state().readings.stamp_s == pytest.approx(1.5)
    assert rig.loop.sensing.state_at(1.2345).readings.stamp_s == pytest.approx(1.234, abs=1e-6)
    assert rig.loop.sensing.state_at(99.0) is rig.loop.sensing.state()
    assert rig.loop.sensing.state_at(-1.0).readings.stamp_s == pytest.approx(0.0)


def test_two_runs_command_bit_for_bit_the_same(new_rig, motions):
    def run():
        rig = new_rig()
        rig.loop.motion.start(motions.arms(rig.loop.motion.reference()))
        rig.loop.grippers["left"].close()
        rig.run(1.2)
        return b"".join(s.q.tobytes() + s.v.tobytes() + s.tau.tobytes() for s in rig.robot.commands)

    assert run() == run()


def test_a_gripper_on_the_move_goes_on_smoothly_when_something_else_is_refused(rig, sway):
    rig.loop.motion.start(sway(duration_s=0.1))
    gripper = rig.loop.grippers["left"].close()
    rig.run(0.098)
    rig.loop.motion.cancel(gripper, "just before the sway's time is up")
    rig.run(0.5)

    q = rig.commanded("gripper_left_joint")
    np.testing.assert_allclose(np.diff(q[:, 0]), 0.001 * (q[1:, 1] + q[:-1, 1]), atol=1e-12)
    assert rig.loop.statistics.refused == 1


@pytest.mark.requirement("F5")
def test_a_stuck_joint_stops_the_robot_and_no_motion_is_taken_until_a_person_has_looked(rig, motions):
    rig.run(0.5)
    rig.robot.stuck_rad["head_1_joint"] = rig.description.home["head_1_joint"]
    handle = rig.loop.motion.start(motions.joint(rig.loop.motion.reference(), "head_1_joint", 0.3))
    rig.run(1.5)

    assert handle.status is MotionStatus.CANCELED
    assert "joint stuck: head_1_joint" in handle.reason
    assert rig.of_kind(HealthChanged)[0].ailment == "joint stuck"
    again = rig.loop.motion.start(motions.arms(rig.loop.motion.reference(), amount=0.1))
    assert again.status is MotionStatus.REFUSED
    assert "joint stuck: head_1_joint" in again.reason
    assert resting_at_the_end(rig)

    del rig.robot.stuck_rad["head_1_joint"]
    rig.run(0.02)  # it snaps back
    rig.loop.reset(PersonsReset("Ana"))
    mended = rig.loop.motion.start(motions.arms(rig.loop.motion.reference(), amount=0.1))
    rig.run(1.5)

    assert mended.status is MotionStatus.DONE
