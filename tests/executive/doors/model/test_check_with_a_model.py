"""``executive check --model``: what a model makes of free speech is told and judged, and nothing moves."""

import json

import pytest
from typer.testing import CliRunner

from executive.cli.app import app
from tools.evaluate.front.scripted_server import Answer, ScriptedServer, steps

FREE = "would you be so kind and get hold of that red cup over there for me to see"


@pytest.fixture
def check(tmp_path, monkeypatch):
    """Checks a sentence with a model in front of it; answers result and report."""

    def check(server, text, *options):
        config = tmp_path / "config.toml"
        config.write_text(server.settings())
        report = tmp_path / "report.json"
        words = ["check", text, "--model", "scripted", "--config", str(config), "--report", str(report)]
        result = CliRunner().invoke(app, [*words, *options])
        return result, json.loads(report.read_text()) if report.exists() else None

    monkeypatch.delenv("HUMANOID_EXECUTIVE_CONFIG", raising=False)
    yield check
    monkeypatch.delenv("HUMANOID_EXECUTIVE_CONFIG", raising=False)


@pytest.mark.requirement("L10")
def test_the_read_back_is_told_as_the_question_that_it_would_be(check):
    with ScriptedServer(steps("pick up the red cup")) as server:
        result, report = check(server, FREE)

    assert result.exit_code == 3
    assert result.stdout.splitlines()[-1] == "question: I understood: pick up the red cup; shall I?"
    assert report["outcome"] == "question"
    assert not report["motions"]


@pytest.mark.slow
@pytest.mark.requirement("L10")
def test_without_a_read_back_what_is_proposed_is_judged(check):
    with ScriptedServer(steps("pick up the red cup")) as server:
        result, report = check(server, FREE, "--yes")

    assert result.exit_code == 0, result.output
    assert result.stdout.splitlines()[-1] == "safe: 3 motions planned and checked"
    assert len(report["motions"]) == 3


@pytest.mark.requirement("L10")
def test_what_was_not_said_is_told_even_without_a_read_back(check):
    with ScriptedServer(steps("pick up the red bottle")) as server:
        result, report = check(server, FREE, "--yes")

    assert result.exit_code == 3
    assert "you did not say 'bottle'" in result.output
    assert not report["motions"]


@pytest.mark.requirement("L10")
def test_a_model_that_fails_is_told_beside_what_the_parser_says(check):
    with ScriptedServer(Answer((b"{}",), 429)) as server:
        result, report = check(server, FREE)

    assert result.exit_code == 2
    assert result.stdout.splitlines()[-1].startswith("refused: ")
    assert "the server takes no more requests for now" in result.output
    assert not report["motions"]


def test_what_the_parser_understands_goes_to_no_model(check):
    with ScriptedServer(steps("pick up the red cup")) as server:
        result, _ = check(server, "go home")

    assert result.exit_code == 0
    assert not server.requests


def test_a_model_that_is_not_set_up_is_told():
    result = CliRunner().invoke(app, ["check", FREE, "--model", "nobody"])

    assert result.exit_code == 2
    assert "no model 'nobody'" in result.output
