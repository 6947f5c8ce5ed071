"""The executive's parts, attached to a control server in the same process."""

from concurrent.futures import Future

import pytest

from executive.live.control_client.control_link import ControlLink
from executive.live.control_client.live_steps import DetectorClient, LiveSteps, RangingClient
from executive.live.control_client.motion_client import MotionClient
from executive.live.control_client.planning_client import LivePlanning
from executive.live.control_client.planning_service import Planned
from executive.live.control_client.walking_client import WalkingClient
from executive.live.control_client.yielding_client import YieldingClient
from kinematics.model.robot_model import RobotModel
from kinematics.requests.check import CheckRequest
from kinematics.scene.planning_scene import PlanningScene
from robots.live.documents.robot_report import ReportLayout, RobotReport
from robots.live.wire.connection import Connection
from robots.live.wire.runtime_folder import RuntimeFolder
from robots.live.wire.state_slot import StateSlotWriter
from robots.models.description import load_description
from tests.robots.live.conftest import LiveRig
from trees.world_model import WorldModel


@pytest.fixture(scope="session")
def talos():
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


def go_on_while_waited_for(far, monkeypatch):
    """Let the control process go on while it is waited for: so it answers the greeting."""
    waited = Connection.wait

    def wait(connection, seconds):
        far.run(0.01)
        return waited(connection, 0.0)

    monkeypatch.setattr(Connection, "wait", wait)


class Executive:
    """Link and toolbox parts, attached."""

    def __init__(self, far, monkeypatch, connection=Connection):
        go_on_while_waited_for(far, monkeypatch)
        self.far, self.events, self.world = far, [], WorldModel()
        self.link = ControlLink(far.folder, far.model, connection)
        self.link.listen(self.events.append)
        self.motion = MotionClient(self.link)
        self.detector = DetectorClient(self.link)
        self.ranging = RangingClient(self.link)
        self.steps = LiveSteps(self.link, self.detector, self.ranging, self.world)
        self.walking = WalkingClient(self.link, self.motion)
        self.yielding = YieldingClient(self.link, self.motion, far.model, self.world)
        self.worker = Worker()
        self.planning = LivePlanning(self.worker, self.link, self.motion, self.world, self.events.append)

    def ticks(self, count):
        for _ in range(10 * count):
            self.steps.step()

    def admitted(self, checked, document="{}"):
        """A trajectory that both sides let pass."""
        job = self.planning.check(CheckRequest(checked.trajectory, PlanningScene()))
        self.worker.answer(Planned(checked, 0.1, document))
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
