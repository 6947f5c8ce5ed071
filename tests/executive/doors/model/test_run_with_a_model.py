"""From free speech over a model's server to a task that is done, and read back before."""

import json

import pytest
from typer.testing import CliRunner

from executive.cli.app import app
from tools.evaluate.front.scripted_server import ScriptedServer, steps

FREE = "would you be so kind and get hold of that red cup over there for me to see"


@pytest.fixture
def run(tmp_path, monkeypatch):
    """Runs a sentence with a model in front of it; answers result and report."""

    def run(server, text, *options, typed=""):
        config = tmp_path / "config.toml"
        config.write_text(server.settings())
        report = tmp_path / "report.json"
        words = [
            "run",
            text,
            "--model",
            "scripted",
            "--config",
            str(config),
            "--record",
            str(tmp_path / "runs"),
        ]
        result = CliRunner().invoke(app, [*words, "--report", str(report), *options], input=typed)
        return result, json.loads(report.read_text()) if report.exists() else None

    return run


@pytest.mark.slow
@pytest.mark.requirement("L10")
def test_free_speech_is_read_back_and_done(run):
    with ScriptedServer(steps("pick up the red cup")) as server:
        result, report = run(server, FREE, typed="yes\n")

    assert "I understood: pick up the red cup" in result.output
    assert result.exit_code == 0, result.output
    assert report["outcome"] == "done"
