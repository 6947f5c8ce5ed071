"""What is said at the end of a script, or of a statement."""

import pytest

from executive.exit_codes import ExitCode
from executive.meaning import Parsed
from executive.scripts.script_run import verdict
from executive.session.task_result import TaskResult
from executive.understanding.statement import Statement


def ended(outcome, expect):
    return Statement(Parsed("say hi"), expect=expect), [TaskResult("say hi", "say", outcome)]


def told(*pairs):
    results = [ended(outcome, expect) for outcome, expect in pairs]
    return verdict([statement for statement, _ in results], results)


@pytest.mark.requirement("U1")
@pytest.mark.parametrize(
    ("outcome", "expect", "begins", "told_outcome", "code"),
    [
        ("done", "refused", "expected refused, got done: say hi", "failed", ExitCode.FAILED),
        ("failed", "question", "expected question, got failed: say hi", "failed", ExitCode.FAILED),
        ("refused", "failed", "expected failed, got refused: say hi", "refused", ExitCode.INVALID),
        ("failed", "done", "failed: say hi", "failed", ExitCode.FAILED),
        ("failed", "failed", "as expected: failed: say hi", "done", ExitCode.DONE),
        ("done", "done", "done: say hi", "done", ExitCode.DONE),
    ],
)
def test_what_was_expected_is_part_of_the_line(outcome, expect, begins, told_outcome, code):
    line, said_outcome, said_code = told((outcome, expect))

    assert line.startswith(begins)
    assert (said_outcome, said_code) == (told_outcome, code)


def test_a_script_says_once_that_all_was_as_expected():
    line, _, _ = told(("done", "done"), ("refused", "refused"))

    assert line.startswith("script done: 2 statements as expected; last refused: say hi")
