"""Why a task failed, for somebody who has never seen the tree: what, why, where, and the numbers."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from types import MappingProxyType

from executive.reports.feedback import quantity
from executive.reports.plain_finding import plain_finding
from executive.session.task_result import chain
from trees.failures import Failure, FailureKind, Number

MEANINGS: Mapping[FailureKind, str] = MappingProxyType(
    {
        FailureKind.INFEASIBLE: "no plan was found, or a person has to say which thing is meant",
        FailureKind.UNSAFE: "the checker found a motion that must not be carried out; it was not begun",
        FailureKind.REFUSED: "the last gate before the motors, or the robot's state, did not let it pass",
        FailureKind.EXECUTION: "a motion was begun and did not end where it should",
        FailureKind.POSTCONDITION: "what has to be true was measured not to be",
        FailureKind.TIMEOUT: "it took longer than allowed",
        FailureKind.CANCELED: "somebody halted it; it braked and holds",
        FailureKind.ERROR: "a defect of this program; the robot holds, and the log has the details",
    }
)
"""What each kind means."""

ADVICE: Mapping[FailureKind, str] = MappingProxyType(
    {
        FailureKind.INFEASIBLE: (
            "put it nearer, clear what stands close to it, put down what is held, or name another thing"
        ),
        FailureKind.UNSAFE: "clear what would be touched, or name the other hand or another place",
        FailureKind.REFUSED: (
            "`executive status` tells the robot's state; an emergency stop ends with `executive reset`"
        ),
        FailureKind.EXECUTION: "look after the joint or thing that is named, then say it again",
        FailureKind.POSTCONDITION: (
            "look whether it is as the numbers say, then say it again or describe the thing differently"
        ),
        FailureKind.TIMEOUT: "look whether what is waited for is running, then say it again",
        FailureKind.CANCELED: "say it again to begin anew",
        FailureKind.ERROR: "give the run's folder to those who mend the program",
    }
)
"""What a person can do after each kind."""

_HIDDEN = frozenset({"choices", "attempts", "exception", "raised_at"})
_IN_THE_MESSAGE = frozenset({"step", "findings", "subject", "value", "limit", "t_s"})
"""What the message of an unsafe trajectory says already."""


def explained(failure: Failure) -> Iterator[str]:
    """Explain a failure chain, the reason at its root first.

    Links that merely repeat what caused them are left out.
    """
    links = chain(failure)
    root = links[-1]
    yield f"what happened: {failure.message}"
    yield f"why: {root.message}"
    if (plainly := _plainly(root)) is not None:
        yield f"that is: {plainly}"
    if root.where:
        yield f"where: the step {leaf_of(root)!r} of {root.where}"
    numbers = _numbers(root)
    if numbers:
        yield f"numbers: {numbers}"
    yield f"{root.kind.value} means: {MEANINGS[root.kind]}"
    yield f"what helps: {_advice(root)}"
    between = list(
        dict.fromkeys(link.message for link in reversed(links[1:-1]) if link.message != root.message)
    )
    for message in between:
        yield f"then: {message}"


def _advice(failure: Failure) -> str:
    if failure.choices:
        return f"say which one is meant: {' or '.join(failure.choices)}"
    return ADVICE[failure.kind]


def leaf_of(failure: Failure) -> str:
    """The leaf that failed."""
    return failure.where.rpartition("/")[2]


def in_a_sentence(failure: Failure) -> str:
    """The same in one sentence: leaf, cause and numbers."""
    root = failure.root
    told = f" ({numbers})" if (numbers := _numbers(root)) else ""
    step = f"in the step {leaf_of(root)!r}: " if root.where else ""
    plainly = f"; that is, {said}" if (said := _plainly(root)) is not None else ""
    return f"{step}{root.message}{told}{plainly}"


def _plainly(failure: Failure) -> str | None:
    """What cannot be understood without knowing the program, in other words."""
    if failure.finding is not None:
        return plain_finding(failure.finding)
    if failure.kind is FailureKind.ERROR:
        return "the program itself has a defect; the sentence and the scene are not to blame"
    return None


def _numbers(failure: Failure) -> str:
    hidden = _HIDDEN | _IN_THE_MESSAGE if failure.kind is FailureKind.UNSAFE else _HIDDEN
    if failure.choices:
        hidden = hidden | {"count"}  # the message says it
    return "; ".join(
        f"{value} tries failed: {key}" if _is_count(failure, value) else quantity(key, value)
        for key, value in failure.numbers.items()
        if key not in hidden
    )


def _is_count(failure: Failure, value: Number) -> bool:
    """Whether a number of a failed plan says how many of its tries failed for a reason."""
    counts = isinstance(value, int) and not isinstance(value, bool)
    return counts and failure.kind is FailureKind.INFEASIBLE and leaf_of(failure).startswith("plan")
