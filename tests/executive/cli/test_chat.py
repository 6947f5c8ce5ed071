"""What is wrong with how a chat is begun is said in one line, before anybody talks."""

import pytest
from typer.testing import CliRunner

from executive.cli.app import app


@pytest.fixture
def chat(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "data"))
    monkeypatch.setenv("XDG_RUNTIME_DIR", str(tmp_path))
    return lambda *options: CliRunner().invoke(app, ["chat", *options], input="wave\n")


@pytest.mark.requirement("U1")
def test_where_nobody_serves_a_robot_that_is_said(chat):
    result = chat("--attach")

    assert result.exit_code == 2
    assert "executive serve" in result.stderr


@pytest.mark.parametrize(
    "option",
    [
        ("--scene", "flat"),
        ("--robot", "talos"),
        ("--seed", "0"),
        ("--model", "house"),
        ("--yes",),
        ("--pace", "fast"),
        ("--confidence", "0.9"),
        ("--policy", "partial"),
    ],
)
def test_what_a_served_robot_was_started_with_is_not_chosen_again(chat, option):
    result = chat("--attach", *option)

    assert result.exit_code == 2
    assert f"{option[0]}" in result.stderr
    assert "served already" in result.stderr


def test_a_scene_that_there_is_not_is_named(chat):
    result = chat("--scene", "nowhere")

    assert result.exit_code == 2
    assert "nowhere" in result.stderr
    assert "Traceback" not in result.output
