"""Where a thing is said to go, or to whom: "the milk goes in the fridge", "the bottle goes to Ana"."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from types import MappingProxyType
from typing import Any

from executive.language.commands.handling import MEANINGS as HANDLING
from executive.language.commands.handling import given
from executive.language.commands.placing import MEANINGS as PLACING
from executive.language.noun_phrases.arranging import arranged, guarded, unfit
from executive.language.phrase_parts import Parts, words
from executive.language.phrases import Benefit, Bundle, Clause, Hand, Item, Meaning, Where
from executive.language.words.word import Word

STATED = "stated"
"""Slot of what is said to go somewhere, after which another command may be meant instead."""

_GIVEN, _BROUGHT = "give", "bring"
"""Meanings in the vocabulary: "should be given to", "needs to be brought to"."""


def _shall_go(parts: Parts) -> Any:
    """The milk needs to go in the fridge, the bottle goes to Ana and the can to me."""
    (verb,) = words(parts, "SHALL_GO")
    first, *others = (part for part in parts if isinstance(part, Item))
    if not all(one.details for one in others):
        raise unfit()
    told = tuple(part for part in parts if not isinstance(part, (Word, Item)) and _is_detail(part))
    first = replace(first, details=(*map(_where_it_is, first.details), *told))
    each = [one.goal for one in arranged((first, *others), goes=True)]
    people = [goal is not None and goal.relation is None and goal.of.is_person for goal in each]
    if any(people) and not all(people):
        raise unfit()  # "the bottle goes to Ana and the can in the bin"
    said = (verb, first, *others)
    if verb.meaning == _BROUGHT:
        return _stated(HANDLING["bring"](said))
    if any(people):
        return _stated(_handed_over(said))
    if verb.meaning == _GIVEN:
        raise unfit()
    return _stated(PLACING["put"](said))


def _handed_over(parts: Parts) -> Clause:
    each = arranged(parts, goes=True)
    return Clause(tuple(given(one, one.goal.of) for one in each if one.goal is not None), "base")


def _where_it_is(detail: Any) -> Where:
    """What is said of a thing before the verb is where it is: "the plate on the counter goes to Ana"."""
    if not isinstance(detail, Where) or detail.role not in ("is", "either"):
        raise unfit()
    return replace(detail, role="is")


def _is_detail(part: Any) -> bool:
    """Whether it is said of a thing, rather than joining two."""
    return isinstance(part, (Where, Hand, Benefit)) or part == "back"


def _stated(clause: Any) -> Any:
    """A clause that says where its things go, or what is wrong with it."""
    if not isinstance(clause, Clause):
        return clause
    return replace(clause, bundles=tuple(map(_as_stated, clause.bundles)))


def _as_stated(bundle: Bundle) -> Bundle:
    return tuple(one.with_slot(STATED, True) for one in bundle)


MEANINGS: Mapping[str, Meaning] = MappingProxyType({"shall_go": guarded(_shall_go)})
