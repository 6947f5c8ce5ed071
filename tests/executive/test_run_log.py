"""Runs are recorded, found again, and faults of the disk told in one line."""

import json
from pathlib import Path

import pytest

from executive.errors import NotWritableError, UnknownRunError
from executive.run_log import RunLog, recorded_run, recorded_runs, require_writable
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
