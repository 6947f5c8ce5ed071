"""What the command line keeps of a run's motion, and says where it cannot."""

import pytest
from typer.testing import CliRunner

from executive.cli.app import app
from executive.doors.recorder.feed import complaint_without_extra
from executive.doors.view.motion_read import recording_of
from executive.runs.run_log import recorded_runs

pytestmark = pytest.mark.timeout(300)
SENTENCE = "move backward for 1 second"


def said(*words):
    return CliRunner().invoke(app, list(words))


@pytest.fixture
def without_extra(monkeypatch):
    """The package that writes MCAP is not installed."""
    there = __import__("importlib.util", fromlist=["find_spec"]).find_spec
    monkeypatch.setattr(
        "executive.doors.companion.find_spec", lambda name: None if name == "mcap" else there(name)
    )


def test_record_keeps_the_motion_and_export_finds_it(tmp_path):
    done = said("run", SENTENCE, "--record", str(tmp_path), "--quiet")
    (run,) = recorded_runs(tmp_path)

    assert done.exit_code == 0, done.output
    assert recording_of(run).ends_s > 1.0
    told = said("export", run.name, "--record", str(tmp_path))
    assert told.exit_code == 0
    assert told.stdout.strip() == str(run.path / "motion.mcap")


def test_without_the_extra_a_run_is_recorded_as_before_and_one_line_says_so(tmp_path, without_extra):
    done = said("run", SENTENCE, "--record", str(tmp_path), "--quiet")
    (run,) = recorded_runs(tmp_path)

    assert done.exit_code == 0
    assert done.stderr.splitlines() == [f"executive: {complaint_without_extra()}"]
    assert sorted(one.name for one in run.path.iterdir() if one.is_file()) == [
        "events.jsonl",
        "report.json",
        "run.json",
    ]


def test_export_without_the_extra_says_what_to_install(tmp_path, without_extra):
    told = said("export", "--record", str(tmp_path))

    assert told.exit_code == 2
    assert told.stderr.strip() == (
        "executive: the package 'mcap' is not installed: pip install \"humanoid-executive[record]\""
    )


def test_two_runs_are_for_the_page_alone():
    told = said("replay", "one", "two")

    assert told.exit_code == 2
    assert "--view" in told.stderr


def test_a_panel_wants_a_film():
    told = said("run", SENTENCE, "--panel")

    assert told.exit_code == 2
    assert "--video" in told.stderr
