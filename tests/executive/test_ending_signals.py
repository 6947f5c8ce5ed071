"""SIGTERM and SIGHUP mean what Ctrl-C means, for every command that holds a process."""

import json
import os
import signal
import subprocess
import sys
import threading
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import jsonschema
import pytest

from executive.ending_signals import EndedBySignal, interrupt_by_all, taken_by, told

SCHEMA = json.loads((Path(__file__).parents[2] / "docs" / "reference" / "report.schema.json").read_text())
ALL = [signal.SIGINT, signal.SIGTERM, signal.SIGHUP]
pytestmark = pytest.mark.usefixtures("signals_heard")
each = pytest.mark.parametrize("number", ALL, ids=lambda number: number.name)


@each
def test_each_is_taken_and_ends_nothing(number):
    taken = []

    with taken_by(taken.append):
        os.kill(os.getpid(), number)

    assert taken == [number]


def test_a_terminal_that_has_gone_is_told_once_by_whomever():
    taken = []

    with taken_by(taken.append):
        os.kill(os.getpid(), signal.SIGHUP)
        os.kill(os.getpid(), signal.SIGHUP)
    os.kill(os.getpid(), signal.SIGHUP)

    assert taken == [signal.SIGHUP]


def test_who_is_to_outlive_the_terminal_does():
    signal.signal(signal.SIGHUP, signal.SIG_IGN)
    interrupt_by_all()

    with taken_by(lambda _number: pytest.fail("heard")):
        os.kill(os.getpid(), signal.SIGHUP)


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGHUP], ids=lambda number: number.name)
def test_with_nothing_under_way_each_ends_the_program_as_ctrl_c_does(number):
    interrupt_by_all()

    with pytest.raises(EndedBySignal, match=f"cancelled by {number.name}"):
        os.kill(os.getpid(), number)


def test_in_another_thread_nothing_is_changed():
    before, inside = signal.getsignal(signal.SIGTERM), []

    def look():
        with taken_by(inside.append):
            inside.append(signal.getsignal(signal.SIGTERM))

    thread = threading.Thread(target=look)
    thread.start()
    thread.join()

    assert inside == [before]


class Command:
    """A command in a process of its own."""

    def __init__(self, folder, *arguments):
        environment = {**os.environ, "XDG_DATA_HOME": str(folder), "XDG_RUNTIME_DIR": str(folder)}
        self.process = subprocess.Popen(
            [sys.executable, "-m", "executive", *map(str, arguments)],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            env=environment,
            text=True,
        )

    def until(self, words):
        """Read what it tells until there are these words."""
        for line in self.process.stderr:
            if words in line:
                return
        raise AssertionError(f"it never said {words!r}")

    def ended(self, number):
        """Send a signal; its last line and its exit code."""
        self.process.send_signal(number)
        told, self.complaints = self.process.communicate(timeout=100.0)
        return told.strip(), self.process.returncode


@pytest.fixture
def command(tmp_path):
    """Begin a command, and end it with the test."""
    begun = []

    def begin(*arguments):
        begun.append(Command(tmp_path, *arguments))
        return begun[-1]

    yield begin
    for one in begun:
        one.process.kill()
        one.process.communicate()


@each
@pytest.mark.requirement("S7", "U1")
def test_a_run_that_is_asked_to_end_halts_and_writes_all_that_was_asked_for(command, tmp_path, number):
    report, junit = tmp_path / "report.json", tmp_path / "junit.xml"
    run = command("run", "wait for 400 seconds", "--pace", "real", "--report", report, "--junit", junit)
    run.until("wait")

    line, code = run.ended(number)

    assert code == 4
    assert line.startswith(f"cancelled: {told(number, 'cancelled')}")
    assert json.loads(report.read_text())["exit_code"] == 4
    assert ElementTree.parse(junit).getroot().find("testsuite").get("failures") == "1"


@pytest.mark.requirement("S7", "U1")
@pytest.mark.parametrize(
    ("text", "number"),
    [*(("pick up something", number) for number in ALL), ("pick up the cup", signal.SIGTERM)],
    ids=str,
)
def test_a_run_that_asks_is_ended_at_its_question(command, tmp_path, number, text):
    report = tmp_path / "report.json"
    run = command("run", text, "--report", report, "--scene", "dinner")
    run.until("?")

    line, code = run.ended(number)

    assert code == 4
    document = json.loads(report.read_text())
    jsonschema.validate(document, SCHEMA)
    assert document["message"] == line


@pytest.fixture(scope="module")
def recorded(tmp_path_factory):
    """The folder of a run that was ended, and takes a while to be replayed."""
    folder = tmp_path_factory.mktemp("recorded")
    said = "wait for 20 seconds, then wait for 400 seconds"
    recording = Command(folder, "run", said, "--record", folder / "runs")
    recording.until("accepted: wait for 400 s")
    recording.ended(signal.SIGTERM)
    header = next((folder / "runs").glob("*/run.json"))
    header.with_name("report.json").unlink()
    return folder / "runs"


@each
def test_a_replay_that_is_asked_to_end_is_cancelled_and_no_verdict(command, recorded, number):
    replay = command("replay", "--record", recorded)
    replay.until("replaying")

    line, code = replay.ended(number)

    assert (line, code) == ("", 4)
    assert told(number, "cancelled") in replay.complaints
