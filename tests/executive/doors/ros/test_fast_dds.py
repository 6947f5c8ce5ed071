"""What endpoints of Fast DDS tell of their processes."""

import os
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

import pytest

from executive.doors.ros.node.fast_dds import Processes, ask_often

OWN = b"\x01\x0f\x78\xfd" + bytes(12)


def endpoint(number, machine=b"\x78\xfd", vendor=b"\x01\x0f"):
    return vendor + machine + (number & 0xFFFF).to_bytes(2, "little") + bytes(10)


@pytest.fixture
def program():
    with subprocess.Popen([sys.executable, "-c", "input()"], stdin=subprocess.PIPE) as process:
        yield process
        process.kill()


def test_a_process_that_lives_has_not_ended(program):
    processes, one = Processes(), endpoint(program.pid)
    processes.see([one], OWN)

    assert not processes.has_ended(one)


def test_a_killed_process_has_ended_also_before_its_parent_asks(program):
    processes, one = Processes(), endpoint(program.pid)
    processes.see([one], OWN)

    program.kill()
    os.waitid(os.P_PID, program.pid, os.WEXITED | os.WNOWAIT)
    processes.see([one], OWN)

    assert processes.has_ended(one)


@pytest.mark.parametrize("which", [{"machine": b"\x01\x02"}, {"vendor": b"\x01\x10"}])
def test_of_another_machine_or_middleware_nothing_is_known(program, which):
    processes, one = Processes(), endpoint(program.pid, **which)
    processes.see([one], OWN)
    program.kill()
    program.wait()

    assert not processes.has_ended(one)


def test_a_process_that_was_never_there_has_not_ended(tmp_path):
    processes, one = Processes(tmp_path), endpoint(77)
    processes.see([one], OWN)

    assert not processes.has_ended(one)


def test_of_processes_whose_numbers_end_alike_all_have_to_have_ended(tmp_path):
    processes, one = Processes(tmp_path), endpoint(77)
    for number in (77, 77 + 0x10000):
        (tmp_path / str(number)).mkdir()
        (tmp_path / str(number) / "stat").write_text(f"{number} (a) b) S 1")
    processes.see([one], OWN)

    (tmp_path / "77" / "stat").write_text("77 (a) b) Z 1")
    assert not processes.has_ended(one)
    (tmp_path / str(77 + 0x10000) / "stat").unlink()
    assert processes.has_ended(one)


def test_a_users_own_profile_stays(monkeypatch):
    monkeypatch.setenv("FASTRTPS_DEFAULT_PROFILES_FILE", "/mine.xml")
    monkeypatch.delenv("FASTDDS_DEFAULT_PROFILES_FILE", raising=False)

    assert not ask_often(3)
    assert "FASTDDS_DEFAULT_PROFILES_FILE" not in os.environ


@pytest.mark.parametrize(
    ("version", "variable", "period"),
    [
        (2, "FASTRTPS_DEFAULT_PROFILES_FILE", "heartbeatPeriod"),
        (3, "FASTDDS_DEFAULT_PROFILES_FILE", "heartbeat_period"),
    ],
)
def test_each_fast_dds_gets_a_profile_in_its_own_words(monkeypatch, version, variable, period):
    for name in ("FASTRTPS_DEFAULT_PROFILES_FILE", "FASTDDS_DEFAULT_PROFILES_FILE"):
        monkeypatch.setenv(name, "")

    assert ask_often(version)

    root = ElementTree.parse(os.environ[variable]).getroot()
    assert [one.tag.rpartition("}")[2] for one in root.iter()][-3:] == [period, "sec", "nanosec"]
