"""One account of a run: every event is logged, counted and shown, and the report tells all of it."""

import base64
import json

from executive.exit_codes import ExitCode
from executive.runs.run_account import RunAccount, RunSubject
from executive.runs.run_log import RunLog, recorded_events
from executive.session.events import EventDigest
from executive.session.task_result import TaskResult
from executive.understanding.statement import Statement
from executive.understanding.understanding import understand
from robots.control.events import SetpointRefused, StopStarted
from trees.events import ThingPictured

SUBJECT = RunSubject("go home", "talos", "tabletop", 3)
REFUSED = SetpointRefused(0.0, "pick", "velocity", "arm_left_2_joint", 3.0, 2.0)
STOPPED = StopStarted(0.5, 1, "by the test")


def test_the_header_repeats_a_long_input_whole_and_shortened():
    header = RunSubject("go home " * 100, "talos", "tabletop", 3).header()

    assert header["text"] == "go home " * 100
    assert len(header["input"]) == 201
    assert (header["robot"], header["scene"], header["seed"]) == ("talos", "tabletop", 3)


def test_every_event_is_logged_and_then_shown(tmp_path):
    shown = []
    with RunLog(tmp_path, SUBJECT.header()) as log:
        account = RunAccount(SUBJECT, log, shown.append)
        account.hear(REFUSED)

    assert shown == [REFUSED]
    assert [event["event"] for event in recorded_events(log.path)] == ["SetpointRefused"]


def test_the_picture_of_what_a_person_is_asked_about_is_kept_and_named_in_the_report(tmp_path):
    said = Statement.of(understand("go home"))
    pictured = ThingPictured(0.5, "red cup", base64.b64encode(b"a file").decode())
    with RunLog(tmp_path, SUBJECT.header()) as log:
        account = RunAccount(SUBJECT, log)
        account.hear(pictured)
        report = account.close(("is this the red cup?", "question", ExitCode.QUESTION), [(said, [])], 0)

    kept = json.loads((log.path / "report.json").read_text())
    assert kept["pictures"] == report.to_json()["pictures"] == ["pictures/001_red_cup.png"]
    assert (log.path / "pictures" / "001_red_cup.png").read_bytes() == b"a file"


def test_the_report_counts_tells_the_ending_and_is_kept_with_the_log(tmp_path):
    said = Statement.of(understand("go home"))
    with RunLog(tmp_path, SUBJECT.header()) as log:
        account = RunAccount(SUBJECT, log)
        account.hear(REFUSED)
        account.hear(STOPPED)
        ending = ("done: at home", "done", ExitCode.DONE)
        report = account.close(ending, [(said, [TaskResult("go home", "go_home", "done")])], checked=4)

    digest = EventDigest()
    for event in (REFUSED, STOPPED):
        digest.add(event)
    kept = json.loads((log.path / "report.json").read_text())
    assert kept == report.to_json()
    assert kept["safety"] == {"checked_trajectories": 4, "refused_setpoints": 1, "stops": ["by the test"]}
    assert (kept["message"], kept["exit_code"], kept["seed"]) == ("done: at home", 0, 3)
    assert [task["text"] for task in kept["tasks"]] == ["go home"]
    assert kept["events_sha256"] == digest.hexdigest()
