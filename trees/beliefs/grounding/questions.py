"""Failures that a person's answer puts right: several things fit, and one is meant."""

from __future__ import annotations

from trees.beliefs.grounding.grounding import Ambiguous
from trees.failures import Failure, OpenChoice

OTHER = "to.relation"
"""In place of a slot: what a relation in "to" compares with."""


def which_is_meant(
    unclear: Ambiguous, slot: str = "object", *, unseen: int = 0, one_will_do: bool = False
) -> Failure:
    """The question, with its choices in words and as the planning scene names them.

    Args:
        unclear: What is not clear.
        slot: The task's slot that the answer fills in, or ``OTHER``.
        unseen: How many of the choices this task has not seen.
        one_will_do: Whether nobody has to be asked where there is one choice alone.
    """
    words = tuple(choice.words for choice in unclear.choices)
    names = tuple(choice.name for choice in unclear.choices)
    return Failure.asking(unclear.message, OpenChoice(words, names, slot, unseen, one_will_do))
