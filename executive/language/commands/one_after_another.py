"""Things that the same is done to one after the other: "first the cup and then the plate"."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Any

from executive.language.commands.going import MEANINGS as GOING
from executive.language.commands.placing import MEANINGS as PLACING
from executive.language.noun_phrases.arranging import guarded, unfit
from executive.language.noun_phrases.lists import MEANINGS as LISTS
from executive.language.noun_phrases.lists import Joined
from executive.language.noun_phrases.pairs import MEANINGS as PAIRS
from executive.language.phrase_parts import Parts, words
from executive.language.phrases import Item, Items, Meaning, Nominal, Pair, Where
from executive.language.words.word import Word

_LATER = Joined(commas=False, then=True)


def _later(parts: Parts) -> Any:
    """What comes next; no full stop parts it from what is before it."""
    if any(mark.meaning != "," for mark in words(parts, "PAUSE")):
        raise unfit()
    return parts[-1]


def _items_of(parts: Parts) -> list[Item]:
    return [part for part in parts if isinstance(part, Item)]


def _first_items(parts: Parts) -> Any:
    """First the cup and then the plate: a list in which all are named in their order."""
    first, *others = _items_of(parts)
    return LISTS["items"]((first, *(one for other in others for one in (_LATER, other))))


def _walk_first(parts: Parts) -> Any:
    """Walk to the table first and after that to the shelf."""
    first, *others = (part for part in parts if not isinstance(part, Word))
    return GOING["walk"]((parts[0], first, *(one for other in others for one in (_LATER, other))))


def _for_one(name: str) -> Callable[[Parts], Any]:
    """Bring me first the cup and then the plate: both for the same person."""

    def meaning(parts: Parts) -> Any:
        person = next(part for part in parts if isinstance(part, Nominal))
        first, *others = _items_of(parts)
        if not person.is_person or any(one.of.is_person or one.details for one in (first, *others)):
            raise unfit()
        return PAIRS[name]((parts[0], Pair(person, first), *others))

    return meaning


def _put_then(parts: Parts) -> Any:
    """Put the cup on the table, then the plate: each of them there.

    Beside or on other things, which could be what is meant next, nothing is put so.
    """
    first, *others = _items_of(parts)
    if len(first.details) != 1 or not isinstance(first.details[0], Where):
        raise unfit()
    where = first.details[0]
    clear = where.preposition in ("on", "in") and where.role != "from" and where.of.is_place
    if not clear or where.of.sort == "door" or where.of.reference or where.of.anaphoric:
        raise unfit()
    for other in others:
        of = other.of
        if other.details or other.too or of.sort != "thing" or not of.determined or of.reference:
            raise unfit()
    each = tuple(Item(one.of, first.details) for one in (first, *others))
    name = "put_into" if words(parts, "PUT_IN") else "put"
    return PLACING[name]((parts[0], Items(each)))


_COMMANDS: Mapping[str, Callable[[Parts], Any]] = {
    "later_item": _later,
    "later_toward": _later,
    "first_items": _first_items,
    "walk_first": _walk_first,
    "bring_first": _for_one("bring_pairs"),
    "give_first": _for_one("give_pairs"),
    "put_then": _put_then,
}

MEANINGS: Mapping[str, Meaning] = MappingProxyType(
    {name: guarded(meaning) for name, meaning in _COMMANDS.items()}
)
