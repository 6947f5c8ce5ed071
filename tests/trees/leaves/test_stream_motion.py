import numpy as np
import pytest
from py_trees.common import Status

from trees.failures import FailureKind
from trees.leaves.stream_motion import StreamMotion


def test_the_robot_ends_where_the_trajectory_ends(knowing, planned):
    checked = planned.checked("reach")

    assert knowing.run(StreamMotion("stream", knowing.toolbox), checked=checked) is Status.SUCCESS
    np.testing.assert_allclose(knowing.fake.sensing.state().q[7:], checked.checked.trajectory.q[-1][7:])


def test_a_stale_step_never_starts(knowing, planned):
    checked = planned.checked("reach")
    knowing.told.update(knowing.told.scene.with_objects([]))
    leaf = StreamMotion("stream", knowing.toolbox)

    assert knowing.run(leaf, checked=checked) is Status.FAILURE
    assert "stale" in leaf.failure.message
    assert knowing.fake.motion.started == []


def test_a_step_that_does_not_start_here_is_refused(knowing, planned):
    leaf = StreamMotion("stream", knowing.toolbox)

    assert knowing.run(leaf, checked=planned.checked("approach")) is Status.FAILURE
    assert leaf.failure.kind is FailureKind.REFUSED


def test_a_refusal_on_the_way_says_why_and_how_far_it_got(knowing, planned):
    knowing.fake.motion.refuse_midway = "velocity of arm_right_3_joint"
    leaf = StreamMotion("stream", knowing.toolbox)

    assert knowing.run(leaf, checked=planned.checked("reach")) is Status.FAILURE
    assert leaf.failure.kind is FailureKind.REFUSED
    assert "velocity of arm_right_3_joint" in leaf.failure.message
    assert 0.4 < leaf.failure.numbers["progress"] < 1.0


def test_a_motion_that_somebody_else_stops_is_an_execution_failure(knowing, planned):
    leaf = knowing.ready(StreamMotion("stream", knowing.toolbox), checked=planned.checked("reach"))
    knowing.tick(leaf)
    knowing.fake.motion.cancel(leaf._handle, "emergency stop")

    assert knowing.tick(leaf) is Status.FAILURE
    assert leaf.failure.kind is FailureKind.EXECUTION
    assert "emergency stop" in leaf.failure.message


def test_a_joint_that_stays_behind_is_named(knowing, planned):
    checked = planned.checked("reach")
    moves = np.abs(checked.checked.trajectory.q[-1] - checked.checked.trajectory.q[0])[7:]
    joint = knowing.toolbox.model.joints[int(np.argmax(moves))]
    knowing.fake.robot.stuck.add(joint)
    leaf = StreamMotion("stream", knowing.toolbox)

    assert knowing.run(leaf, checked=checked) is Status.FAILURE
    assert leaf.failure.numbers["joint"] == joint


@pytest.mark.requirement("S7")
def test_a_halt_stops_the_motion(knowing, planned):
    leaf = knowing.ready(StreamMotion("stream", knowing.toolbox), checked=planned.checked("reach"))
    knowing.tick(leaf)
    knowing.tick(leaf)

    leaf.stop(Status.INVALID)

    assert not knowing.fake.motion.moving
