"""Options of a run that do not go together are named before anything moves."""

import pytest
from typer.testing import CliRunner

from executive.cli.app import app
from executive.doors import companion


@pytest.mark.requirement("U3")
@pytest.mark.parametrize("door", ["--ros", "--view"])
@pytest.mark.parametrize(
    "option",
    [
        ("--report", "report.json"),
        ("--video", "film.mp4"),
        ("--junit", "run.xml"),
        ("--on-question", "first"),
    ],
)
def test_a_run_with_a_door_refuses_what_only_its_own_process_could_do(option, door, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    result = CliRunner().invoke(app, ["run", "wave", door, *option])

    assert result.exit_code == 2
    assert f"{option[0]}: not with {door}" in " ".join(result.stderr.split())
    assert list(tmp_path.iterdir()) == []


def test_a_page_without_what_it_needs_is_refused_in_one_line(tmp_path, monkeypatch):
    monkeypatch.setattr(companion, "find_spec", lambda name: None if name == "viser" else object())
    result = CliRunner().invoke(app, ["serve", "--view", "--folder", str(tmp_path / "live")])

    assert result.exit_code == 2
    assert result.stderr.count("\n") == 1
    assert "humanoid-executive[view]" in result.stderr
