"""The executive's side of the socket, against a real control server on a robot without physics."""

import dataclasses
from concurrent.futures import Future

import numpy as np
import pytest

from executive.live.control_link import AttachRefusedError, ControlLink, ControlLostError
from executive.live.live_guard import LiveGuard
from executive.live.live_steps import DetectorClient, LiveClock, LiveSteps, RangingClient
from executive.live.motion_client import GripperClient, MotionClient
from executive.live.planning_client import LivePlanning, NotAdmittedError
from executive.live.planning_service import Planned
from kinematics.requests import CheckRequest
from kinematics.scene import PlanningScene
from kinematics.trajectory import Finding, FindingKind, Unsafe
from robots.control.events import StopStarted
from robots.control.motion_handle import MotionStatus
from robots.live.messages import Stop
from robots.live.robot_report import ReportLayout, RobotReport
from robots.live.runtime_folder import RuntimeFolder
from robots.live.state_slot import StateSlotWriter
from tests.robots.live.conftest import Client, LiveRig, swing
from trees.world_model import WorldModel


@pytest.fixture(scope="session")
def talos():
    from kinematics.robot_model import RobotModel
    from robots.description import load_description

    return RobotModel(load_description("talos"))


class Far(LiveRig):
    """A control process in this process: it goes on when the link waits."""

    def __init__(self, model, folder):
        self.slot = StateSlotWriter(folder.state_slot, ReportLayout(model).count)
        super().__init__(model, folder)
        self.server._about["slot"] = str(folder.state_slot)
        self.publish()

    def publish(self):
        loop = self.loop
        report = RobotReport(
            self.clock.now_s(),
            loop.motion.resting and not loop.walking.active,
            loop.walking.active,
            loop.sensing.state(),
            loop.motion.reference(),
            loop.motion.stance(),
            {hand: gripper.reading() for hand, gripper in loop.grippers.items()},
        )
        self.slot.write(ReportLayout(self.model).row(report))

    def run(self, seconds, each=lambda: None):
        for _ in range(round(seconds / 0.01)):
            super().run(0.01, each)
            self.publish()


class Executive:
    """Link and toolbox parts, attached."""

    def __init__(self, far, monkeypatch):
        # the greeting is answered while it is waited for
        from robots.live.connection import Connection

        waited = Connection.wait

        def wait(connection, seconds):
            far.run(0.01)
            return waited(connection, 0.0)

        monkeypatch.setattr(Connection, "wait", wait)
        self.far, self.events, self.world = far, [], WorldModel()
        self.link = ControlLink(far.folder, far.model)
        self.link.listen(self.events.append)
        self.motion = MotionClient(self.link)
        self.detector = DetectorClient(self.link)
        self.ranging = RangingClient(self.link)
        self.steps = LiveSteps(self.link, self.detector, self.ranging, self.world)
        self.worker = Worker()
        self.planning = LivePlanning(self.worker, self.link, self.motion, self.world, self.events.append)

    def ticks(self, count):
        for _ in range(10 * count):
            self.steps.step()

    def admitted(self, checked):
        """A trajectory that both sides let pass."""
        job = self.planning.submit(CheckRequest(checked.trajectory, PlanningScene()))
        self.worker.answer(Planned(checked, 0.1, "{}"))
        for _ in range(20):
            if job.done:
                return job.result()
            self.ticks(1)
        raise AssertionError("no verdict")


class Worker:
    def __init__(self):
        self.futures = []

    def ask(self, _question):
        self.futures.append(Future())
        return self.futures[-1]

    def answer(self, planned):
        self.futures[-1].set_result(planned)


@pytest.fixture
def far(talos, tmp_path_factory):
    folder = RuntimeFolder(tmp_path_factory.mktemp("live"))
    folder.make()
    rig = Far(talos, folder)
    yield rig
    rig.close()


@pytest.fixture
def executive(far, monkeypatch):
    attached = Executive(far, monkeypatch)
    yield attached
    attached.link.close()


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
