"""What is recorded, read back by the readers of MCAP and of ROS's bags."""

import io
import json
import os
import signal
import subprocess
import sys
import time

import numpy as np
import pytest
from mcap.reader import make_reader
from mcap.writer import Writer
from mcap_ros2.decoder import DecoderFactory
from PIL import Image
from rosbags.highlevel import AnyReader

from executive.doors.recorder.mend import UnreadableRecordingError, mend, records
from executive.doors.recorder.parts import MotionParts
from executive.doors.recorder.recorder import Recorder
from executive.doors.recorder.told_apart import EVENT, json_frame, state_frame
from executive.doors.view.motion_read import recording_in, recording_of
from executive.runs.run_log import RecordedRun
from kinematics.model.robot_model import RobotModel
from robots.models.description import load_description
from robots.perception.rgbd.picture_slot import ShownPicture
from tests.executive.doors.recorder.states import CUP, row_at

ABOUT = {"robot": "talos", "scene": "tabletop", "input": "wave"}


@pytest.fixture(scope="module")
def model():
    return RobotModel(load_description("talos"))


def told(model, path, end=True):
    recorder = Recorder(path, model, ABOUT, 1_700_000_000_000_000_000)
    for i in range(100):
        t_s = 0.01 * i
        if i == 20:
            recorder.event({"event": "TaskAccepted", "t_s": t_s, "text": "wave"}, "accepted: wave")
            recorder.world(t_s, {"version": 1, "things": [CUP]})
        if i == 50:
            recorder.tree(t_s, [{"depth": 0, "name": "wave", "status": "running", "message": "1 of 3"}])
            recorder.status(t_s, {"defects": ["arm_left_1 is hot"]})
        recorder.state(row_at(model, t_s))
    if end:
        recorder.close()
    return recorder


@pytest.fixture(scope="module")
def recorded(model, tmp_path_factory):
    path = tmp_path_factory.mktemp("recorded") / "motion.mcap"
    told(model, path)
    return path


def by_mcap(path):
    with path.open("rb") as file:
        found = {}
        for _, channel, message, value in make_reader(
            file, decoder_factories=[DecoderFactory()]
        ).iter_decoded_messages():
            found.setdefault(channel.topic, []).append((message.log_time, value))
        return found


def by_rosbags(path):
    found = {}
    with AnyReader([path]) as reader:
        for connection, at_ns, data in reader.messages():
            found.setdefault(connection.topic, []).append(
                (at_ns, reader.deserialize(data, connection.msgtype))
            )
    return found


@pytest.mark.parametrize("read", [by_mcap, by_rosbags])
def test_joints_are_read_back_at_their_times(recorded, read, model):
    joints = read(recorded)["/joint_states"]

    assert [round((at_ns - 1_700_000_000_000_000_000) * 1e-9, 6) for at_ns, _ in joints] == [
        round(0.01 * i, 6) for i in range(100)
    ]
    assert list(joints[70][1].name) == list(model.description.actuated)
    assert joints[70][1].position[0] == pytest.approx(0.7)
    assert joints[70][1].header.stamp.nanosec == 700_000_000


@pytest.mark.parametrize("read", [by_mcap, by_rosbags])
def test_frames_beliefs_and_diagnostics_are_read_back(recorded, read):
    topics = read(recorded)

    assert topics["/tf"][-1][1].transforms[0].header.frame_id == "odom"
    ((_, seen),) = topics["/detections"]
    assert seen.detections[0].bbox.size.z == pytest.approx(0.1)
    assert seen.detections[0].results[0].pose.covariance[7] == pytest.approx(9e-6)
    assert topics["/diagnostics"][0][1].status[0].message == "arm_left_1 is hot"
    assert topics["/diagnostics"][0][1].status[-1].message == "measured"
    assert json.loads(topics["/executive/tree"][0][1].data)[0]["message"] == "1 of 3"
    assert topics["/rosout"][0][1].msg == "accepted: wave"


def test_a_picture_is_read_back(model, tmp_path):
    recorder = Recorder(tmp_path / "motion.mcap", model, ABOUT)
    color = np.zeros((48, 64, 3), np.uint8)
    color[:, :, 0] = 200
    recorder.picture(ShownPicture("eye", 60.0, 0.3, color, np.ones((48, 64), np.uint16)))
    recorder.close()
    topics = by_rosbags(tmp_path / "motion.mcap")

    assert bytes(topics["/camera/color/image_raw/compressed"][0][1].data[:2]) == b"\xff\xd8"
    assert topics["/camera/color/camera_info"][0][1].k[0] == 60.0


def test_pictures_of_the_camera_are_shown_again_at_their_times(model, tmp_path):
    recorder = Recorder(tmp_path / "motion.mcap", model, ABOUT, 1_700_000_000_000_000_000)
    for t_s, red in ((0.5, 40), (2.0, 200)):
        recorder.state(row_at(model, t_s))
        color = np.zeros((48, 64, 3), np.uint8)
        color[:, :, 0] = red
        recorder.picture(ShownPicture("eye", 60.0, t_s, color, np.ones((48, 64), np.uint16)))
    recorder.close()
    recording = recording_in(tmp_path / "motion.mcap")

    def red_at(t_s):
        return int(np.asarray(Image.open(io.BytesIO(recording.picture(t_s))))[:, :, 0].mean())

    assert recording.picture(0.4) is None
    assert red_at(1.0) == pytest.approx(40, abs=4)
    assert red_at(2.1) == pytest.approx(200, abs=4)


def test_a_recording_is_shown_again_as_it_was(recorded):
    recording = recording_in(recorded)

    assert (recording.robot, recording.scene, recording.asked) == ("talos", "tabletop", "wave")
    assert recording.ends_s == pytest.approx(0.98)
    assert recording.moment(0.1).world["things"] == []
    assert recording.moment(0.9).world["things"][0]["name"] == "red cup 1"
    assert recording.moment(0.9).nodes[0]["name"] == "wave"
    assert recording.moment(0.5).report.sensed.readings.q[0] == pytest.approx(0.5, abs=0.04)
    assert [line.text for line in recording.log] == ["accepted: wave"]


def test_how_the_tree_ended_is_shown_at_the_end(model, tmp_path):
    recorder = Recorder(tmp_path / "motion.mcap", model, ABOUT)
    recorder.tree(0.0, [{"depth": 0, "name": "wave", "status": "running", "message": ""}])
    recorder.state(row_at(model, 0.0))
    recorder.tree(0.01, [{"depth": 0, "name": "wave", "status": "failure", "message": ""}])
    recorder.close()
    recording = recording_in(tmp_path / "motion.mcap")

    assert recording.moment(recording.ends_s).nodes[0]["status"] == "failure"


def test_one_that_was_cut_off_is_read_as_far_as_it_goes_and_mended_for_others(recorded, tmp_path):
    whole = recorded.read_bytes()
    rng = np.random.default_rng(3)
    for number, size in enumerate(rng.integers(8000, len(whole) - 3000, 12)):
        folder = tmp_path / str(number)
        folder.mkdir()
        part = folder / "motion.mcap"
        part.write_bytes(whole[:size])
        before = sum(1 for one in records(part) if type(one).__name__ == "Message")

        assert mend(part)
        assert not mend(part)
        assert sum(map(len, by_mcap(part).values())) == before
        assert sum(map(len, by_rosbags(part).values())) == before


def test_two_may_mend_one_recording_at_the_same_time(recorded, tmp_path, monkeypatch):
    part = tmp_path / "motion.mcap"
    part.write_bytes(recorded.read_bytes()[:30_000])
    finish, others = Writer.finish, []

    def finish_late(writer):
        if not others:
            others.append(None)
            assert mend(part)  # another one comes and is through first
        finish(writer)

    monkeypatch.setattr(Writer, "finish", finish_late)

    assert mend(part)
    assert not mend(part)
    assert [file.name for file in tmp_path.iterdir()] == ["motion.mcap"]


def test_what_is_no_recording_is_said_to_be_none(tmp_path):
    (tmp_path / "a.mcap").write_bytes(b"hello, this is no such file at all")

    with pytest.raises(UnreadableRecordingError, match="no MCAP file"):
        mend(tmp_path / "a.mcap")


def test_parts_of_a_run_are_read_one_after_the_other(model, recorded, tmp_path):
    first, second = MotionParts(tmp_path).next(), None
    first.write_bytes(recorded.read_bytes()[:30_000])
    second = MotionParts(tmp_path).next()
    recorder = Recorder(second, model, ABOUT)
    recorder.state(row_at(model, 5.0))
    recorder.close()

    assert MotionParts(tmp_path).all() == [first, second]
    assert recording_of(RecordedRun(tmp_path, ABOUT, {})).ends_s == 5.0


class Fed:
    """The process that records a run in lockstep, fed at the pace of time."""

    def __init__(self, path):
        command = [sys.executable, "-m", "executive.doors.recorder.fed_process"]
        command += [str(path), "talos", json.dumps(ABOUT), "0"]
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE)


def test_killing_what_records_loses_less_than_two_tenths_of_a_second(model, tmp_path):
    path = tmp_path / "motion.mcap"
    fed, told_s = Fed(path), 0.0
    for i in range(400):
        told_s = 0.01 * i
        fed.process.stdin.write(state_frame(row_at(model, told_s)))
        fed.process.stdin.flush()
        while not path.exists() and fed.process.poll() is None:
            time.sleep(0.05)
        time.sleep(0.005)
    os.kill(fed.process.pid, signal.SIGKILL)
    fed.process.wait()
    fed.process.stdin.close()

    assert told_s - recording_in(path).ends_s <= 0.2


@pytest.mark.parametrize("robot", ["talos", "panda"])
@pytest.mark.parametrize("every_s", [0.01, 0.1])
def test_however_small_the_robot_no_state_waits_for_long_to_be_written(tmp_path, robot, every_s):
    model = RobotModel(load_description(robot))
    path, waited_s = tmp_path / "motion.mcap", []
    recorder = Recorder(path, model, {**ABOUT, "robot": robot}, 1_700_000_000_000_000_000)
    for i in range(60):
        recorder.state(row_at(model, every_s * i))
        if i % 7 == 6:
            waited_s.append(every_s * i - recording_in(path).ends_s)
    recorder.close()

    assert max(waited_s) <= 0.1 + 1e-6


def test_killing_who_is_recorded_loses_nothing(model, tmp_path):
    path = tmp_path / "motion.mcap"
    fed = Fed(path)
    for i in range(30):
        fed.process.stdin.write(state_frame(row_at(model, 0.01 * i)))
    fed.process.stdin.write(json_frame(EVENT, {"told": {"event": "Said", "t_s": 0.29}, "line": "says: hi"}))
    fed.process.stdin.write(state_frame(row_at(model, 0.3))[:100])
    fed.process.stdin.close()
    fed.process.wait(60.0)

    assert by_mcap(path)["/rosout"][0][1].msg == "says: hi"
    assert len(by_mcap(path)["/joint_states"]) == 30
