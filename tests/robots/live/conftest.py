"""A control server on a robot without physics, with a real socket in a private folder."""

from __future__ import annotations

from concurrent.futures import Future

import numpy as np
import pytest

from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import stance_at
from kinematics.motion.trajectory import Trajectory
from kinematics.motion.verdict import CheckedTrajectory, _Seal
from robots.clock import ManualClock
from robots.control.loop.control_loop import ControlLoop
from robots.fake.fake_robot import FakeRobot
from robots.fake.fake_sensing import FakeRangeSensor
from robots.live.process.control_server import ControlServer
from robots.live.wire.connection import Connection
from robots.live.wire.framing import FrameKind
from robots.live.wire.messages import Admit, Hello, read_object, write_control_message
from robots.live.wire.runtime_folder import RuntimeFolder
from robots.live.wire.unix_socket import connect_to
from robots.models.description import load_description, load_robot

HARDWARE = load_robot("talos").hardware

PERIOD_S = 0.002


@pytest.fixture(scope="session")
def talos():
    return RobotModel(load_description("talos"))


@pytest.fixture
def folder(tmp_path_factory):
    made = RuntimeFolder(tmp_path_factory.mktemp("live"))
    made.make()
    return made


def swing(model, q, amount=0.3, duration_s=1.0):
    """One arm joint from rest to rest, sealed without having been checked."""
    n = 100
    t = np.linspace(0.0, duration_s, n + 1)
    u = t / duration_s
    s, ds = u**3 * (10 - 15 * u + 6 * u**2), 30 * u**2 * (1 - u) ** 2 / duration_s
    qs, vs = np.repeat(q[None], n + 1, axis=0), np.zeros((n + 1, model.nv))
    i = model.joint_index("arm_left_2_joint")
    qs[:, 7 + i] += amount * s
    vs[:, 6 + i] = amount * ds
    trajectory = Trajectory(model.joints, stance_at(model, q), t, qs, vs)
    return CheckedTrajectory(trajectory, 0.1, 0.1, _Seal(trajectory))


@pytest.fixture(scope="session", name="swing")
def swing_fixture(talos):
    return lambda amount=0.2: swing(talos, talos.q_home, amount)


class Checker:
    """Answers what it was told to, at once or when asked to."""

    def __init__(self):
        self.answer, self.documents, self.waiting = "not judged", [], []
        self.at_once = True

    def ask(self, question):
        self.documents.append(question)
        future = Future()
        if self.at_once:
            future.set_result(self.answer)
        self.waiting.append(future)
        return future


class NoFrames:
    def latest(self):
        return None


class Client:
    """Somebody at the other end of the socket."""

    def __init__(self, rig, role=None):
        self.rig, self.number = rig, 0
        self.connection = Connection(connect_to(rig.folder.control_socket))
        self.heard = []
        if role is not None:
            self.say(Hello(role))
            rig.run(0.01)

    def say(self, message):
        self.connection.send(write_control_message(message))

    def raw(self, payload, kind=FrameKind.MESSAGE):
        self.connection.send(payload, kind)

    def next(self):
        self.number += 1
        return self.number, self.rig.clock.now_s()

    def admit(self, trajectory, world_version=0, document=b"{}"):
        head = write_control_message(Admit(*self.next(), trajectory, world_version))
        self.connection.send(head + b"\n" + document, FrameKind.DOCUMENT)

    def listen(self):
        if not self.connection.closed:
            while frames := self.connection.receive():
                self.heard += [read_object(frame.payload) for frame in frames]
        return self.heard

    def of(self, kind):
        return [message for message in self.listen() if message["type"] == kind]


class Weightless(FakeRobot):
    """Its motors give exactly what they were told to."""

    def __init__(self, *arguments):
        super().__init__(*arguments)
        self.commands = []

    def command(self, setpoint):
        super().command(setpoint)
        self.commands.append(setpoint)
        self.effort = setpoint.tau


class LiveRig:
    def __init__(self, model, folder):
        self.folder, self.model = folder, model
        self.clock, self.checker = ManualClock(), Checker()
        self.robot = Weightless(model, HARDWARE, self.clock)
        self.ranging = FakeRangeSensor()
        self.ranging.silent = True
        self.server, self.clients, self.offered_at_s = None, [], []
        self.loop = ControlLoop(self.robot, model, self.clock, self.note, PERIOD_S)
        about = {
            "robot": "talos",
            "scene": "none",
            "labels": None,
            "fronts": [],
            "seed": 0,
            "period_s": PERIOD_S,
            "state_every_s": 0.01,
            "slot": "none",
        }
        self.server = ControlServer(
            folder.control_socket,
            self.loop,
            self.clock,
            NoFrames(),
            self.checker,
            about,
            ranging=self.ranging,
            on_offer=lambda person: self.offered_at_s.append((self.clock.now_s(), person)),
        )
        self.checker.answer = swing(model, self.loop.motion.reference())

    def note(self, event):
        if self.server is not None:
            self.server.note(event)

    def run(self, seconds, each=lambda: None):
        for _ in range(round(seconds / PERIOD_S)):
            each()
            self.server.poll()
            self.loop.step()

    def client(self, role=None):
        self.clients.append(Client(self, role))
        return self.clients[-1]

    def close(self):
        self.server.close()
        for client in self.clients:
            client.connection.close("")

    @property
    def stops(self):
        return self.loop.statistics.stops


@pytest.fixture
def live(talos, folder):
    rig = LiveRig(talos, folder)
    yield rig
    rig.close()
