"""A disk that is full, an output that is gone: told in one line, and the robot goes on."""

import pytest
from typer.testing import CliRunner

from executive import cli


@pytest.fixture
def executive(tmp_path, monkeypatch):
    """Run the command line, with this user's data in a folder of the test's own."""
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "data"))
    return lambda *arguments, **options: CliRunner().invoke(cli.app, list(arguments), **options)


def test_a_robot_whose_runs_cannot_be_recorded_is_not_served(executive, tmp_path):
    result = executive("serve", "--record", "/proc/none", "--folder", str(tmp_path / "live"))

    assert result.exit_code == 2
    assert "cannot write /proc/none" in result.stderr
    assert not (tmp_path / "live").exists()
