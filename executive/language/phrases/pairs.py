"""A thing for somebody, in one breath: "Ana the cup", "Ana her cup", "us the biscuits"."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from types import MappingProxyType
from typing import Any

from executive.language.commands.handling import given, handed, picked, recipient
from executive.language.phrases.arranging import ME, Arranged, arranged, clause, guarded, trouble, unfit
from executive.language.phrases.lists import (
    is_told_beside,
    said_again,
    said_twice,
    served_with,
    shared_adjective,
)
from executive.language.phrases.parts import Parts, words
from executive.language.phrases.values import Clause, Item, Meaning, Nominal, Pair, Trouble
from executive.language.resolve.people import may_be
from executive.language.text.word import Word


def _us(_parts: Parts) -> Nominal:
    """Who asks, where something is handed over; nobody else is waved to, looked at or gone to."""
    return ME


def _pair(parts: Parts) -> Pair | None:
    person, item = (part for part in parts if not isinstance(part, Word))
    if (
        not isinstance(person, Nominal)
        or not (person.is_person or person.reference == "them")
        or item.of.is_person
    ):
        return None
    return Pair(person, item)


def _pair_for_us(parts: Parts) -> Pair | Trouble | None:
    """A thing for whoever speaks for several: "us the biscuits", but not "us both a beer"."""
    item = next(part for part in parts if isinstance(part, Item))
    if item.of.counted and item.of.count in ("both", "all"):
        return Trouble("one for each of you, or all of them?", asks=True)
    return _pair(parts)


def _own_pair(parts: Parts) -> Pair | Trouble | None:
    """A thing for whom it belongs to: "Ana her cup"."""
    (owns,) = words(parts, "WHOSE")
    made = _pair(tuple(part for part in parts if part is not owns))
    if made is None:
        return None
    of = made.item.of
    if of.determined or of.reference or of.anaphoric or of.kind is None or of.name is not None:
        return None
    known = made.person.sort in ("name", "person") and not made.person.reference
    if not known or not may_be("him" if owns.meaning == "his" else owns.meaning, made.person):
        return Trouble(f"{owns.said!r}: whose it is cannot be told", owns.said)
    if of.kind in ("glass", "glasses"):
        if not of.plural:
            return None
        of = replace(of, kind="glasses", plural=False, paired=True)  # those to see with
    name = f"{made.person.said or made.person.kind}'s {of.kind}"
    own = replace(of, name=name, determined=True, owner=made.person)
    return Pair(made.person, replace(made.item, of=own))


def _has_pair(parts: Sequence[Any]) -> bool:
    return any(isinstance(part, Pair) for part in parts)


def _pairs(parts: Parts) -> list[tuple[Nominal, Arranged]]:
    """Who gets what; further things are for who was named before: "me the cup and the can, Ana the box"."""
    each: list[tuple[Nominal, list[Item]]] = []
    for part in parts:
        if isinstance(part, Pair):
            each.append((part.person, [part.item]))
        elif isinstance(part, Item):
            each[-1][1].append(part)
    if any(person.reference == "him" for person, _ in each[1:]):
        raise trouble("who is meant?", asks=True)  # "give Ben the cup and her the bottle": not Ben
    for _, items in each:
        if len(items) > 1:
            unclear = said_again(items[-2].of, items[-1].of, parts) or shared_adjective(items)
            unclear = unclear or served_with(items)
            for first, second in itertools.pairwise(items):
                before = parts.index(second)  # "me the cup, the red one and the bowl"
                unclear = unclear or said_again(first.of, second.of, parts[before - 1 : before])
            unclear = unclear or (said_twice(items, parts) if len(each) == 1 else None)
            if unclear is not None:
                raise trouble(unclear.message, asks=True)
    every = [item.of for _, items in each for item in items]
    if not all(map(is_told_beside, every, every[1:])):
        raise unfit()
    result = [_for_whom(person, one) for person, items in each for one in _arranged_apart(items)]
    if any(one.goal is not None or (one.person is not None and one.person.sort != "me") for _, one in result):
        raise unfit()
    return result


def _arranged_apart(items: Sequence[Item]) -> Iterator[Arranged]:
    """Things that go together; where another one goes says nothing of those before it."""
    together = [item for item in items if not (_is_another(item.of) and item.details)]
    yield from arranged(tuple(together)) if together else ()
    for item in items:
        if item not in together:
            yield from arranged((item,))


def _is_another(of: Nominal) -> bool:
    return of.anaphoric and (of.ordinal == "other" or not of.said)


def _for_whom(person: Nominal, one: Arranged) -> tuple[Nominal, Arranged]:
    """Who gets a thing; another one of the same may be for somebody else: "me a cup and another for Ana"."""
    goes = one.goal is not None and one.goal.relation is None and one.goal.preposition == "to"
    other = one.goal.of if one.goal is not None and goes else one.person
    if _is_another(one.object) and other is not None:
        return recipient(other), replace(one, goal=None, person=None)
    return recipient(person), one


def _bring_pairs(parts: Parts) -> Clause:
    return clause(
        parts,
        [handed(picked(one, fetched=True), person) for person, one in _pairs(parts)],
    )


def _give_pairs(parts: Parts) -> Clause:
    return clause(parts, [given(one, person) for person, one in _pairs(parts)])


def _each_gets(parts: Parts) -> Clause:
    """Mia gets the red cup and Ben the blue one: of one alone it may tell what she does."""
    person = next(part for part in parts if isinstance(part, Nominal))
    item = next(part for part in parts if isinstance(part, Item))
    pairs = [part for part in parts if isinstance(part, Pair)]
    first = _pair((person, item))
    everyone = [one.person for one in (first, *pairs) if one is not None]
    details = any(one.item.details for one in (first, *pairs) if one is not None)
    if first is None or details or len(set(everyone)) < len(pairs) + 1 or any(map(_is_open, everyone)):
        raise unfit()
    return clause((), [given(one, whom) for whom, one in _pairs((first, *pairs))])


def _is_open(person: Nominal) -> bool:
    """Whether it is left to what was said before who is meant."""
    return person.reference is not None or not person.is_single


_COMMANDS: Mapping[str, Callable[[Parts], Any]] = {
    "bring_pairs": _bring_pairs,
    "give_pairs": _give_pairs,
    "each_gets": _each_gets,
}

MEANINGS: Mapping[str, Meaning] = MappingProxyType(
    {
        "us": _us,
        "pair": _pair,
        "pair_for_us": _pair_for_us,
        "own_pair": _own_pair,
        **{name: guarded(meaning) for name, meaning in _COMMANDS.items()},
    }
)
