"""Runs that were recorded without their motion get it."""

import io

import pytest
from PIL import Image
from rosbags.highlevel import AnyReader

from executive.doors.recorder.export import NotExportedError, export
from executive.doors.recorder.feed import RunFeed, complaint_without_extra
from executive.doors.recorder.parts import MotionParts
from executive.doors.view.motion_read import recording_of
from executive.doors.view.recording import recorded_again
from executive.runs.run import perform
from executive.runs.run_log import RecordedRun, recorded_runs
from executive.runs.run_request import RunRequest
from executive.screens.display import NoDisplay
from executive.scripts.task_script import script_for
from executive.trust import Trust

pytestmark = pytest.mark.timeout(300)


def performed(folder, display=None, **options):
    text, trust = "move backward for 1 second", Trust()
    said = script_for(text, trust, "tabletop")
    request = RunRequest(
        input=text,
        statements=said.statements,
        robot="talos",
        scene="tabletop",
        seed=2,
        record=folder,
        trust=trust,
    )
    perform(request, display or NoDisplay(), **options)
    (run,) = recorded_runs(folder)
    return run


@pytest.fixture(scope="module")
def plain(tmp_path_factory):
    return performed(tmp_path_factory.mktemp("plain"))


@pytest.fixture(scope="module")
def fed(tmp_path_factory):
    complaints = []
    feed = RunFeed(NoDisplay(), complaints.append)
    run = performed(tmp_path_factory.mktemp("fed"), feed, on_assembly=feed.begin, on_record=feed.record)
    feed.close()
    assert complaints == []
    return run


def shown(recording):
    return [(round(one.t_s, 3), *map(float, one.report.sensed.readings.q)) for one in recording.moments]


def test_a_run_that_is_recorded_in_motion_has_the_events_of_one_that_is_not(plain, fed):
    assert fed.report["events_sha256"] == plain.report["events_sha256"]


@pytest.mark.requirement("A3")
def test_what_was_recorded_is_what_comes_when_it_is_carried_out_again(fed):
    recorded, (again, _) = recording_of(fed), recorded_again(fed, lambda _line: None)
    there = {one.t_s: one for one in recorded.moments}
    common = [one for one in again.moments if one.t_s in there]

    assert len(common) > 5
    for one in common:
        assert (one.report.sensed.readings.q == there[one.t_s].report.sensed.readings.q).all()
        assert (one.report.sensed.q == there[one.t_s].report.sensed.q).all()
    assert [one for one in recorded.log if one.t_s > 0] == [one for one in again.log if one.t_s > 0]
    assert recorded.ends_s == pytest.approx(again.ends_s, abs=0.05)


def test_an_older_run_is_exported_as_it_would_have_been_recorded(plain, fed):
    (made,) = export(plain, lambda _line: None)

    assert made.name == "motion.mcap"
    assert shown(recording_of(plain)) == shown(recording_of(fed))
    assert export(plain, lambda _line: None) == [made]


def test_a_live_run_without_motion_is_refused(tmp_path):
    with pytest.raises(NotExportedError, match=r"serve --record DIR"):
        export(RecordedRun(tmp_path, {"live": True, "robot": "talos"}, {}), lambda _line: None)


def test_a_missing_extra_is_one_clear_line(monkeypatch):
    monkeypatch.setattr("executive.doors.companion.find_spec", lambda name: None)

    assert complaint_without_extra() == (
        "the run's motion is not recorded: the package 'mcap' is not installed: "
        'pip install "humanoid-executive[record]"'
    )


@pytest.mark.opengl
def test_a_run_that_sees_with_the_camera_keeps_its_pictures(tmp_path):
    text, trust = "look at the table", Trust()
    said = script_for(text, trust, "tabletop")
    feed = RunFeed(NoDisplay(), print)
    request = RunRequest(
        text, said.statements, "talos", "tabletop", 2, tmp_path, perception="rgbd", trust=trust
    )
    perform(request, feed, on_assembly=feed.begin, on_record=feed.record)
    feed.close()
    (run,) = recorded_runs(tmp_path)
    with AnyReader(MotionParts(run.path).all()) as reader:
        taken = [
            reader.deserialize(data, connection.msgtype)
            for connection, _, data in reader.messages()
            if connection.topic == "/camera/color/image_raw/compressed"
        ]

    assert taken
    assert Image.open(io.BytesIO(bytes(taken[0].data))).size == (640, 480)
    assert not [one.name for one in run.path.iterdir() if one.name.startswith(".")]
