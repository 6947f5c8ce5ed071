"""What is stated beside commands: where a thing is, that something is open, why something is asked for."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from types import MappingProxyType
from typing import Any

from executive.language.commands.placing import one_at_a_time
from executive.language.phrases.arranging import arranged, guarded, trouble, unfit
from executive.language.phrases.parts import Parts, words
from executive.language.phrases.values import Clause, Item, Meaning, Mention, Nominal, Where
from executive.language.text.word import Word

_EXISTS = frozenset({"thing", "container", "door"})
"""Sorts of what a statement names for a task: "there are two doors, close the left one"."""


def _mention(parts: Parts) -> Clause:
    """A statement of where a thing is, or somebody; or that it is there at all."""
    (item,) = (part for part in parts if isinstance(part, Item))
    came = bool(words(parts, "CAME_TO_BE"))
    places = [_stays(part, came=came) for part in parts if isinstance(part, Where)]
    if places and item.of.sort in ("person", "name"):
        return _mention_of_somebody(item, places)
    (one,) = arranged((item, *places))
    nominal = one.object
    if one.goal is not None or one.back or one.hand is not None or one.person is not None:
        raise unfit()
    if nominal.sort not in _EXISTS or nominal.reference or nominal.anaphoric:
        raise unfit()
    if nominal.sort != "thing" and one.source is not None:
        raise unfit()
    exists = one.source is None and nominal.relation is None
    if exists and nominal.is_vague:
        raise unfit()  # "I dropped some cups"
    if nominal.is_vague or (nominal.plural and not nominal.counted):
        nominal = replace(nominal, count="all")
    return Clause((), "base", mention=Mention(nominal, one.source, exists=exists))


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


def _mention_who(parts: Parts) -> Clause:
    """A statement of who somebody is: "my sister is Lena. Give her the umbrella"."""
    is_now = words(parts, "IS_AT")[0].said == "is"
    both = [part for part in parts if isinstance(part, Nominal)]
    names = [one for one in both if one.sort == "name"]
    others = [one for one in both if one.sort == "person" or one.reference == "this"]
    if not is_now or len(names) != 1 or len(others) != 1:
        raise unfit()
    (other,) = others
    if other.reference != "this" and not (other.determined and other.is_single and not other.reference):
        raise unfit()
    return Clause((), "base", about=(names[0],))


def _mention_name(parts: Parts) -> Clause:
    """A statement of what somebody is called: "her name is Lena"."""
    (name,) = words(parts, "NAME")
    return Clause((), "base", about=(Nominal("name", name.meaning, determined=True),))


def _mention_either(parts: Parts) -> Clause:
    """A statement of two places where a thing may be: it is looked for wherever it can be."""
    (item,) = (part for part in parts if isinstance(part, Item))
    if item.details or item.of.sort != "thing" or item.of.reference or item.of.anaphoric:
        raise unfit()
    if any(_stays(part, came=False).role == "to" for part in parts if isinstance(part, Where)):
        raise unfit()
    return _named(item.of)


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


def is_statement(part: Any) -> bool:
    """Whether it says something and commands nothing."""
    return isinstance(part, Clause) and not part.bundles


_COMMANDS: Mapping[str, Callable[[Parts], Any]] = {
    "mention": _mention,
    "mention_how": _mention_how,
    "mention_for": _mention_for,
    "mention_belongs": _mention_belongs,
    "mention_lost": _mention_lost,
    "mention_either": _mention_either,
    "mention_name": _mention_name,
    "mention_who": _mention_who,
    "mention_state": _mention_state,
    "mention_wanted": _mention_wanted,
}

MEANINGS: Mapping[str, Meaning] = MappingProxyType(
    {name: guarded(meaning) for name, meaning in _COMMANDS.items()}
)
