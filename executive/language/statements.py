"""What is stated beside commands: where a thing is, that something is open, why something is asked for."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from types import MappingProxyType
from typing import Any

from executive.language.arranging import arranged, guarded, trouble, unfit
from executive.language.lattice import Word
from executive.language.phrase_parts import Parts, words
from executive.language.phrases import Clause, Item, Meaning, Mention, Nominal, Where
from executive.language.placing import one_at_a_time
from executive.language.scopes import Further


def _mention(parts: Parts) -> Clause:
    """A statement of where a thing is, or somebody."""
    (item,) = (part for part in parts if isinstance(part, Item))
    came = bool(words(parts, "CAME_TO_BE"))
    places = [_stays(part, came=came) for part in parts if isinstance(part, Where)]
    if places and item.of.sort in ("person", "name"):
        return _mention_of_somebody(item, places)
    (one,) = arranged((item, *places))
    nominal = one.object
    if one.goal is not None or one.back or one.hand is not None or one.person is not None:
        raise unfit()
    placed = one.source is not None or nominal.relation is not None
    if nominal.sort != "thing" or nominal.reference or not placed or nominal.anaphoric:
        raise unfit()
    if nominal.is_vague or (nominal.plural and not nominal.counted):
        nominal = replace(nominal, count="all")
    return Clause((), "base", mention=Mention(nominal, one.source))


def _stays(where: Where, *, came: bool) -> Where:
    """Where something is: what "fell onto the floor" is on it, what "is off the table" is elsewhere."""
    if where.role == "from":
        raise unfit()
    return replace(where, role="is") if came and where.role == "to" else where


def _mention_of_somebody(item: Item, places: Sequence[Where]) -> Clause:
    """A statement of where somebody is: "Ana is in the kitchen; take her the cup"."""
    if item.details or len(places) > 1 or places[0].role == "to":
        raise unfit()
    somebody = item.of
    if somebody.sort == "person":  # of a name the place is no part
        (one,) = arranged((item, *places), has_source=False)
        somebody = one.object
    return Clause((), "base", about=(somebody, places[0].of))


def _mention_how(parts: Parts) -> Clause:
    """A statement of how somebody is, or a thing: "Grandma is cold", "the plate is dirty"."""
    if words(parts, "SPEAKER_IS"):
        return Clause((), "base", about=(_stays(parts[-1], came=False).of,))
    wished = {"should", "must"} & {one for word in words(parts, "IS_AT") for one in word.said.split()}
    (nominal,) = (part for part in parts if isinstance(part, Nominal))
    if wished or nominal.reference or nominal.anaphoric or nominal.sort in ("me", "you"):
        raise unfit()
    if nominal.sort in ("thing", "any"):
        return _named(nominal)
    return Clause((), "base", about=(nominal,))


def _named(nominal: Nominal, source: Nominal | None = None) -> Clause:
    """A statement that the next task takes its thing from."""
    if nominal.is_vague or (nominal.plural and not nominal.determined and not nominal.counted):
        raise unfit()
    if nominal.plural and not nominal.counted:
        nominal = replace(nominal, count="all")
    return Clause((), "base", mention=Mention(nominal, source))


def _mention_lost(parts: Parts) -> Clause:
    """A statement that something was lost or dropped, which "find it" or "pick it up" follows up."""
    (item,) = (part for part in parts if isinstance(part, Item))
    people = tuple(part for part in parts if isinstance(part, Nominal))
    if not all(one.sort in ("person", "name") and one.is_single and not one.reference for one in people):
        raise unfit()
    (one,) = arranged((item,))
    nominal = one.object
    if one.goal is not None or one.back or one.hand is not None or one.person is not None:
        raise unfit()
    if item.details and any(map(_is_nowhere, words(parts, "LOST", "LOSES", "LOST_WHERE"))):
        raise unfit()  # where it is, or where it is not?
    if nominal.sort != "thing" or nominal.reference or nominal.anaphoric:
        raise unfit()
    return replace(_named(nominal, one.source), about=people)


def _is_nowhere(word: Word) -> bool:
    """Whether it says that nobody knows where something is."""
    return word.meaning == "nowhere" or "find" in word.said.split()


def _mention_wanted(parts: Parts) -> Clause:
    """A statement that a thing is needed, which "bring it to me" follows up."""
    (item,) = (part for part in parts if isinstance(part, Item))
    (one,) = arranged((item,))
    nominal = one.object
    if one.goal is not None or one.back or one.hand is not None or one.person is not None:
        raise unfit()
    if nominal.sort != "thing" or nominal.reference or nominal.anaphoric:
        raise unfit()
    return _named(nominal, one.source)


def _mention_for(parts: Parts) -> Clause:
    """A statement of who is to get a thing: "the red cup is for Mia, bring it to her"."""
    of, person = (part for part in parts if isinstance(part, Nominal))
    said = [word.said for word in words(parts, "IS_AT", "FOR")]
    is_now = said in (["is", "for"], ["are", "for"]) or bool(words(parts, "BELONGS_TO"))
    somebody = person.sort in ("name", "person") and person.is_single and not person.reference
    if not is_now or not somebody or of.sort != "thing" or of.reference or of.anaphoric or not of.determined:
        raise unfit()
    told = _named(of)
    stated = None if told.mention is None else replace(told.mention, meant_for=person)
    return replace(told, mention=stated, about=(person,))


def _mention_belongs(parts: Parts) -> Clause:
    """A statement of where a thing has its place, which is "there" after it: "... put them there"."""
    (item,) = (part for part in parts if isinstance(part, Item))
    place: Where = parts[-1]
    (one,) = arranged((item,))
    nominal = one.object
    if one.goal is not None or one.back or one.hand is not None or one.person is not None:
        raise unfit()
    if nominal.sort != "thing" or nominal.reference or nominal.anaphoric:
        raise unfit()
    if place.role != "either" or place.relation is not None or place.of.reference or place.of.is_person:
        raise unfit()
    return replace(_named(nominal, one.source), about=(place.of,))


def _mention_state(parts: Parts) -> Clause:
    """A statement that something is open or closed, or has to be, which only one thing follows from."""
    (item,) = (part for part in parts if isinstance(part, Item))
    nominal = item.of
    is_door = nominal.sort in ("container", "door") and nominal.determined
    if not is_door or item.details or nominal.reference or nominal.anaphoric:
        raise unfit()
    said = {one for word in words(parts, "IS_AT") for one in word.said.split()}
    wished = bool(words(parts, "SHALL_BE")) or not said.isdisjoint(("should", "must"))
    is_open = bool(words(parts, "OPENED")) != wished  # what should be closed is taken to be open
    if not nominal.is_single:
        raise trouble(one_at_a_time("close" if is_open else "open"), nominal.kind)
    return Clause((), "base", mention=Mention(nominal, state="open" if is_open else "closed"))


def _located_after(parts: Parts) -> Where:
    where: Where = parts[-1]
    return where


def is_statement(part: Any) -> bool:
    """Whether it says something and commands nothing."""
    return isinstance(part, Clause) and not part.bundles


def with_places(parts: Parts) -> Parts | None:
    """With what is said after a command of where its thing is: "bring me the book, it's on the shelf".

    None where a command has no thing that alone can be meant.
    """
    found: list[Any] = []
    for part in parts:
        if not isinstance(part, Where):
            found.append(part)
            continue
        before = found.pop()
        of = before.part if isinstance(before, Further) else before
        placed = _PLACED((of, part)) if isinstance(of, Clause) else None
        if not isinstance(placed, Clause):
            return None
        found.append(replace(before, part=placed) if isinstance(before, Further) else placed)
    return tuple(found)


_LOCATED = frozenset({"pick", "hand_over", "find"})
"""Tasks of a thing that may have a place."""


def _placed(parts: Parts) -> Clause:
    """A command with where its only thing is, unless it names another that may be meant."""
    command, where = parts
    if len(command.bundles) != 1 or where.role in ("to", "from"):
        raise unfit()
    first, *rest = command.bundles[0]
    named = first.get("object")
    goals = [value for one in (first, *rest) for name, value in one.slots if name in ("to", "on", "there")]
    if first.action not in _LOCATED or not all(isinstance(one, Nominal) and one.is_person for one in goals):
        raise unfit()
    if not isinstance(named, Nominal) or named.reference or first.get("source") or named.relation:
        raise unfit()
    (one,) = arranged((Item(named, (where,)),))
    slots = tuple((name, one.object if name == "object" else value) for name, value in first.slots)
    told = replace(first, slots=slots).with_slot("source", one.source)
    placed: Clause = replace(command, bundles=((told, *rest),))
    return placed


_PLACED = guarded(_placed)

_COMMANDS: Mapping[str, Callable[[Parts], Any]] = {
    "mention": _mention,
    "mention_how": _mention_how,
    "mention_for": _mention_for,
    "mention_belongs": _mention_belongs,
    "mention_lost": _mention_lost,
    "mention_state": _mention_state,
    "mention_wanted": _mention_wanted,
    "located_after": _located_after,
}

MEANINGS: Mapping[str, Meaning] = MappingProxyType(
    {name: guarded(meaning) for name, meaning in _COMMANDS.items()}
)
