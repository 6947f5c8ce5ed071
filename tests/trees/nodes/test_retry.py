import pytest
from py_trees.common import Status

from trees.failures import Failure, FailureKind
from trees.nodes.leaf import DONE, RUNNING
from trees.nodes.retry import Retry


def never(failure, before):
    return False


def failing(*messages):
    return [Failure.postcondition(message) for message in messages]


def test_success_at_once_needs_no_recovery(stage, probe_leaf):
    recover = probe_leaf("recover", stage.toolbox, DONE)
    retry = Retry("attempts", probe_leaf("try", stage.toolbox, RUNNING, DONE), recover, 3, never)

    assert stage.run(retry) is Status.SUCCESS
    assert (retry.attempts, recover.begun) == (1, 0)


def test_each_failure_is_followed_by_a_recovery_and_another_attempt(stage, probe_leaf):
    attempt = probe_leaf("try", stage.toolbox, *failing("first", "second"), DONE)
    recover = probe_leaf("recover", stage.toolbox, RUNNING, DONE)
    retry = Retry("attempts", attempt, recover, 4, never)

    assert stage.run(retry) is Status.SUCCESS
    assert (retry.attempts, recover.begun) == (3, 2)


@pytest.mark.requirement("M4")
def test_giving_up_tells_every_attempt_the_last_one_first(stage, probe_leaf, chain):
    attempt = probe_leaf("try", stage.toolbox, *failing("first", "second", "third"))
    retry = Retry("attempts", attempt, probe_leaf("recover", stage.toolbox, DONE), 3, never)

    assert stage.run(retry) is Status.FAILURE
    assert [link.message for link in chain(retry.failure)] == ["third", "second", "first"]
    assert retry.attempts == 3


def test_a_hopeless_failure_ends_it_at_once(stage, probe_leaf):
    attempt = probe_leaf("try", stage.toolbox, *failing("hopeless"))
    recover = probe_leaf("recover", stage.toolbox, DONE)
    retry = Retry("attempts", attempt, recover, 3, lambda failure, before: failure.message == "hopeless")

    assert stage.run(retry) is Status.FAILURE
    assert (retry.attempts, recover.begun) == (1, 0)


def test_a_failed_recovery_ends_it_with_the_attempt_as_its_cause(stage, probe_leaf, chain):
    recover = probe_leaf("recover", stage.toolbox, Failure.refused("no"))
    retry = Retry("attempts", probe_leaf("try", stage.toolbox, *failing("first")), recover, 3, never)

    assert stage.run(retry) is Status.FAILURE
    assert [link.kind for link in chain(retry.failure)] == [FailureKind.REFUSED, FailureKind.POSTCONDITION]


def test_the_recovery_can_read_what_went_wrong(stage, probe_leaf):
    retry = Retry(
        "attempts",
        probe_leaf("try", stage.toolbox, *failing("first"), DONE),
        probe_leaf("recover", stage.toolbox, DONE),
        3,
        never,
    )
    stage.run(retry)

    assert stage.output("failure").message == "first"


def test_a_halt_reaches_the_child_at_work(stage, probe_leaf):
    attempt = probe_leaf("try", stage.toolbox, RUNNING)
    retry = stage.ready(Retry("attempts", attempt, probe_leaf("recover", stage.toolbox, DONE), 3, never))
    stage.tick(retry)

    retry.stop(Status.INVALID)

    assert attempt.released == ["halted"]


def test_a_second_run_counts_from_one_again(stage, probe_leaf):
    attempt = probe_leaf("try", stage.toolbox, *failing("first"), DONE)
    retry = Retry("attempts", attempt, probe_leaf("recover", stage.toolbox, DONE), 3, never)
    stage.run(retry)
    attempt.script = [DONE]

    stage.tick(retry)

    assert retry.attempts == 1
