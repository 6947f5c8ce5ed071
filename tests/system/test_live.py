"""A served robot: stopped in the middle of a task, reset, sent on, and left alone by its executive.

The pace is low, so that a busy machine keeps up; no time is judged here but control time in the events.
"""

import signal
import subprocess
import sys
import time

import pytest

from executive.live.caller.caller import Caller, ask_at
from executive.live.caller.service import Service, ServiceRequest
from executive.live.desk_messages import Say, write_desk_message
from robots.live.wire.messages import (
    GetStatus,
    Hello,
    Reset,
    Shutdown,
    Stop,
    write_control_message,
    write_message,
)

PATIENCE_S = 200.0


class Served:
    """A served robot, seen from outside."""

    def __init__(self, folder):
        request = ServiceRequest(
            folder / "live", "talos", "tabletop", 0, folder / "runs", 0.15, realtime=False, evaluation=True
        )
        self.service = Service(request, lambda _line: None)
        self.folder = self.service.folder
        self.observer = Caller(self.folder.control_socket)
        self.observer.ask(write_control_message(Hello("observer")))
        self.events = []

    def wait(self, condition, what):
        for _ in range(round(PATIENCE_S / 0.01)):
            if condition():
                return
            time.sleep(0.01)
        raise AssertionError(f"in vain: {what}; {self.events[-3:]}")

    def ask(self, message, path=None):
        caller = Caller(path or self.folder.control_socket)
        try:
            return caller.ask(message, within_s=60.0)
        finally:
            caller.close()

    def status(self):
        return self.ask(write_control_message(GetStatus()))

    def await_executive(self):
        def attached():
            return self.folder.executive_socket.exists() and self.status()["commander"]

        self.wait(attached, "the executive attaches")

    def say(self, sentence):
        caller = Caller(self.folder.executive_socket)
        caller.send(write_desk_message(Say(sentence)))
        return caller

    def result(self, caller):
        heard = []

        def take(answer):
            heard.append(answer)
            return answer["type"] == "result"

        caller.listen(take, PATIENCE_S)
        caller.close()
        return heard[-1]

    def of(self, kind, since=0):
        self.events += self.observer.arrived("event")
        return [event for event in self.events[since:] if event["event"] == kind]

    def until_it_moves(self):
        count = len(self.of("MotionStarted"))
        self.wait(lambda: len(self.of("MotionStarted")) > count, "a motion begins")
        began_s = self.of("MotionStarted")[-1]["t_s"]
        self.wait(lambda: self.status()["t_s"] > began_s + 0.15, "it is under way")

    def close(self):
        try:
            self.ask(write_control_message(Shutdown()))
            self.service.control.wait(30.0)
        finally:
            self.service.control.kill()
            self.service.control.wait()
            self.service.close()
            self.observer.close()


@pytest.fixture
def served(tmp_path_factory):
    robot = Served(tmp_path_factory.mktemp("served"))
    yield robot
    robot.close()


@pytest.mark.slow
@pytest.mark.requirement("S3", "S4", "S9", "U1")
def test_it_stops_in_the_middle_is_reset_goes_on_and_stands_when_its_executive_is_killed(served):
    served.await_executive()
    served.wait(lambda: not served.status()["reservations"], "the machine keeps up")
    pick = served.say("pick up the red cup")
    served.until_it_moves()

    assert served.ask(write_control_message(Stop(1, "test")))["type"] == "done"
    cancelled = served.result(pick)
    assert cancelled["exit_code"] == 4, cancelled
    assert served.of("EmergencyStopped")
    assert served.result(served.say("go home"))["exit_code"] == 5

    reset = write_control_message(Reset("test"))
    served.wait(lambda: served.ask(reset)["type"] == "done", "it has come to rest and is reset")
    served.wait(lambda: not served.status()["reservations"], "the machine keeps up")
    seen = len(served.events)
    home = served.say("go home")
    served.until_it_moves()
    assert served.of("MotionStarted", seen)
    killed_s = served.status()["t_s"]
    seen = len(served.events)
    served.service.executive.send_signal(signal.SIGKILL)
    served.wait(lambda: served.of("StopStarted", seen), "the robot is stopped")
    home.close()

    (stop,) = served.of("StopStarted", seen)
    assert "connection" in stop["reason"]
    assert stop["t_s"] >= killed_s - 0.011
    served.wait(lambda: served.status()["resting"], "it rests")
    status = served.status()
    assert status["commander"] is None
    assert status["setpoints"]["refused"] == 0
    assert not served.ask(write_message("truth"), served.folder.evaluation_socket)["fallen"]


@pytest.mark.slow
@pytest.mark.requirement("S3")
def test_status_tells_that_nobody_supervises_once_serve_is_killed(tmp_path_factory):
    folder = tmp_path_factory.mktemp("alone")
    command = [sys.executable, "-m", "executive", "serve", "--folder", folder / "live", "--ordinary"]
    serve = subprocess.Popen([*map(str, command), "--record", str(folder / "runs")], stderr=subprocess.PIPE)
    try:
        assert any(b"stands in" in line for line in serve.stderr)
        supervisor = _status(folder)["supervisor"]
    finally:
        serve.kill()
        serve.wait()
    try:
        assert (supervisor, _status(folder)["supervisor"]) == (serve.pid, None)
        assert any(b"its supervisor" in line and b"has gone" in line for line in serve.stderr)
    finally:
        ask_at(folder / "live" / "control.sock", write_control_message(Shutdown()), PATIENCE_S)
        serve.stderr.close()


def _status(folder):
    return ask_at(folder / "live" / "control.sock", write_control_message(GetStatus()), PATIENCE_S)
