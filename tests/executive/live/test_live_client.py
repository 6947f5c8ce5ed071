"""The executive's side of the socket, against a real control server on a robot without physics."""

import dataclasses
import gc
import weakref

import numpy as np
import pytest

from executive.live.control_client.control_link import AttachRefusedError, ControlLink, ControlLostError
from executive.live.control_client.live_guard import LiveGuard
from executive.live.control_client.live_steps import LiveClock
from executive.live.control_client.motion_client import GripperClient
from executive.live.control_client.planning_client import NotAdmittedError
from executive.live.control_client.planning_service import Planned
from kinematics.motion.verdict import Finding, FindingKind, Unsafe
from robots.control.events import StopStarted
from robots.control.motion_handle import MotionStatus
from robots.live.wire.messages import Stop
from tests.robots.live.conftest import Client, swing


def test_a_motion_that_both_sides_checked_is_carried_out(executive, talos):
    checked = executive.admitted(swing(talos, executive.motion.reference()))

    handle = executive.motion.start(checked)
    executive.ticks(70)

    assert handle.status is MotionStatus.DONE
    np.testing.assert_allclose(executive.motion.reference()[7:], checked.trajectory.q[-1, 7:], atol=1e-9)


@pytest.mark.requirement("S6")
def test_a_motion_that_only_this_side_checked_is_refused(executive, talos):
    handle = executive.motion.start(swing(talos, executive.motion.reference()))

    assert handle.status is MotionStatus.REFUSED


class Document(str):
    """One whose end can be seen."""


@pytest.mark.parametrize("verdict", [None, Unsafe((Finding(FindingKind.BALANCE, 0.1, ("CoM",), 0.0, 0.02),))])
def test_the_document_of_a_trajectory_is_let_go_once_it_is_judged(executive, talos, verdict):
    executive.far.checker.answer = verdict or executive.far.checker.answer
    document = Document("{}")
    kept = weakref.ref(document)

    executive.admitted(swing(talos, executive.motion.reference()), document)
    executive.worker.futures.clear()
    del document
    gc.collect()

    assert kept() is None


@pytest.mark.requirement("S6")
def test_the_other_sides_no_is_the_answer_of_the_check(executive, talos):
    executive.far.checker.answer = Unsafe((Finding(FindingKind.BALANCE, 0.1, ("CoM",), 0.0, 0.02),))
    assert isinstance(executive.admitted(swing(talos, talos.q_home)), Unsafe)

    executive.far.checker.answer = "nobody judged it"
    with pytest.raises(NotAdmittedError, match="nobody"):
        executive.admitted(swing(talos, talos.q_home))


@pytest.mark.requirement("S3")
def test_a_tick_that_does_not_end_sends_no_heartbeat_and_the_robot_is_stopped(executive, talos):
    executive.steps.busy = True
    handle = executive.motion.start(executive.admitted(swing(talos, talos.q_home)))
    executive.ticks(5)
    hung_s = executive.link.now_s

    executive.far.run(1.4)

    (stop,) = executive.far.stops
    assert stop.t_s - hung_s <= 1.13
    with pytest.raises(ControlLostError, match="no heartbeat"):
        executive.ticks(5)
    assert handle.finished


@pytest.mark.requirement("S3")
def test_ticks_that_go_on_are_enough_to_keep_the_watchdog_quiet(executive):
    executive.steps.busy = True

    executive.ticks(150)

    assert not executive.far.stops
    assert LiveClock(executive.link).now_s() >= 3.0


def test_a_motion_that_is_cancelled_is_braked_by_the_other_side(executive, talos):
    handle = executive.motion.start(executive.admitted(swing(talos, talos.q_home)))
    executive.ticks(10)

    executive.motion.cancel(handle, "enough")
    assert handle.status is MotionStatus.CANCELED
    executive.ticks(40)

    assert executive.link.report.resting
    moved = np.abs(executive.motion.reference() - talos.q_home).max()
    assert 0.0 < moved < 0.29


def test_a_gripper_opens_and_closes_across_the_socket(executive):
    gripper = GripperClient(executive.link, executive.motion, "left")
    handle = gripper.close()
    executive.ticks(120)

    assert handle.status is MotionStatus.DONE
    assert gripper.reading().opening_m < 0.05


@pytest.mark.requirement("S4")
def test_the_latch_of_the_control_process_is_what_the_executive_sees(executive):
    guard = LiveGuard(executive.link)
    stranger = Client(executive.far)
    stranger.say(Stop(1, "a person said so"))
    executive.ticks(2)

    assert guard.emergency.reason == "a person said so"
    assert [event.category for event in executive.events if isinstance(event, StopStarted)] == [1]
    executive.link.close()
    again = ControlLink(executive.far.folder, executive.far.model)
    assert again.emergency.reason == "a person said so"
    again.close()
    stranger.connection.close("")


def test_a_second_executive_is_refused_with_the_first_ones_process(executive):
    with pytest.raises(AttachRefusedError, match="commands the robot already"):
        ControlLink(executive.far.folder, executive.far.model)


def test_frames_are_wanted_only_for_a_while_after_they_were_asked_for(executive):
    assert not executive.detector.looking
    executive.detector.latest()
    assert executive.detector.looking

    executive.ticks(30)

    assert not executive.detector.looking


def test_a_plan_comes_back_as_the_worker_gave_it(executive):
    job = executive.planning.submit("request")
    assert not job.done
    executive.worker.answer(Planned("no plan", 0.2))

    assert job.done
    assert job.result() == "no plan"
    assert executive.planning.wall_s == pytest.approx(0.2)
    assert dataclasses.asdict(executive.events[-1])["answer"] == "str"


@pytest.mark.requirement("S7")
def test_what_is_paused_holds_and_goes_on_where_it_was(executive, talos):
    checked = executive.admitted(swing(talos, executive.motion.reference()))
    handle = executive.motion.start(checked)
    executive.ticks(15)

    executive.link.pause("a moment")
    executive.ticks(40)
    held = executive.far.loop.setpoint.q.copy()
    executive.ticks(20)

    np.testing.assert_array_equal(executive.far.loop.setpoint.q, held)
    assert handle.status is MotionStatus.RUNNING
    executive.link.resume()
    executive.ticks(80)
    assert handle.status is MotionStatus.DONE
    np.testing.assert_allclose(executive.motion.reference()[7:], checked.trajectory.q[-1, 7:], atol=1e-9)


@pytest.mark.requirement("S3")
def test_what_was_paused_ends_with_its_executive(executive, talos):
    handle = executive.motion.start(executive.admitted(swing(talos, executive.motion.reference())))
    executive.ticks(15)
    executive.link.pause("a moment")
    executive.ticks(40)

    executive.link.close()
    executive.far.run(0.5)

    assert not executive.far.loop.paused
    assert executive.far.loop.motion.resting
    assert handle.status is not MotionStatus.DONE
