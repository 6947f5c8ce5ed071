"""Recorded runs are found wherever they were recorded."""

import json

import pytest

from executive.errors import UnknownRunError
from executive.runs.run_search import find_run, find_runs, folders, note_folder


@pytest.fixture(autouse=True)
def home(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "data"))
    monkeypatch.setenv("LOCALAPPDATA", str(tmp_path / "data"))
    monkeypatch.setenv("HOME", str(tmp_path))


def record(folder, name, started):
    (folder / name).mkdir(parents=True)
    (folder / name / "run.json").write_text(json.dumps({"started": started, "input": name}))
    return folder / name


def test_the_latest_run_is_the_latest_of_every_folder_that_was_noted(tmp_path):
    record(folders()[0], "usual", "2026-01-01T00:00:01Z")
    record(tmp_path / "elsewhere", "other", "2026-01-01T00:00:02Z")
    note_folder(tmp_path / "elsewhere")

    assert find_run("latest").name == "other"
    assert [run.name for run in find_runs()] == ["usual", "other"]
    assert find_run("usual").name == "usual"


def test_a_given_folder_is_the_only_one_that_is_looked_into(tmp_path):
    record(folders()[0], "usual", "2026-01-01T00:00:01Z")
    record(tmp_path / "elsewhere", "other", "2026-01-01T00:00:02Z")

    assert [run.name for run in find_runs(tmp_path / "elsewhere")] == ["other"]


@pytest.mark.parametrize("path", ["elsewhere/other", "elsewhere"])
def test_a_run_is_found_by_its_path(tmp_path, path):
    record(tmp_path / "elsewhere", "other", "2026-01-01T00:00:02Z")

    assert find_run(str(tmp_path / path)).name == "other"


def test_where_it_was_looked_for_is_said(tmp_path):
    (tmp_path / "elsewhere").mkdir()
    note_folder(tmp_path / "elsewhere")

    with pytest.raises(UnknownRunError) as unknown:
        find_run("yesterday")

    assert all(str(folder) in str(unknown.value) for folder in folders())
    assert str(tmp_path / "elsewhere") in str(unknown.value)


def test_a_folder_that_is_gone_is_passed_over_and_a_spoilt_list_too(tmp_path):
    note_folder(tmp_path / "gone")
    assert len(folders()) == 1

    next((tmp_path / "data").rglob("record-folders.json")).write_text("{")
    assert len(folders()) == 1
