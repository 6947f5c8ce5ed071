"""The order of a script: once more, go on or stop, and which result is told."""

from dataclasses import dataclass

import pytest

from executive.exit_codes import ExitCode
from executive.meaning import Parsed
from executive.scripts.script_order import first_unexpected, in_order, unexpected_code
from executive.understanding.statement import Statement


@dataclass(frozen=True)
class Ended:
    """Ended so."""

    outcome: str
    exit_code: ExitCode = ExitCode.FAILED


def said(text, **more):
    return Statement(Parsed(text), **more)


class Robot:
    """Ends what it is told as it was told to, and remembers it."""

    def __init__(self, *outcomes):
        self.outcomes, self.told = list(outcomes), []

    def __call__(self, statement):
        self.told.append(statement.parsed.text)
        return [Ended(self.outcomes.pop(0))]


@pytest.mark.parametrize(
    ("on_failure", "outcomes", "told"),
    [
        ("stop", ["failed"], ["a"]),
        ("continue", ["failed", "done"], ["a", "b"]),
        ("retry", ["failed", "failed"], ["a", "a"]),
        ("retry", ["failed", "done", "done"], ["a", "a", "b"]),
        ("retry", ["done", "done"], ["a", "b"]),
        ("retry", ["cancelled"], ["a"]),
        ("continue", ["cancelled"], ["a"]),
    ],
)
def test_what_is_said_after_a_failure_is_as_the_statement_says(on_failure, outcomes, told):
    robot = Robot(*outcomes)

    in_order([said("a", on_failure=on_failure), said("b")], robot)

    assert robot.told == told
    assert not robot.outcomes


def test_results_of_both_tries_are_kept_and_the_last_one_counts():
    results = in_order([said("a", on_failure="retry")], Robot("failed", "done"))

    assert [ended.outcome for ended in results[0][1]] == ["failed", "done"]
    assert first_unexpected(results) is None


def test_the_first_surprise_is_told_even_when_a_later_statement_was_done():
    results = in_order(
        [said("a", expect="refused"), said("b", on_failure="continue"), said("c")],
        Robot("refused", "failed", "done"),
    )

    statement, ended = first_unexpected(results)

    assert (statement.parsed.text, ended.outcome) == ("b", "failed")


def test_what_was_done_against_expectation_is_a_failure():
    assert unexpected_code(Ended("done", ExitCode.DONE)) is ExitCode.FAILED
    assert unexpected_code(Ended("question", ExitCode.QUESTION)) is ExitCode.QUESTION
