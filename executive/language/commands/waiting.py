"""Waiting, where the robot stands or somewhere else: "wait in the kitchen for ten seconds"."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from types import MappingProxyType

from executive.language.commands.going import goal_of
from executive.language.commands.limits import bounded
from executive.language.phrases.arranging import clause, guarded, trouble, unfit
from executive.language.phrases.parts import Parts, words
from executive.language.phrases.values import Clause, Meaning, Measure, Nominal, Relative, draft

MAX_WAIT_S = 3600.0
"""A robot that waits stands; beyond it the number is taken for a mistake."""

_LINGERS = "linger"
"""Meaning of the verbs of waiting that take a place; nobody is to rest or to sleep there."""


def _wait(parts: Parts) -> Clause:
    measures = [part for part in parts if isinstance(part, Measure)]
    if not measures:
        raise trouble("for how long?", asks=True)
    if measures[0].of != "duration":
        raise unfit()
    return clause(parts, [(draft("wait", duration_s=round(bounded(measures[0], MAX_WAIT_S), 3)),)])


def _wait_at(parts: Parts) -> Clause:
    """To walk there, though that may have been ordered before: it may have gone elsewhere since."""
    if words(parts, "WAIT")[0].meaning.partition(":")[0] != _LINGERS:
        raise unfit()
    goal = next(part for part in parts if isinstance(part, (Nominal, Relative)))
    measures = [part for part in parts if isinstance(part, Measure)]
    if not measures:
        raise trouble("for how long?", asks=True)
    waits = _wait((words(parts, "WAIT")[0], *measures))
    return replace(waits, bundles=((draft("walk_to", to=goal),), *waits.bundles))


def _waiting_at(parts: Parts) -> Nominal | Relative:
    goal = goal_of(parts[-1])
    if not isinstance(goal, Nominal):
        raise unfit()
    if words(parts, "IN") and (goal.sort != "room" or words(parts, "IN")[0].said not in ("in", "inside")):
        raise unfit()
    if not goal.is_place:
        raise unfit()
    return goal


MEANINGS: Mapping[str, Meaning] = MappingProxyType(
    {"wait": guarded(_wait), "wait_at": guarded(_wait_at), "waiting_at": guarded(_waiting_at)}
)
