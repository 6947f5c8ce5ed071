"""Waving at people, looking and pointing at what is named."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from types import MappingProxyType
from typing import Any

from executive.language.commands.going import target
from executive.language.phrases.arranging import clause, guarded, trouble, unfit
from executive.language.phrases.handled_thing import IT
from executive.language.phrases.parts import Parts, words
from executive.language.phrases.values import (
    Bundle,
    Clause,
    Hand,
    Item,
    Items,
    Meaning,
    Nominal,
    Sort,
    Where,
    draft,
)
from executive.vocabulary.inflection import plural

_AIMS = frozenset({"point", "pointing", "pointed"})
"""Verbs that say of a thing where it is to point, if they say that it points at anything."""

_INTO = frozenset({"in", "into", "inside"})


def _side(parts: Parts) -> str | None:
    hands = [part.side for part in parts if isinstance(part, Hand)]
    if len(set(hands)) > 1:
        raise unfit()
    return hands[0] if hands else None


def _person(nominal: Nominal, doing: str) -> Nominal:
    if not nominal.is_person and nominal.reference not in ("it", "them"):
        raise trouble(f"{doing} {nominal.kind or 'a thing'}: only a person can be meant", nominal.kind)
    if nominal.reference == "it":
        raise trouble("who is meant?", asks=True)
    return nominal


def _each_somebody_else(items: Sequence[Item]) -> None:
    """Ask who "her" is beside somebody who is named: "wave to Ana and her" is not about Ana twice."""
    him = [item.of.reference in ("him", "them") for item in items]
    if any(him) and any(item.of.is_person and not item.of.reference for item in items):
        raise trouble("who is meant?", asks=True)


def _wave(parts: Parts) -> Clause:
    each = [part for part in parts if isinstance(part, Items)]
    hand = _side(parts)
    bundles: list[Bundle] = []
    _each_somebody_else(each[0].each if each else ())
    for item in each[0].each if each else ():
        side = next((one.side for one in item.details if isinstance(one, Hand)), hand)
        bare = Item(item.of, tuple(one for one in item.details if not isinstance(one, Hand)))
        bundles.append((draft("wave", person=_person(target(bare), "waving at"), hand=side),))
    bundles += [
        (draft("wave", person=_person(part, "waving at"), hand=hand),)
        for part in parts
        if isinstance(part, Nominal)
    ]
    return clause(parts, bundles or [(draft("wave", hand=hand),)])


def _wave_hand(parts: Parts) -> Clause:
    side = words(parts, "LEFT_RIGHT")[0].meaning
    return _wave((*parts, Hand(side)))


def _attend(action: str) -> Callable[[Parts], Clause]:
    def meaning(parts: Parts) -> Clause:
        sides = words(parts, "LEFT_RIGHT")
        hand = sides[0].meaning if sides else _side(parts)
        bundles: list[Bundle] = []
        (items,) = (part for part in parts if isinstance(part, Items))
        _each_somebody_else(items.each)
        if any(word.said in _AIMS for word in words(parts, "POINT_AT")) and _is_aimed(items):
            raise unfit()
        for item in items.each:
            side = next((one.side for one in item.details if isinstance(one, Hand)), hand)
            if side is not None and action == "look_at":
                raise unfit()
            nominal = target(Item(item.of, tuple(one for one in item.details if not isinstance(one, Hand))))
            slot = "person" if nominal.is_person else "to" if nominal.is_place else "object"
            looks_in = any(_INTO & set(word.said.split()) for word in words(parts, "LOOK_AT"))
            if looks_in and nominal.anaphoric:
                raise trouble("which one is meant?", asks=True)  # "take the pen, then look in the right one"
            looks_in = looks_in and nominal.sort == "container"
            bundles.append((draft(action, **{slot: nominal}, hand=side, looks_in=looks_in or None),))
        return clause(parts, bundles)

    return meaning


def _show_where(parts: Parts) -> Clause:
    """Show me where the cup is: which one of several is asked."""
    each = [item.of for part in parts if isinstance(part, Items) for item in part.each]
    several = next((one for one in each if one.plural and one.kind and not one.reference), None)
    if several is not None:
        raise trouble(f"which one of the {plural(several.kind or 'thing')}?", asks=True)
    return _attend("point_at")(parts)


def _watch(parts: Parts) -> Clause:
    """Watch Ana: she is looked at."""
    (word,) = words(parts, "NAME", "ME")
    sort: Sort = "me" if word.word_class == "ME" else "name"
    return clause(
        parts, [(draft("look_at", person=Nominal(sort, word.meaning, determined=True), watches=True),)]
    )


def _watch_over(parts: Parts) -> Clause:
    verb = words(parts, "WATCH")[0].said
    raise trouble(f"{verb!r}: this robot looks at somebody once, and watches over nobody and nothing", verb)


def _is_aimed(items: Items) -> bool:
    """Whether a thing is to be turned towards another: "point the lamp at the table"."""
    details = (one for item in items.each for one in item.details)
    return any(isinstance(one, Where) and (one.preposition == "at" or one.role == "to") for one in details)


def _look_inside(parts: Parts) -> Clause:
    return clause(parts, [(draft("look_at", object=IT, inside=True),)])


def _look_around(_parts: Parts) -> Clause:
    raise trouble("what shall be looked at?", asks=True)


_COMMANDS: Mapping[str, Callable[[Parts], Any]] = {
    "wave": _wave,
    "wave_hand": _wave_hand,
    "point": _attend("point_at"),
    "point_hand": _attend("point_at"),
    "show_where": _show_where,
    "look": _attend("look_at"),
    "look_inside": _look_inside,
    "look_around": _look_around,
    "watch": _watch,
    "watch_over": _watch_over,
}

MEANINGS: Mapping[str, Meaning] = MappingProxyType(
    {name: guarded(meaning) for name, meaning in _COMMANDS.items()}
)
