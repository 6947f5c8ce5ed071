"""Text that an editor or a pipe has put a byte-order mark before is read as if there were none."""

import io
from pathlib import Path

import pytest
from typer.testing import CliRunner

from executive.cli.app import app
from executive.screens.terminal_attendant import TerminalAttendant
from executive.scripts.task_script import load_script
from executive.understanding.command_parser import parser_with
from executive.understanding.understanding import understand
from kinematics.formats.json_reader import parse_document as parse_json
from trees.btcpp.document import parse_document as parse_tree

MARK = "\ufeff"


def test_a_sentence():
    assert understand(f"{MARK}go home").parsed == understand("go home").parsed


def test_a_mark_within_a_sentence_is_refused_as_before():
    assert "U+FEFF" in understand(f"go {MARK}home").parsed.refusal.message


def test_sentences_of_a_file_and_of_standard_input(tmp_path):
    file = tmp_path / "sentences.txt"
    file.write_text(f"{MARK}go home\nwave\n", "utf-8")

    told = [CliRunner().invoke(app, ["parse", str(file)])]
    told.append(CliRunner().invoke(app, ["parse", "-"], input=f"{MARK}go home\n"))
    assert all('"go_home"' in one.stdout for one in told)


def test_an_answer_of_standard_input():
    attendant = TerminalAttendant(io.StringIO(f"{MARK}yes\n"), lambda _line: None)

    assert attendant._line() == "yes"


@pytest.mark.parametrize("ending", ["\n", "\r\n"])
def test_a_script(tmp_path, ending):
    path = tmp_path / "tidy.toml"
    path.write_bytes(f'{MARK}[[task]]{ending}say = "go home"{ending}'.encode())

    assert [one.parsed.text for one in load_script(path).statements] == ["go home"]


def test_a_users_words(tmp_path):
    own = tmp_path / "config.toml"
    own.write_text(f'{MARK}[vocabulary.KIND]\nwords.widget = ["widget", "gizmo"]\n', "utf-8")

    assert parser_with((own,)).parse("pick up the gizmo").commands


def test_a_trajectory_and_a_tree():
    assert parse_json(f'{MARK}{{"a": 1}}').key("a").value == 1
    tree = '<root BTCPP_format="4"><BehaviorTree ID="A"><GoHome/></BehaviorTree></root>'
    assert parse_tree(MARK + tree).main == "A"


def test_text_of_two_bytes_a_letter_is_told_as_no_utf_8(tmp_path):
    path: Path = tmp_path / "tidy.toml"
    path.write_text('[[task]]\nsay = "go home"\n', "utf-16")

    with pytest.raises(Exception, match="is not UTF-8 text"):
        load_script(path)
