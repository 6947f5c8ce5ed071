import numpy as np
import pytest

from kinematics.requests.move import MoveRequest
from kinematics.scene.planning_scene import PlanningScene
from robots.control.motion_handle import MotionStatus


@pytest.fixture
def nod(fake):
    """A checked motion of the head."""
    move = MoveRequest(
        fake.motion.reference(),
        fake.motion.stance(),
        PlanningScene(),
        {"head_1_joint": 0.3},
        keep_others=True,
    )
    step = fake.planning.answer(move).step
    return fake.planning.verdict(step.question)


def test_a_trajectory_is_followed_to_its_end(fake, nod, play):
    assert play(fake.motion.start(nod)).status is MotionStatus.DONE
    np.testing.assert_array_equal(fake.motion.reference(), nod.trajectory.q[-1])
    np.testing.assert_array_equal(fake.sensing.state().q[7:], nod.trajectory.q[-1][7:])


def test_a_cancelled_motion_stops_where_it_is(fake, nod):
    handle = fake.motion.start(nod)
    fake.step()
    fake.motion.cancel(handle, "enough")
    held = fake.motion.reference()
    fake.step()

    assert handle.status is MotionStatus.CANCELED
    assert handle.reason == "enough"
    np.testing.assert_array_equal(fake.motion.reference(), held)


def test_cancelling_what_has_ended_changes_nothing(fake, nod, play):
    handle = play(fake.motion.start(nod))

    fake.motion.cancel(handle, "too late")

    assert handle.status is MotionStatus.DONE


def test_a_trajectory_that_starts_elsewhere_is_refused(fake, nod, play):
    play(fake.motion.start(nod))

    assert fake.motion.start(nod).status is MotionStatus.REFUSED


def test_two_motions_of_the_body_at_once_are_refused(fake, nod):
    fake.motion.start(nod)

    assert "another motion" in fake.motion.start(nod).reason


def test_refusals_can_be_switched_on(fake, nod):
    fake.motion.refuse = "the emergency stop is engaged"

    assert fake.motion.start(nod).reason == "the emergency stop is engaged"


def test_a_motion_can_be_refused_on_the_way(fake, nod, play):
    fake.motion.refuse_midway = "velocity"

    handle = play(fake.motion.start(nod))

    assert handle.status is MotionStatus.REFUSED
    assert not np.array_equal(fake.motion.reference(), nod.trajectory.q[-1])


def test_only_checked_trajectories_are_played(fake, nod):
    with pytest.raises(TypeError, match="checked"):
        fake.motion.start(nod.trajectory)
