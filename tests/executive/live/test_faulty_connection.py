"""Frames that come late, never, twice or in another order, and a connection that ends: nothing jumps."""

import contextlib

import numpy as np
import pytest

from executive.live.control_client.control_link import ControlLostError
from executive.live.control_client.planning_client import NotAdmittedError
from executive.live.control_client.planning_service import Planned
from robots.control.motion_handle import MotionStatus
from robots.live.wire.faulty_connection import CONNECTION_FAULTS, FaultyConnection, FaultyLine
from tests.executive.live.conftest import Executive
from tests.robots.live.conftest import swing

PERIOD_S = 0.002


@pytest.fixture
def attach(far, monkeypatch):
    made = []

    def with_fault(fault, seed):
        rng = np.random.default_rng(seed)
        executive = Executive(
            far, monkeypatch, lambda connected: FaultyConnection(connected, fault, rng, far.clock.now_s)
        )
        made.append(executive)
        return executive

    yield with_fault
    for executive in made:
        executive.link.close()


def carried_on(executive, talos, commands):
    """Strike, and go on commanding motions to and fro until the connection is lost; gives the handles."""
    executive.link._connection.strike()
    handles = []
    try:
        for k in range(commands):
            q = executive.motion.reference()
            executive.far.checker.answer = checked = swing(talos, q, 0.2 * (-1) ** k, 0.6)
            job = executive.planning.check("question")
            executive.worker.answer(Planned(checked, 0.0, "{}"))
            for _ in range(40):
                if job.done:
                    break
                executive.ticks(1)
            else:
                continue
            with contextlib.suppress(NotAdmittedError):  # lost, stale or twice, and told so
                handles.append(executive.motion.start(job.result()))
                executive.ticks(40)
    except ControlLostError:
        pass
    return handles


@pytest.mark.requirement("F7", "S4")
@pytest.mark.parametrize("fault", CONNECTION_FAULTS)
def test_whatever_happens_on_the_way_no_setpoint_jumps_and_the_robot_comes_to_rest(attach, talos, fault):
    executive = attach(fault, 3)
    executive.steps.busy = True
    executive.ticks(5)
    far = executive.far
    limit = talos.acceleration.max() * PERIOD_S * 1.001
    before = len(far.robot.commands)

    handles = carried_on(executive, talos, 3)
    stops_on_the_way = far.stops
    far.run(2.5)

    speeds = np.array([setpoint.v for setpoint in far.robot.commands[before:]])
    assert np.abs(np.diff(speeds, axis=0)).max() <= limit
    assert far.loop.statistics.refused == 0
    assert far.loop.motion.resting
    for handle in handles:
        assert handle.status is not MotionStatus.REFUSED or handle.reason
    if fault == "duplicate":
        assert [handle.status for handle in handles] == [MotionStatus.DONE] * 3
        assert not stops_on_the_way


@pytest.mark.requirement("F7")
def test_a_command_that_never_arrives_is_refused_when_the_next_one_does(attach, talos):
    executive = attach("drop", 0)
    executive.ticks(2)
    checked = executive.admitted(swing(talos, executive.motion.reference()))
    send = executive.link._connection.send
    executive.link._connection.send = lambda *_frame: None
    handle = executive.motion.start(checked)
    executive.link._connection.send = send

    executive.ticks(3)

    assert handle.status is MotionStatus.REFUSED
    assert "lost on its way" in handle.reason
    assert executive.far.loop.motion.resting


@pytest.mark.requirement("F7")
def test_a_trajectory_that_was_lost_on_its_way_to_the_checker_is_sent_again(attach, talos):
    executive = attach("drop", 0)
    checked = swing(talos, executive.motion.reference())
    job = executive.planning.check("question")
    executive.worker.answer(Planned(checked, 0.0, "{}"))
    send = executive.link._connection.send
    executive.link._connection.send = lambda *_frame: None
    assert not job.done
    executive.link._connection.send = send

    executive.ticks(5)

    assert job.done
    assert job.result() is checked


@pytest.mark.requirement("F7", "S7")
def test_a_cancel_that_never_arrives_is_said_again(attach, talos):
    executive = attach("drop", 0)
    handle = executive.motion.start(executive.admitted(swing(talos, executive.motion.reference())))
    executive.ticks(10)
    send = executive.link._connection.send
    executive.link._connection.send = lambda *_frame: None
    executive.motion.cancel(handle, "enough")
    executive.link._connection.send = send

    executive.ticks(30)

    assert executive.link.report.resting
    assert np.abs(executive.motion.reference() - talos.q_home).max() < 0.29


@pytest.mark.requirement("F7")
def test_a_command_that_comes_too_late_is_refused_as_stale(attach, talos):
    executive = attach("delay", 0)
    checked = executive.admitted(swing(talos, executive.motion.reference()))
    send, late = executive.link._connection.send, []
    executive.link._connection.send = lambda *frame: late.append(frame)
    handle = executive.motion.start(checked)
    executive.far.run(0.6)
    executive.link._connection.send = send
    for frame in late:
        send(*frame)

    executive.ticks(3)

    assert handle.status is MotionStatus.REFUSED
    assert "stale" in handle.reason


@pytest.mark.requirement("F7", "S3")
def test_a_connection_that_is_cut_brakes_what_moves(attach, talos):
    executive = attach("cut", 0)
    executive.motion.start(executive.admitted(swing(talos, executive.motion.reference())))
    executive.ticks(15)
    cut_s = executive.far.clock.now_s()

    executive.link._connection.strike()
    with pytest.raises(ControlLostError):
        executive.ticks(5)

    executive.far.run(0.05)
    (stop,) = executive.far.stops
    assert stop.t_s - cut_s <= 0.1


@pytest.mark.parametrize("fault", ["drop", "duplicate", "reorder", "delay"])
def test_a_faulty_line_does_what_its_name_says(fault):
    t_s = [0.0]
    line = FaultyLine(fault, np.random.default_rng(1), lambda: t_s[0])
    out = []
    for k in range(400):
        t_s[0] = 0.01 * k
        out += line.put(k) + line.due()
    t_s[0] = 100.0
    out += line.due()

    if fault == "drop":
        assert out == sorted(set(out))
        assert 250 < len(out) < 380
    elif fault == "duplicate":
        assert sorted(set(out)) == list(range(400))
        assert 420 < len(out) < 550
    elif fault == "reorder":
        assert out != sorted(out)
        assert set(range(398)) <= set(out)
    else:
        assert out == list(range(400))
