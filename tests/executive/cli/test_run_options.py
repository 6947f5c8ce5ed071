"""Options of a run that do not go together are named before anything moves."""

import pytest
from typer.testing import CliRunner

from executive.cli.app import app


@pytest.mark.requirement("U3")
@pytest.mark.parametrize(
    "option",
    [
        ("--report", "report.json"),
        ("--video", "film.mp4"),
        ("--junit", "run.xml"),
        ("--perception", "rgbd"),
        ("--on-question", "first"),
    ],
)
def test_a_run_with_ros_refuses_what_only_its_own_process_could_do(option, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    result = CliRunner().invoke(app, ["run", "wave", "--ros", *option])

    assert result.exit_code == 2
    assert f"{option[0]}: not with --ros" in " ".join(result.stderr.split())
    assert list(tmp_path.iterdir()) == []
