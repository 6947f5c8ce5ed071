"""``executive run --model``: free speech to what is done, or to a clear reason why not."""

import json

import pytest
from typer.testing import CliRunner

from executive.cli.app import app
from tools.evaluate.front.scripted_server import Answer, ScriptedServer, saying, steps

FREE = "would you be so kind and get hold of that red cup over there for me to see"


@pytest.fixture
def run(tmp_path, monkeypatch):
    """Runs a sentence with a model in front of it; answers result and report."""

    def run(server, text, *options, typed="", **keys):
        config = tmp_path / "config.toml"
        config.write_text(server.settings(**keys))
        report = tmp_path / "report.json"
        words = ["run", text, "--model", "scripted", "--config", str(config), "--report", str(report)]
        result = CliRunner().invoke(app, [*words, "--record", str(tmp_path / "runs"), *options], input=typed)
        return result, json.loads(report.read_text()) if report.exists() else None

    monkeypatch.delenv("HUMANOID_EXECUTIVE_CONFIG", raising=False)
    yield run
    monkeypatch.delenv("HUMANOID_EXECUTIVE_CONFIG", raising=False)


@pytest.mark.slow
@pytest.mark.requirement("L10")
def test_free_speech_is_read_back_and_done(run, tmp_path):
    with ScriptedServer(steps("pick up the red cup")) as server:
        result, report = run(server, FREE, typed="yes\n")

    assert "I understood: pick up the red cup" in result.output
    assert result.exit_code == 0, result.output
    assert report["outcome"] == "done"
    assert report["tasks"][0]["provenance"] == {"step": 0, "confidence": 0.95, "form": "sentence"}

    (recorded,) = (tmp_path / "runs").iterdir()
    again = CliRunner().invoke(app, ["replay", str(recorded)])  # the server is gone by now
    assert again.exit_code == 0, again.output
    assert "identical" in again.output


@pytest.mark.slow
@pytest.mark.requirement("L10")
def test_after_a_failure_it_proposes_anew(run):
    with ScriptedServer(steps("pick up the can"), steps("pick up the red bottle")) as server:
        text = "there ought to be a can or else a red bottle about, get a grip of what you find mate"
        # an arm's failure is the same, without a walk about the room for the can
        result, report = run(server, text, "--robot", "panda", typed="yes\nyes\n")

    assert result.exit_code == 0, result.output
    assert [task["outcome"] for task in report["tasks"]][-2:] == ["failed", "done"]
    failures = json.loads(server.requests[1]["messages"][1]["content"])["failures"]
    assert failures[0]["failure"]["kind"] == "POSTCONDITION"


@pytest.mark.requirement("L10")
@pytest.mark.parametrize(
    ("answer", "told"),
    [
        (Answer((b"{}",), 429), "the server takes no more requests for now"),
        (saying("Sure!"), "not of the form that was asked for"),
        (saying(None, refusal="I cannot"), "the model declined"),
        (steps("move forward at 3 m/s"), "the limit of 0.5 m/s"),
    ],
)
def test_where_nothing_comes_of_it_nothing_moves_and_the_line_says_why(run, answer, told):
    with ScriptedServer(answer) as server:
        result, report = run(server, FREE, "--yes")

    assert result.exit_code == 2
    assert told in result.output
    assert report["safety"]["checked_trajectories"] == 0


@pytest.mark.requirement("L10")
def test_what_was_not_said_is_asked_even_without_a_read_back(run):
    with ScriptedServer(steps("pick up the blue box")) as server:
        result, report = run(server, FREE, "--yes")

    assert result.exit_code == 3
    assert (
        "you did not say 'box', 'blue'" in result.output or "you did not say 'blue', 'box'" in result.output
    )
    assert report["safety"]["checked_trajectories"] == 0


def test_without_a_model_nothing_is_asked(run):
    with ScriptedServer(steps("pick up the red cup")) as server:
        result = CliRunner().invoke(app, ["parse", FREE])

    assert result.exit_code == 2
    assert not server.requests


def test_parse_says_what_would_be_read_back(run, tmp_path):
    config = tmp_path / "config.toml"
    with ScriptedServer(steps("pick up the red cup")) as server:
        config.write_text(server.settings())
        words = ["parse", FREE, "--model", "scripted", "--config", str(config)]
        asked = CliRunner().invoke(app, words)
        unasked = CliRunner().invoke(app, [*words, "--yes"])

    assert asked.exit_code == 3
    assert json.loads(asked.output)["question"]["text"] == "I understood: pick up the red cup; shall I?"
    assert json.loads(unasked.output)["tasks"] == [
        {"action": "pick", "object": {"kind": "cup", "color": "red"}}
    ]


def test_a_model_that_is_not_set_up_is_told(tmp_path):
    result = CliRunner().invoke(app, ["run", FREE, "--model", "nobody", "--record", str(tmp_path)])

    assert result.exit_code == 2
    assert "no model 'nobody'" in result.output


def test_a_key_that_is_not_there_is_told_before_anything_is_sent(run, monkeypatch):
    monkeypatch.delenv("A_KEY", raising=False)
    with ScriptedServer(steps("go home")) as server:
        result, _ = run(server, FREE, key_env="A_KEY")

    assert result.exit_code == 2
    assert "the environment variable A_KEY is not set" in result.output
    assert not server.requests
