"""Failure kinds become exit codes."""

import pytest

from executive.exit_codes import ExitCode
from executive.session.task_result import TaskResult, failure_exit_code
from trees.failures import Failure, FailureKind

CANCELED = Failure(FailureKind.CANCELED, "by the user")


@pytest.mark.requirement("S9")
@pytest.mark.parametrize(
    ("failure", "code"),
    [
        (Failure.infeasible("no grasp"), ExitCode.FAILED),
        (Failure.postcondition("empty", Failure.execution("slipped")), ExitCode.FAILED),
        (Failure.infeasible("gave up", Failure.unsafe("collides")), ExitCode.UNSAFE),
        (Failure.execution("stopped", Failure.refused("too fast")), ExitCode.UNSAFE),
        (Failure.unsafe("collides", Failure.infeasible("no other grasp")), ExitCode.FAILED),
        (Failure.execution("stopped", CANCELED), ExitCode.CANCELLED),
        (Failure.error("raised"), ExitCode.FAILED),
        (None, ExitCode.FAILED),
    ],
)
def test_the_root_of_a_failure_decides_the_exit_code(failure, code):
    assert failure_exit_code(failure) is code


@pytest.mark.parametrize(
    ("outcome", "code"), [("done", 0), ("failed", 1), ("refused", 2), ("question", 3), ("cancelled", 4)]
)
def test_each_outcome_has_its_exit_code(outcome, code):
    assert TaskResult("x", "pick", outcome).exit_code == code
