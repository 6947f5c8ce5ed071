"""``serve`` watches both processes, replaces executives at a rate, and heeds signals."""

import os
import signal
import subprocess
from types import SimpleNamespace

import pytest

from executive.live.caller import service as service_module
from executive.live.caller.service import MOST, WITHIN_S, Restarts, Service, ServiceRequest
from robots.live.wire.errors import NotServedError
from robots.live.wire.messages import read_object


class Process:
    """A process that runs until it is told otherwise."""

    def __init__(self, command):
        self.command, self.returncode, self.pid = command, None, id(self)

    def poll(self):
        return self.returncode

    def terminate(self):
        self.returncode = -15

    def kill(self):
        self.returncode = -9

    def wait(self, timeout=None):
        return self.returncode


class World:
    """Processes, sockets and a clock, and what happens as it goes on."""

    def __init__(self):
        self.now_s, self.heard, self.said, self.processes = 0.0, [], [], []
        self.meanwhile, self.serves = (lambda: None), True

    def popen(self, command, **_options):
        self.processes.append(Process(command))
        return self.processes[-1]

    @property
    def control(self):
        return self.processes[0]

    @property
    def executives(self):
        return [
            one
            for one in self.processes
            if "executive.live.served_executive.executive_process" in one.command
        ]

    def sleep(self, seconds):
        self.now_s += seconds
        self.meanwhile()

    def ask(self, message):
        self.heard.append(read_object(message)["type"])
        if self.heard[-1] == "shutdown":
            self.control.returncode = 0

    def caller(self, path):
        if not self.processes or not self.serves:
            raise NotServedError(path.parent)
        return SimpleNamespace(ask=self.ask, close=lambda: None)


@pytest.fixture
def world(monkeypatch, signals_heard):
    made = World()
    monkeypatch.setattr(subprocess, "Popen", made.popen)
    monkeypatch.setattr(service_module, "Caller", made.caller)
    clock = SimpleNamespace(now_s=lambda: made.now_s, sleep=made.sleep)
    monkeypatch.setattr(service_module, "WallClock", lambda: clock)
    monkeypatch.setattr(service_module, "commander_of", lambda _folder: made.executives[-1].pid)
    return made


@pytest.fixture
def begin(world, tmp_path):
    request = ServiceRequest(tmp_path / "live", "talos", "tabletop", 0, tmp_path / "runs")
    return lambda: Service(request, world.said.append)


def ends_every(world, period_s, until_s):
    """Have each executive end after a while, and the robot's control at last."""
    ended_s = [0.0]

    def meanwhile():
        if world.now_s >= until_s:
            world.control.returncode = 0
        elif world.now_s - ended_s[0] >= period_s and world.executives[-1].returncode is None:
            ended_s[0] = world.now_s
            world.executives[-1].returncode = 1

    return meanwhile


@pytest.mark.requirement("S3")
def test_executives_that_end_at_once_are_given_up_and_that_is_said_once(world, begin):
    world.meanwhile = ends_every(world, 1.0, WITHIN_S / 2)

    begin().watch()

    assert len(world.executives) == 1 + MOST
    assert [line for line in world.said if "no other one is started" in line] == world.said[MOST:]
    assert len(world.said) == MOST + 1


@pytest.mark.requirement("S3")
def test_executives_that_end_now_and_then_are_replaced_for_as_long_as_the_robot_is_served(world, begin):
    world.meanwhile = ends_every(world, WITHIN_S / 4, 10 * WITHIN_S)

    begin().watch()

    assert len(world.executives) > 3 * MOST
    assert not any("no other one" in line for line in world.said)


@pytest.mark.requirement("S7")
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP], ids=lambda one: one.name)
def test_a_signal_to_end_has_the_robot_brake_and_hold_then_ends_its_control(world, begin, number):
    service, sent = begin(), iter([number])
    world.meanwhile = lambda: [os.kill(os.getpid(), one) for one in sent]

    assert service.watch() == 0
    assert world.heard[-1] == "shutdown"
    assert all(one.returncode is not None for one in world.processes)


@pytest.mark.requirement("S4")
def test_a_second_signal_to_end_is_the_emergency_stop(world, begin):
    service, sent, ends = begin(), iter([signal.SIGTERM, signal.SIGTERM]), World.ask

    def ask(message):
        ends(world, message)
        world.control.returncode = 0 if "stop" in world.heard else None

    world.ask = ask
    world.meanwhile = lambda: os.kill(os.getpid(), next(sent))

    service.watch()

    assert world.heard[-3:] == ["shutdown", "stop", "shutdown"]


@pytest.mark.requirement("S3")
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP], ids=lambda one: one.name)
def test_a_signal_while_the_control_process_loads_leaves_nothing_that_nobody_watches(world, begin, number):
    signal.signal(number, signal.default_int_handler)
    world.serves = False
    world.meanwhile = lambda: os.kill(os.getpid(), number)

    with pytest.raises(KeyboardInterrupt):
        begin()

    assert [one.returncode for one in world.processes] == [-15]


@pytest.mark.requirement("S3")
def test_a_watch_that_breaks_off_leaves_nothing_that_nobody_watches(world, begin):
    def breaks():
        raise RuntimeError("a defect of the watch")

    service = begin()
    world.meanwhile = breaks
    with pytest.raises(RuntimeError, match="of the watch"), service:
        service.watch()

    assert all(one.returncode is not None for one in world.processes)


def test_the_control_process_is_told_who_supervises_it(world, begin):
    begin()

    assert world.control.command[world.control.command.index("--supervisor") + 1] == str(os.getpid())


@pytest.mark.parametrize(("perception", "told"), [("rgbd", ["--perception", "rgbd"]), (None, [])])
def test_the_control_process_is_told_how_the_robot_sees_when_that_was_asked(
    world, tmp_path, perception, told
):
    place = (tmp_path / "live", "talos", "tabletop", 0, tmp_path / "runs")
    Service(ServiceRequest(*place, perception=perception), world.said.append)

    command = world.control.command
    assert [one for one in command if one in ("--perception", "rgbd")] == told


def test_the_control_process_is_told_of_the_body_that_it_is_to_attach(world, tmp_path):
    place = (tmp_path / "live", "g1", "tabletop", 0, tmp_path / "runs")
    options = (("interface", "eth0"), ("domain", "3"))
    Service(ServiceRequest(*place, body="unitree", body_options=options), world.said.append)

    told = " ".join(world.control.command)
    assert "--body unitree --body-option interface eth0 --body-option domain 3" in told


def test_so_many_within_the_window_are_too_many():
    restarts = Restarts(most=3, within_s=100.0)

    assert [restarts.take(now_s) for now_s in (1.0, 2.0, 3.0, 4.0)] == [True, True, True, False]


def test_what_was_before_the_window_counts_no_more():
    restarts = Restarts(most=3, within_s=100.0)

    assert all(restarts.take(60.0 * times) for times in range(50))


def test_one_that_commands_for_long_enough_is_well_and_begins_the_count_anew():
    restarts = Restarts(most=1, within_s=1000.0, well_after_s=60.0)
    restarts.take(0.0)
    restarts.note_health(True, 10.0)
    restarts.note_health(True, 70.0)

    assert restarts.take(71.0)


def test_one_that_commands_now_and_then_is_not_well():
    restarts = Restarts(most=1, within_s=1000.0, well_after_s=60.0)
    restarts.take(0.0)
    for now_s, commands in ((10.0, True), (40.0, False), (50.0, True), (100.0, True)):
        restarts.note_health(commands, now_s)

    assert not restarts.take(101.0)
