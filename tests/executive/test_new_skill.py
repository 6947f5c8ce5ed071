"""The built-in skill of the guide is one new folder and one new file of words: nothing else is touched."""

import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PACKAGES = ("executive", "trees", "robots", "kinematics")

GUIDE = (ROOT / "docs" / "extend" / "a-skill.md").read_text("utf-8")
RECORD, TREE, WORDS = re.findall(r"```(?:python|toml)\n(.*?)```", GUIDE, re.DOTALL)[:3]
ASKED = """
import json
from executive.checks.tree_preview import preview, preview_document, preview_of_document
from executive.cli.commands.list_ import What, _lines
from executive.meaning import command_json
from executive.reports.meaning_words import meaning_words
from executive.understanding.command_parser import parse
from executive.understanding.model_output import read_model_output

parsed = parse("bow to Ana, then go home")
(step,) = read_model_output('{"action": "bow", "person": "Ana", "confidence": 1.0}')
drawn = preview(parsed.commands[0]).root
document = preview_document(parsed.commands[0])
print(json.dumps({
    "listed": [line for line in _lines(What.SKILLS) if line.startswith("bow ")],
    "parsed": [command_json(command) for command in parsed.commands],
    "alone": [command_json(command) for command in parse("take a deep bow").commands],
    "told": meaning_words(command_json(parsed.commands[0])),
    "from_a_model": command_json(step.content),
    "drawn": drawn.name,
    "read_back": preview_of_document(document, "bow.xml").root == drawn,
}))
"""


@pytest.fixture(scope="module")
def house(tmp_path_factory):
    """A copy of the packages with the new skill."""
    root = tmp_path_factory.mktemp("house")
    for package in PACKAGES:
        shutil.copytree(ROOT / package, root / package, ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copytree(ROOT / "tests", root / "tests", ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copy(ROOT / "pyproject.toml", root)
    folder = root / "trees" / "skills" / "bow"
    folder.mkdir()
    (folder / "__init__.py").write_text(RECORD)
    (folder / "tree.py").write_text(TREE)
    (root / "executive" / "vocabulary" / "bow.toml").write_text(WORDS)
    return root


def run(house, *arguments):
    environment = {**os.environ, "PYTHONPATH": str(house)}
    return subprocess.run(
        [sys.executable, *arguments],
        cwd=house,
        env=environment,
        capture_output=True,
        text=True,
        check=False,
        timeout=240,
    )


@pytest.fixture(scope="module")
def told(house):
    done = run(house, "-c", ASKED)
    assert done.returncode == 0, done.stderr[-2000:]
    return json.loads(done.stdout.splitlines()[-1])


def test_it_is_listed(told):
    assert told["listed"] == ["bow        take a bow"]


def test_it_is_understood_among_other_commands(told):
    assert told["parsed"] == [{"action": "bow", "person": "Ana"}, {"action": "go_home"}]


def test_it_is_understood_alone(told):
    assert told["alone"] == [{"action": "bow"}]


def test_a_model_may_ask_for_it(told):
    assert told["from_a_model"] == {"action": "bow", "person": "Ana"}


def test_it_is_told_in_plain_words(told):
    assert told["told"] == "bow to Ana"


def test_its_tree_is_drawn_and_read_back_from_a_document(told):
    assert told["drawn"] == "bow"
    assert told["read_back"]


def test_its_leaves_are_held_to_the_contract(house):
    contract = "tests/trees/test_leaf_contract.py"

    done = run(house, "-m", "pytest", "-q", "-n0", "-p", "no:cacheprovider", contract, "-k", "LeanForward")

    assert done.returncode == 0, done.stdout[-2000:]


def test_its_sentence_is_checked_before_anything_moves(house):
    done = run(house, "-m", "executive", "check", "take a bow")

    assert done.returncode == 0, done.stdout[-2000:] + done.stderr[-2000:]
