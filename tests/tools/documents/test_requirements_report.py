"""The report of requirements says what is proven, and nothing more."""

import re
from pathlib import Path

from tools.documents.requirements_report import REQUIREMENTS, requirement_rows, verdicts

TESTS = Path(__file__).parents[2]
MARK, NAME = re.compile(r"mark\.requirement\(([^)]*)\)"), re.compile(r'"(\w+)"')
ROWS = {"A1": "walks", "A2": "talks", "A3": "sees", "A4": "hears"}


def counts(passed=0, failed=0, skipped=0):
    return {"passed": passed, "failed": failed, "skipped": skipped}


def test_a_row_is_proven_by_a_passing_test_and_not_beside_a_failing_one():
    found = verdicts(ROWS, {"A1": counts(2), "A2": counts(2, 1), "A3": counts(skipped=1)})

    assert {v.name: v.state for v in found} == {"A1": "proven", "A2": "FAILS", "A3": "skipped", "A4": "open"}
    assert [v.name for v in found if v.proven] == ["A1"]


def test_a_mark_that_names_no_row_is_a_failure():
    assert [v.state for v in verdicts(ROWS, {"Z9": counts(1)})] == ["open"] * 4 + ["FAILS"]


def test_rows_are_read_with_every_column():
    table = ["| id | fault | expected |", "| --- | --- | --- |", "| F7 | battery low | put down |"]
    text = "\n".join([*table, "| U5 | installs |", "F8"])

    assert requirement_rows(text) == {"F7": "battery low: put down", "U5": "installs"}


def test_every_row_is_carried_by_a_test_and_every_mark_names_a_row():
    marks = (mark for file in TESTS.rglob("test_*.py") for mark in MARK.findall(file.read_text("utf-8")))
    marked = {name for mark in marks for name in NAME.findall(mark)}

    assert marked == set(requirement_rows(REQUIREMENTS.read_text("utf-8")))


def test_the_published_tables_hold_the_rows_of_every_group():
    groups = {name[0] for name in requirement_rows(REQUIREMENTS.read_text("utf-8"))}

    assert groups == {"L", "S", "M", "P", "A", "F", "U"}
