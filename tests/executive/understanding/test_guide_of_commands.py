"""The guide's first table says what the parser does."""

import re
from pathlib import Path

import pytest

from executive.understanding.command_parser import parse

GUIDE = (Path(__file__).parents[3] / "docs" / "guides" / "commands.md").read_text("utf-8")
_TABLE = GUIDE.split("| say | it becomes |\n| --- | --- |\n")[1].split("\n\n")[0]
ROWS = [
    (phrase.strip(" `"), set(re.findall(r"`(\w+)`", row.split(" | ")[1])))
    for row in _TABLE.splitlines()
    for phrase in row.strip("| ").split(" | ")[0].split("; ")
]
_LEANS = re.compile(r"\bit\b")
"""Alone it is asked what such a sentence is about."""


@pytest.mark.parametrize(("phrase", "actions"), ROWS, ids=[phrase for phrase, _ in ROWS])
def test_what_the_guide_says_is_understood_as_it_says(phrase, actions):
    found = parse(phrase)

    if _LEANS.search(phrase):
        assert found.question is not None
    else:
        assert {command.action for command in found.commands} <= actions
        assert found.commands
