"""Runs of a served robot are recorded in their folders, whoever is killed."""

import signal
import subprocess
import sys
import threading
import time

import pytest

from executive.doors.recorder.served_recorder import ServedRecorder
from executive.doors.view.motion_read import recording_of
from executive.runs.run_log import RecordedRun
from kinematics.model.robot_model import RobotModel
from robots.live.wire.state_slot import StateSlotWriter
from robots.models.description import load_description
from tests.executive.doors.recorder.states import CUP, row_at
from trees.events import Said
from trees.snapshot import NodeSnapshot, TreeSnapshot

HEADER = {"robot": "talos", "scene": "tabletop", "input": "wave"}


@pytest.fixture(scope="module")
def model():
    return RobotModel(load_description("talos"))


class Moving:
    """Writes a state each 10 ms, as a control process does; a state's time is the time since it began."""

    def __init__(self, model, path):
        self._model, self._slot = model, StateSlotWriter(path, row_at(model, 0.0).size)
        self._ended, self._begun_s = threading.Event(), time.monotonic()
        self._thread = threading.Thread(target=self._run)
        self._thread.start()

    @property
    def t_s(self):
        return time.monotonic() - self._begun_s

    def close(self):
        self._ended.set()
        self._thread.join()

    def _run(self):
        while not self._ended.wait(0.01):
            self._slot.write(row_at(self._model, self.t_s))


@pytest.fixture
def moving(served, model):
    served.world = lambda: {"version": 1, "things": [CUP]}
    made = Moving(model, served.folder.state_slot)
    yield made
    made.close()


@pytest.fixture
def recorder(served, moving):
    over = threading.Event()
    made = ServedRecorder(served.folder.path, over.is_set)
    thread = threading.Thread(target=made.run)
    thread.start()
    until(lambda: served.watched)
    yield made
    over.set()
    thread.join()


def until(so, within_s=30.0):
    begun_s = time.monotonic()
    while not so():
        assert time.monotonic() - begun_s < within_s
        time.sleep(0.01)


def read(folder):
    return recording_of(RecordedRun(folder, HEADER, {}))


def is_whole(path):
    return path.exists() and path.read_bytes()[-8:] == b"\x89MCAP0\r\n" and path.stat().st_size > 1000


@pytest.mark.requirement("A3")
def test_a_run_is_recorded_from_its_beginning_to_its_end(served, moving, recorder, tmp_path):
    tree = TreeSnapshot(2.0, 0, NodeSnapshot("pick", "sequence", "running", "1 of 3"))
    served.show(lambda watchers: watchers.run_begins(str(tmp_path)))
    time.sleep(0.3)
    served.show(lambda watchers: watchers.event(Said(moving.t_s, "here you are")))
    served.show(lambda watchers: watchers.tree(lambda: tree, moving.t_s))
    time.sleep(0.8)
    served.show(lambda watchers: watchers.run_ended())
    until(lambda: is_whole(tmp_path / "motion.mcap"))
    recording = read(tmp_path)

    assert recording.ends_s - recording.moments[0].t_s > 1.0
    assert [line.text for line in recording.log] == ["says: here you are"]
    last = recording.moment(recording.ends_s)
    assert last.nodes[0]["message"] == "1 of 3"
    assert last.world["things"][0]["name"] == CUP["name"]


def test_a_recorder_that_comes_in_the_middle_of_a_run_records_the_rest(served, moving, tmp_path):
    served.show(lambda watchers: watchers.run_begins(str(tmp_path)))
    time.sleep(0.1)
    over = threading.Event()
    thread = threading.Thread(target=ServedRecorder(served.folder.path, over.is_set).run)
    thread.start()
    until((tmp_path / "motion.mcap").exists)
    time.sleep(0.5)
    over.set()
    thread.join()

    assert len(read(tmp_path).moments) > 5


def test_killing_the_recorder_loses_less_than_two_tenths_of_a_second_and_another_goes_on(
    served, moving, tmp_path
):
    served.show(lambda watchers: watchers.run_begins(str(tmp_path)))
    command = [sys.executable, "-m", "executive.doors.recorder.served_recorder", str(served.folder.path)]
    first = subprocess.Popen(command)
    until((tmp_path / "motion.mcap").exists, 60.0)
    time.sleep(1.5)
    first.send_signal(signal.SIGKILL)
    killed_s = moving.t_s
    first.wait()

    assert killed_s - read(tmp_path).ends_s <= 0.2
    second = subprocess.Popen(command)
    until((tmp_path / "motion_2.mcap").exists, 60.0)
    time.sleep(0.5)
    second.terminate()
    second.wait()
    assert is_whole(tmp_path / "motion.mcap")
    assert is_whole(tmp_path / "motion_2.mcap")
    assert read(tmp_path).ends_s > killed_s


def test_where_the_executive_is_killed_the_file_is_ended_and_holds_all(
    served, moving, recorder, tmp_path, monkeypatch
):
    monkeypatch.setattr("executive.doors.recorder.served_recorder._WITHOUT_EXECUTIVE_S", 0.5)
    served.show(lambda watchers: watchers.run_begins(str(tmp_path)))
    time.sleep(0.3)
    served.show(lambda watchers: watchers.event(Said(1.0, "the last words")))
    time.sleep(0.1)
    served.close()
    until(lambda: is_whole(tmp_path / "motion.mcap"))

    assert [line.text for line in read(tmp_path).log] == ["says: the last words"]
