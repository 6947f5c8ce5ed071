"""Values that cannot be: the message names the input, the value, and what it may be."""

import json

import pytest
from typer.testing import CliRunner

from executive.cli import app as cli
from executive.errors import ScriptError
from executive.scripts.task_script import load_script


@pytest.fixture
def executive(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "data"))
    return lambda *arguments: CliRunner().invoke(cli.app, [str(one) for one in arguments])


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        ("run wave --seed abc", "'--seed': 'abc' is not a whole number 0 or more"),
        ("check wave --seed -1", "'--seed': '-1' is not a whole number 0 or more"),
        ("serve --seed 0.5", "'--seed': '0.5' is not a whole number 0 or more"),
        ("run wave --confidence 1.5", "'--confidence': '1.5' is not a number from 0 to 1"),
        ("run wave --confidence nan", "'--confidence': 'nan' is not a number from 0 to 1"),
        ("stop --category 3", "'--category': '3' is not a whole number from 0 to 2"),
        ("check wave --margin 2", "'--margin': '2' is not a number from 0 to 1"),
    ],
)
def test_a_number_out_of_its_range_is_named_with_the_range(executive, arguments, says):
    result = executive(*arguments.split())

    assert result.exit_code == 2
    assert says in result.stderr


def test_a_mistyped_expectation_gets_the_nearest_word(tmp_path):
    script = tmp_path / "tidy.toml"
    script.write_text('[[task]]\nsay = "wave"\nexpect = "refsued"\n')

    with pytest.raises(ScriptError, match=r"'refsued'; the nearest is 'refused'"):
        load_script(script)


def test_parse_reads_the_statements_of_a_script(executive, tmp_path):
    script = tmp_path / "tidy.toml"
    script.write_text('[[task]]\nsay = "wave"\n[[task]]\nsay = "dance"\n')

    documents = [json.loads(line) for line in executive("parse", script).stdout.splitlines()]

    assert [document["outcome"] for document in documents] == ["tasks", "refused"]


@pytest.mark.parametrize("command", ["parse", "tree"])
def test_what_ends_in_toml_is_no_sentence(executive, tmp_path, command):
    result = executive(command, tmp_path / "none.toml")

    assert (result.exit_code, result.stdout) == (2, "")
    assert "none.toml" in result.stderr


def test_a_tree_of_a_script_says_what_a_tree_is_of(executive, tmp_path):
    script = tmp_path / "tidy.toml"
    script.write_text('[[task]]\nsay = "wave"\n')

    assert "one sentence" in executive("tree", script).stderr


def test_why_of_a_run_without_a_name_says_so(executive):
    result = executive("why", "")

    assert result.exit_code == 2
    assert "name of the run is empty" in result.stderr


@pytest.mark.parametrize("folder", ["none", "file"])
def test_runs_of_what_is_no_folder_are_a_mistake(executive, tmp_path, folder):
    (tmp_path / "file").write_text("")

    result = executive("runs", "--record", tmp_path / folder)

    assert result.exit_code == 2
    assert "folder" in result.stderr
