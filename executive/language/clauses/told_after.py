"""What is said of a thing behind its command: where it is, its colour, which one it is."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import Any

from executive.language.clauses.scopes import Further
from executive.language.noun_phrases.arranging import arranged, checked, guarded, unfit
from executive.language.noun_phrases.features import described, feature_of
from executive.language.phrase_parts import Parts, words
from executive.language.phrases import (
    Clause,
    Draft,
    Feature,
    Item,
    Meaning,
    Nominal,
    Relative,
    Trouble,
    Where,
)

_LOCATED = frozenset({"pick", "hand_over", "find"})
"""Tasks of a thing that may have a place."""


_TOLD_APART = _LOCATED | {"open", "close", "point_at", "look_at"}
"""Tasks of a thing that may be told from others."""


@dataclass(frozen=True, slots=True)
class ToldAfter:
    """What is said of "it" behind a command.

    Attributes:
        features: What tells it from others.
        places: Where it is.
        number: "ONE" or "ONES", where it is said which one it is.
    """

    features: tuple[Feature | Relative, ...] = ()
    places: tuple[Where, ...] = ()
    number: str = ""


def _told_after(parts: Parts) -> ToldAfter | None:
    said = (feature_of(part) if part in words(parts, "COLOR", "MATERIAL") else part for part in parts)
    features = tuple(part for part in said if isinstance(part, (Feature, Relative)))
    places = tuple(part for part in parts if isinstance(part, Where))
    number = next((word.word_class for word in words(parts, "ONE", "ONES")), "")
    return ToldAfter(features, places, number) if features or places else None


def with_what_is_told_after(parts: Parts) -> Parts | Trouble | None:
    """With what is said of the thing of the command before: "bring me the book, it's on the shelf".

    None where a command has no thing that alone can be meant.
    """
    found: list[Any] = []
    for part in parts:
        if not isinstance(part, ToldAfter):
            found.append(part)
            continue
        before = found.pop()
        of = before.part if isinstance(before, Further) else before
        told = _TOLD((of, part)) if isinstance(of, Clause) else None
        if not isinstance(told, Clause):
            return told
        found.append(replace(before, part=told) if isinstance(before, Further) else told)
    return tuple(found)


def _told(parts: Parts) -> Clause:
    """A command with what is said of its only thing, unless it names another that may be meant."""
    command: Clause = parts[0]
    after: ToldAfter = parts[1]
    if len(command.bundles) != 1:
        raise unfit()
    first, *rest = command.bundles[0]
    return replace(command, bundles=((_with_details(first, rest, after), *rest),))


def _with_details(first: Draft, rest: list[Draft], after: ToldAfter) -> Draft:
    """The first task of a command with its thing as it is told behind it."""
    named = first.get("object")
    goals = [value for one in (first, *rest) for name, value in one.slots if name in ("to", "on", "there")]
    told_of = _LOCATED if after.places else _TOLD_APART
    only_thing = all(isinstance(one, Nominal) and one.is_person for one in goals)
    if first.action not in told_of or not only_thing:
        raise unfit()
    if not isinstance(named, Nominal) or named.reference:
        raise unfit()
    if after.number and (named.plural or named.paired) != (after.number == "ONES"):
        raise unfit()  # "take the cups, it's the red one"
    if after.places and (first.get("source") or named.relation):
        raise unfit()
    if any(where.role in ("to", "from") for where in after.places):
        raise unfit()
    told = described(named, after.features)
    if told is None:
        raise unfit()
    (one,) = arranged((Item(checked(told), after.places),))
    return first.replacing("object", one.object).with_slot("source", one.source)


_TOLD = guarded(_told)

MEANINGS: Mapping[str, Meaning] = MappingProxyType({"told_after": _told_after})
