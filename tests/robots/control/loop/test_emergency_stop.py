"""The emergency stop: every producer ends, the robot brakes within its limits, and only a person resets."""

import numpy as np
import pytest

from robots.control.events import EmergencyReset, EmergencyStopped, MotionStarted, ResetRefused
from robots.control.guarded.guarded_motion import MotionBounds
from robots.control.loop.emergency_stop import EmergencyLatch, PersonsReset
from robots.control.motion_handle import MotionStatus

ANA = PersonsReset("Ana")
HEAD = "head_2_joint"


class Nod:
    """A guarded motion of the head that never ends."""

    name = "nod"

    def __init__(self, description):
        self.start_rad = description.home[HEAD]
        one = np.ones(1)
        self.bounds = MotionBounds((HEAD,), self.start_rad - one, self.start_rad + one, one, 50.0 * one, 9.0)

    def sample(self, elapsed_s, state):
        # At twice the acceleration of each half: 0 to 0.4 rad and back, smooth at both ends.
        return (
            np.array([self.start_rad + 0.2 * (1.0 - np.cos(elapsed_s + 0.002))]),
            np.array([0.2 * np.sin(elapsed_s + 0.002)]),
        )


def start_body(rig, motions):
    return rig.loop.motion.start(motions.arms(rig.loop.motion.reference(), amount=0.8))


def start_head(rig, motions):
    return rig.loop.motion.start(Nod(rig.description))


def start_closing(rig, motions):
    return rig.loop.grippers["left"].close()


def start_opening(rig, motions):
    rig.loop.grippers["left"].close()
    rig.run(1.5)
    return rig.loop.grippers["left"].open()


PRODUCERS = [start_body, start_head, start_closing, start_opening]


def rates(rig, since=0):
    """Largest acceleration and jerk of the setpoints since one, as shares of each joint's limits."""
    limits = [rig.description.limits[name] for name in rig.description.actuated]
    v = np.array([setpoint.v for setpoint in rig.robot.commands[max(since - 2, 0) :]])
    a = np.diff(v, axis=0) / 0.002
    jerk = np.diff(a, axis=0) / 0.002
    return (
        float((np.abs(a[1:]) / [limit.acceleration for limit in limits]).max()),
        float((np.abs(jerk) / [limit.jerk for limit in limits]).max()),
    )


def nothing_moves(rig, periods):
    q = np.array([setpoint.q for setpoint in rig.robot.commands[-periods:]])
    return not np.ptp(q, axis=0).any() and not any(s.v.any() for s in rig.robot.commands[-periods:])


@pytest.mark.requirement("S4")
@pytest.mark.parametrize("category", [1, 2])
@pytest.mark.parametrize("producer", PRODUCERS, ids=lambda start: start.__name__)
def test_it_ends_every_producer_within_half_a_second_and_within_the_limits(rig, motions, producer, category):
    handle = producer(rig, motions)
    rig.run(0.3)
    assert rig.robot.commands[-1].v.any()
    begun = len(rig.robot.commands)

    rig.loop.emergency_stop("a person pressed it", category)
    rig.run(0.5)

    assert handle.status is MotionStatus.CANCELED
    assert "a person pressed it" in handle.reason
    acceleration, jerk = rates(rig, begun)
    assert acceleration <= 1.005
    assert jerk <= 1.005
    rig.run(0.2)
    assert nothing_moves(rig, 100)
    assert rig.loop.statistics.refused == 0


@pytest.mark.requirement("S4")
@pytest.mark.parametrize("producer", PRODUCERS, ids=lambda start: start.__name__)
def test_while_it_is_engaged_every_motion_is_refused_with_the_reason(rig, motions, producer):
    rig.loop.emergency_stop("smoke")
    rig.run(3.0)  # long after everything has come to rest
    before = len(rig.robot.commands)

    handle = producer(rig, motions)
    rig.run(0.5)

    assert handle.status is MotionStatus.REFUSED
    assert handle.reason == "the emergency stop is engaged: smoke"
    assert not rig.of_kind(MotionStarted)
    assert nothing_moves(rig, len(rig.robot.commands) - before)


@pytest.mark.requirement("S4")
def test_only_setpoints_of_the_stop_follow_it(rig, motions):
    start_body(rig, motions)
    rig.loop.grippers["left"].close()
    rig.run(0.3)
    begun = len(rig.robot.commands)

    rig.loop.emergency_stop("a person pressed it")
    rig.run(1.0)

    owners = {part for s in rig.robot.commands[begun:] for part in s.owner.split("+")}
    assert owners == {"stop", "hold", "grip of gripper_left_joint"}


@pytest.mark.requirement("S4")
def test_a_hand_that_holds_something_goes_on_holding_it(rig, motions):
    rig.robot.obstacle_rad["gripper_left_joint"] = -0.233
    rig.loop.grippers["left"].close()
    rig.run(1.5)
    start_body(rig, motions)
    rig.run(0.3)

    rig.loop.emergency_stop("a person pressed it")
    rig.run(2.0)

    assert rig.loop.grippers["left"].reading().holding
    assert rig.loop.grippers["left"].reading().effort_nm > 3.3


@pytest.mark.requirement("S4")
def test_a_persons_reset_lets_motions_in_again_and_moves_nothing_by_itself(rig, motions):
    start_body(rig, motions)
    rig.run(0.3)
    rig.loop.emergency_stop("a person pressed it")
    rig.run(1.0)

    assert rig.loop.reset(ANA) is None
    rig.run(0.5)
    assert nothing_moves(rig, 250)
    handle = rig.loop.motion.start(motions.arms(rig.loop.motion.reference(), amount=-0.1))
    rig.run(1.1)

    assert handle.status is MotionStatus.DONE
    assert rig.loop.emergency is None
    (reset,) = rig.of_kind(EmergencyReset)
    assert reset.person == "Ana"


@pytest.mark.requirement("S4")
def test_a_reset_before_the_robot_rests_is_refused(rig, motions):
    start_body(rig, motions)
    rig.run(0.3)
    rig.loop.emergency_stop("a person pressed it")
    rig.run(0.02)

    assert rig.loop.reset(ANA) == "the robot has not come to rest yet"
    assert rig.loop.emergency is not None
    assert rig.of_kind(ResetRefused)[0].reason == "the robot has not come to rest yet"


def test_a_reset_without_an_emergency_stop_is_refused(rig):
    assert rig.loop.reset(ANA) == "no emergency stop is engaged"


def test_engaging_it_again_changes_nothing_but_the_power_can_still_be_taken_away(rig):
    rig.loop.emergency_stop("first")
    rig.loop.emergency_stop("second", 2)
    assert rig.loop.emergency.reason == "first"
    assert len(rig.of_kind(EmergencyStopped)) == 1

    rig.loop.emergency_stop("smoke", 0)
    rig.run(0.1)

    assert rig.loop.emergency.category == 0
    assert not rig.robot.commands[-1].tau.any()
    assert "the power was taken away" in rig.loop.reset(ANA)


def test_a_spoken_stop_does_not_latch(rig, motions):
    start_body(rig, motions)
    rig.run(0.3)
    rig.loop.stop(2, "stop, said Ana")
    rig.run(1.0)

    handle = rig.loop.motion.start(motions.arms(rig.loop.motion.reference(), amount=-0.1))
    rig.run(1.1)

    assert rig.loop.emergency is None
    assert handle.status is MotionStatus.DONE


def test_a_latch_stays_closed_while_the_robot_is_not_healthy():
    latch = EmergencyLatch()
    latch.engage(1.0, 1, "a person pressed it")

    assert latch.why_not_open(True, ["gyro biased by 0.03 rad/s"]) == (
        "the robot is not healthy: gyro biased by 0.03 rad/s"
    )
    assert latch.why_not_open(True, []) is None


def test_there_is_no_fourth_category(rig):
    with pytest.raises(ValueError, match="no stop category 3"):
        rig.loop.emergency_stop("why not", 3)
    assert rig.loop.emergency is None
