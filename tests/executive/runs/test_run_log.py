"""Runs are recorded, found again, and faults of the disk told in one line."""

import json
import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from executive.errors import NotWritableError, UnknownRunError
from executive.runs.run_log import RunLog, recorded_events, recorded_run, recorded_runs, require_writable
from trees.events import NodeChanged

EVENT = NodeChanged(0.1, "pick", "running", "")


def record(folder, text="go home"):
    with RunLog(folder, {"input": text}) as log:
        log.add(EVENT)
        log.finish({"outcome": "done", "tasks": []})
    return log


def test_a_recorded_run_is_found_again(tmp_path):
    log = record(tmp_path)

    run = recorded_run(tmp_path, log.name)

    assert run.header["input"] == "go home"
    assert run.report["outcome"] == "done"
    assert json.loads((log.path / "events.jsonl").read_text())["event"] == "NodeChanged"


def test_runs_of_one_second_do_not_overwrite_each_other(tmp_path):
    names = [record(tmp_path, str(number)).name for number in range(3)]

    assert len(set(names)) == 3
    assert [run.header["input"] for run in recorded_runs(tmp_path)] == ["0", "1", "2"]
    assert recorded_run(tmp_path, "latest").header["input"] == "2"


def test_a_run_that_was_cut_off_has_no_report(tmp_path):
    with RunLog(tmp_path, {"input": "go home"}):
        pass

    assert recorded_runs(tmp_path)[0].report == {}


def test_an_unknown_run_is_told_with_the_nearest(tmp_path):
    name = record(tmp_path).name

    with pytest.raises(UnknownRunError, match=name):
        recorded_run(tmp_path, name[:-1])


def test_a_folder_that_cannot_be_made_is_told_in_one_line(tmp_path):
    (tmp_path / "file").write_text("")

    with pytest.raises(NotWritableError) as refused:
        RunLog(tmp_path / "file" / "runs", {})

    assert "\n" not in str(refused.value)
    assert "--record" in str(refused.value)


def test_a_disk_that_fills_up_is_a_complaint_and_no_exception(tmp_path):
    full = Path("/dev/full")
    if not full.exists():
        pytest.skip("this system has no /dev/full")

    with RunLog(tmp_path, {}) as log:
        log._file.close()
        log._file = full.open("w", encoding="utf-8", buffering=1)
        log.add(EVENT)
        log.add(EVENT)
        log.finish({})

        assert "log broke off" in log.complaint


def test_asking_whether_a_file_can_be_written_leaves_no_trace(tmp_path):
    require_writable(tmp_path / "report.json")
    assert not (tmp_path / "report.json").exists()

    with pytest.raises(NotWritableError):
        require_writable(tmp_path / "none" / "report.json")


WRITER = """
import pathlib, sys
from executive.runs.run_log import RunLog
from trees.events import NodeChanged

with RunLog(pathlib.Path(sys.argv[1]), {"input": "killed"}) as log:
    number = 0
    while True:
        number += 1
        log.add(NodeChanged(0.02 * number, "pick", "running", "x" * (number % 200)))
        print(number, flush=True)
"""


@pytest.mark.requirement("S9", "F8")
@pytest.mark.parametrize("at", [1, 500, 1777])
def test_a_log_whose_writer_was_killed_opens_and_holds_every_event_that_was_told(tmp_path, at):
    with subprocess.Popen(
        [sys.executable, "-c", WRITER, str(tmp_path)], stdout=subprocess.PIPE, text=True
    ) as writer:
        for line in writer.stdout:
            told = int(line)
            if told >= at:
                os.kill(writer.pid, signal.SIGKILL)
                break

    run = recorded_run(tmp_path, "latest")
    events = recorded_events(tmp_path / run.name)

    assert run.report == {}
    assert len(events) >= told
    assert [event["t_s"] for event in events[:told]] == [0.02 * (k + 1) for k in range(told)]


def test_a_torn_last_line_is_left_out_and_a_damaged_one_is_told(tmp_path):
    log = record(tmp_path)
    events = log.path / "events.jsonl"
    whole = events.read_text()
    events.write_text(whole + whole[:-5])
    assert len(recorded_events(log.path)) == 1

    events.write_text(whole[:-5] + "\n" + whole)
    with pytest.raises(ValueError, match="line 1"):
        recorded_events(log.path)
