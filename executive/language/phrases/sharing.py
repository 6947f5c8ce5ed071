"""Sharing out: "a can each for Ana and Ben", "two cans, one for me and one for Bob", "a cup and another"."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import Any

from executive.language.commands.handling import MEANINGS as HANDLING
from executive.language.commands.handling import given, handed, picked
from executive.language.commands.placing import MEANINGS as PLACING
from executive.language.phrases.arranging import Arranged, arranged, clause, guarded, trouble, unfit
from executive.language.phrases.features import described, feature_of
from executive.language.phrases.parts import Parts, words
from executive.language.phrases.values import (
    Bundle,
    Clause,
    Feature,
    Item,
    Items,
    Meaning,
    Nominal,
    Relative,
    Where,
)

OTHER = "other"


@dataclass(frozen=True, slots=True)
class _People:
    """Several people who get the same; ``each`` is whether it was said that each gets one."""

    all: tuple[Nominal, ...]
    each: bool


@dataclass(frozen=True, slots=True)
class _Share:
    """One of several things, for somebody; ``last`` is whether it was called another or the other one."""

    person: Nominal
    last: bool


@dataclass(frozen=True, slots=True)
class _PlacedShare:
    """One of several things, and where it is or goes; ``last`` as in ``_Share``."""

    where: Where
    last: bool


def _left(parts: Parts) -> Nominal | None:
    """What is told from what was named before without its noun: "the smallest", "another"."""
    if any(word.said != "the" for word in words(parts, "DET")):
        return None
    of = described(Nominal("any", anaphoric=True, determined=True), parts)
    return of if isinstance(of, Nominal) else None


def _told(parts: Parts) -> Feature | Relative | None:
    (word,) = parts
    return feature_of(word)


def _people(parts: Parts) -> _People | None:
    people = tuple(part for part in parts if isinstance(part, Nominal))
    named = all(one.is_person and one.is_single and not one.reference for one in people)
    if not named or len(set(people)) < len(people):
        return None
    return _People(people, bool(words(parts, "BOTH", "EVERY")))


def _share(parts: Parts) -> _Share | None:
    of, person = (part for part in parts if isinstance(part, Nominal))
    if not _is_one_of_them(of) or not person.is_person:
        return None
    return _Share(person, of.ordinal == OTHER)


def _is_one_of_them(of: Nominal) -> bool:
    """Whether it is "one", "another" or "the other"."""
    bare = of.anaphoric and not of.plural and replace(of, ordinal=None).is_plain
    return bare and of.ordinal in (None, OTHER)


def _placed_share(parts: Parts) -> _PlacedShare | None:
    (of,) = (part for part in parts if isinstance(part, Nominal))
    (where,) = (part for part in parts if isinstance(part, Where))
    return _PlacedShare(where, of.ordinal == OTHER) if _is_one_of_them(of) else None


def _handing(parts: Parts) -> Callable[[Arranged, Nominal], Bundle]:
    if words(parts, "GIVE"):
        return given
    return lambda one, person: handed(picked(one, fetched=True), person)


def _given_out(parts: Parts, one: Arranged, people: tuple[Nominal, ...]) -> Clause:
    """One thing for each; those after the first are others."""
    if one.goal is not None or one.person is not None or one.back:
        raise unfit()
    if one.object.sort != "thing" or (one.object.ordinal is not None and len(people) > 1):
        raise unfit()
    others = replace(one, object=replace(one.object, ordinal=OTHER, indefinite=False))
    each = _handing(parts)
    return clause(parts, [each(others if index else one, person) for index, person in enumerate(people)])


def _shared(parts: Parts) -> Clause:
    """A can each for Ana and Ben."""
    (people,) = (part for part in parts if isinstance(part, _People))
    (one,) = arranged(parts)
    each = people.each or bool(words(parts, "EACH_ONE"))
    names = " and ".join(str(person.kind) for person in people.all)
    if not each:
        raise trouble(f"is it one for each of {names}, or one for both?", asks=True)
    single = one.object.indefinite or (one.object.counted and one.object.count == 1)
    if not single or one.object.plural:
        raise trouble(f"which one for each of {names}? say it for one after the other", asks=True)
    return _given_out(parts, one, people.all)


def _shares(parts: Parts) -> Clause:
    """Two cans, one for me and one for Bob."""
    (item,) = (part for part in parts if isinstance(part, Item))
    shares = [part for part in parts if isinstance(part, _Share)]
    (one,) = arranged((item,))
    number = 2 if one.object.count == "both" else one.object.count
    if number != len(shares) or any(share.last for share in shares[:-1]):
        raise trouble("who gets which of them?", asks=True)
    people = tuple(share.person for share in shares)
    if len(set(people)) < len(people):
        raise trouble("who gets which of them?", asks=True)
    single = replace(one.object, count=1, counted=False, plural=False)
    return _given_out(parts, replace(one, object=single), people)


def _placed_apart(parts: Parts) -> Any:
    """Two cups, one on the table and one on the shelf."""
    verb = words(parts, "PICK_UP", "PICK", "FETCH", "PUT", "PUT_IN")[0]
    (of,) = (part for part in parts if isinstance(part, Nominal))
    shares = [part for part in parts if isinstance(part, _PlacedShare)]
    number = 2 if of.count == "both" else of.count
    single = of.sort == "thing" and of.ordinal is None and number == len(shares) == 2
    if not single or any(share.last for share in shares[:-1]):
        raise trouble("which of them is where?", asks=True)
    first = replace(of, count=1, counted=False, plural=False)
    each = (first, replace(first, ordinal=OTHER))
    items = Items(tuple(Item(one, (share.where,)) for one, share in zip(each, shares, strict=True)))
    name = {"PUT": "put", "PUT_IN": "put_into", "FETCH": "fetch"}.get(verb.word_class, "pick")
    return {**PLACING, **HANDLING}[name]((verb, items))


def _leftover(parts: Parts) -> Item:
    return Item(parts[0], tuple(parts[1:]))


_COMMANDS: Mapping[str, Callable[[Parts], Any]] = {
    "shared": _shared,
    "shares": _shares,
    "placed_apart": _placed_apart,
}

MEANINGS: Mapping[str, Meaning] = MappingProxyType(
    {
        "left_over": _left,
        "told": _told,
        "leftover": _leftover,
        "people": _people,
        "share": _share,
        "placed_share": _placed_share,
        **{name: guarded(meaning) for name, meaning in _COMMANDS.items()},
    }
)
