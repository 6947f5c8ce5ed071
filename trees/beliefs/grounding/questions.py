"""Failures that a person's answer puts right: several things fit, and one is meant."""

from __future__ import annotations

from trees.beliefs.grounding.grounding import Ambiguous
from trees.failures import CHOICES_JOINED_BY, Failure, FailureKind, Number

OTHER = "to.relation"
"""In place of a slot: what a relation in "to" compares with."""

ONE_WILL_DO = "one_will_do"
"""Number of a question that is no doubt: where there is one choice, nobody has to be asked."""


def which_is_meant(unclear: Ambiguous, slot: str = "object", **numbers: Number) -> Failure:
    """The question, with its choices in words and as the planning scene names them.

    Args:
        unclear: What is not clear.
        slot: The task's slot that the answer fills in, or ``OTHER``.
        numbers: Besides.
    """
    return Failure(
        FailureKind.INFEASIBLE,
        unclear.message,
        {
            "choices": CHOICES_JOINED_BY.join(choice.words for choice in unclear.choices),
            "objects": CHOICES_JOINED_BY.join(choice.name for choice in unclear.choices),
            "slot": slot,
            "count": len(unclear.choices),
            **numbers,
        },
    )
