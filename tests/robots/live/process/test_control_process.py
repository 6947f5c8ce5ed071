"""The control process about a body that is not simulated: it is attached, commanded, and seen by nobody."""

import threading
from importlib.metadata import EntryPoint
from pathlib import Path

import pytest

from kinematics.model.robot_model import RobotModel
from robots.fake.fake_robot import FakeRobot
from robots.interface import bodies
from robots.interface.bodies import BodyError
from robots.live.process.control_process import ControlOptions, ControlProcess
from robots.live.wire.connection import Connection
from robots.live.wire.messages import Hello, read_object, write_control_message
from robots.live.wire.runtime_folder import RuntimeFolder
from robots.live.wire.unix_socket import connect_to

ATTACHED = []


class Body(FakeRobot):
    """Counts the periods that it is waited for."""

    def __init__(self, data, clock, options):
        super().__init__(RobotModel(data.description), data.hardware, clock)
        self.options, self.commands, self.waited_s = options, 0, 0.0

    def command(self, setpoint):
        self.commands += 1
        super().command(setpoint)

    def advance(self, period_s):
        self.waited_s += period_s
        super().advance(period_s)


def attach(data, clock, options):
    ATTACHED.append(Body(data, clock, options))
    return ATTACHED[-1]


@pytest.fixture
def options(monkeypatch, tmp_path):
    point = EntryPoint("mine", f"{__name__}:attach", "humanoid_executive.bodies")
    listed = bodies.importlib.metadata.entry_points

    def entry_points(**asked):
        return [point] if asked.get("group") == point.group else listed(**asked)

    monkeypatch.setattr(bodies.importlib.metadata, "entry_points", entry_points)
    ATTACHED.clear()
    return lambda body, *more: ControlOptions(
        Path(tmp_path), "talos", "tabletop", 0, realtime=False, body=body, body_options=more
    )


def greeted(folder):
    """What somebody who connects is told."""
    connection = Connection(connect_to(folder.control_socket))
    connection.send(write_control_message(Hello("observer")))
    for _ in range(200):
        connection.wait(0.1)
        for frame in connection.receive():
            connection.close("")
            return read_object(frame.payload)
    raise AssertionError("no welcome")


def test_a_body_is_attached_with_its_options_commanded_each_period_and_brings_no_eyes(options, tmp_path):
    process = ControlProcess(options("mine", ("port", "7"), ("mode", "soft")))
    (body,) = ATTACHED
    thread = threading.Thread(target=process.run)
    thread.start()
    try:
        welcome = greeted(RuntimeFolder(Path(tmp_path)))
    finally:
        process.terminate()
        thread.join()
        process.close()

    assert body.options == {"port": "7", "mode": "soft"}
    assert welcome["perception"] == "none"
    assert welcome["labels"] == []
    assert body.commands > 50
    assert body.waited_s == pytest.approx(0.002 * body.commands, abs=0.004)


def test_a_body_that_nobody_knows_is_named_and_nothing_is_served(options):
    with pytest.raises(BodyError, match="no body 'min'; the nearest is 'mine'"):
        ControlProcess(options("min"))
