"""The command language can be held in one head: what understanding a sentence imports has bounds."""

import subprocess
import sys
from pathlib import Path

import pytest
from source import ROOT

MOST_LINES, MOST_MODULES = 6_500, 60
MOST_LINES_OF_GRAMMAR = 450
MOST_LINES_OF_WORDS = 2_300
# What all of the executive shares.
NO_PART_OF_IT = ("executive.meaning", "executive.errors", "executive.config")
IMPORTED_BY_PARSE = """
import sys
from executive.understanding.command_parser import parse
parse("pick up the red cup")
for name, module in sorted(sys.modules.items()):
    if name.split(".")[0] == "executive" and getattr(module, "__file__", None):
        print(name, module.__file__)
"""


def lines_of(files):
    return sum(len(file.read_text("utf-8").splitlines()) for file in files)


@pytest.fixture(scope="module")
def imported():
    """The files of the modules that parsing one sentence imports, by their names."""
    ran = subprocess.run(
        [sys.executable, "-c", IMPORTED_BY_PARSE], capture_output=True, text=True, check=True, cwd=ROOT
    )
    rows = (line.split(maxsplit=1) for line in ran.stdout.splitlines())
    return {name: Path(file) for name, file in rows if not name.startswith(NO_PART_OF_IT)}


@pytest.mark.requirement("L9")
def test_what_a_parse_imports_has_few_lines(imported):
    lines = {name: lines_of([file]) for name, file in imported.items()}

    assert sum(lines.values()) <= MOST_LINES, sorted(lines.items(), key=lambda one: -one[1])[:10]


def test_what_a_parse_imports_has_few_modules(imported):
    assert len(imported) <= MOST_MODULES


def test_the_grammar_has_few_lines():
    assert lines_of((ROOT / "executive").rglob("*.lark")) <= MOST_LINES_OF_GRAMMAR


def test_the_words_have_few_lines():
    folders = (ROOT / "executive/vocabulary", ROOT / "executive/language")

    assert lines_of(file for folder in folders for file in folder.rglob("*.toml")) <= MOST_LINES_OF_WORDS
