"""Judgements of failures that control nodes are made with; stored trees call them by their names."""

from __future__ import annotations

from py_trees.behaviour import Behaviour

from trees.failures import Failure, FailureKind


def no_pick_helps(failure: Failure) -> bool:
    """A defect, or several objects that fit: that takes an answer."""
    return defect(failure) or bool(failure.choices)


def defect(failure: Failure) -> bool:
    """No other way helps against a defect or a halt."""
    return failure.kind in (FailureKind.ERROR, FailureKind.CANCELED)


def always_worth_trying(_way: Behaviour, _failure: Failure | None) -> bool:
    """Every way, whatever failed before."""
    return True


def looking_elsewhere_is_useless(failure: Failure) -> bool:
    """A defect, or several objects in view that fit: that takes an answer, not another look."""
    return defect(failure) or bool(failure.choices)


def _tidying_helps(failure: Failure) -> bool:
    """Not after a defect; and while a question is open nothing moves."""
    return not defect(failure) and not failure.choices


def no_other_attempt_helps(failure: Failure, before: Failure | None) -> bool:
    """A defect, or the planner's second no in a row: it has been asked from home, with a new look."""
    twice = before is not None and before.kind is failure.kind is FailureKind.INFEASIBLE
    return defect(failure) or bool(failure.choices) or twice
