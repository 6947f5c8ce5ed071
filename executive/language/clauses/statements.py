"""What is stated beside commands: where a thing is, that something is open, why something is asked for.

A statement names what "it", "her" and "there" stand for after it; a reason behind a command names nothing.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import Any

from executive.language.phrases.arranging import arranged, guarded, unfit
from executive.language.phrases.parts import Parts, words
from executive.language.phrases.values import Clause, Item, Meaning, Mention, Nominal, Trouble, Where

WISHED, NOWHERE, OTHERS = "wished", "nowhere", "others"
"""Meanings of words: how something is to be, that nobody knows where it is, and people who are not named."""

_EXISTS = frozenset({"thing", "container", "door"})


@dataclass(frozen=True, slots=True)
class Reason:
    """Why a command was given, and whether that is because of somebody who is not named."""

    of_another: bool = False


def _reason(parts: Parts) -> Reason:
    return Reason(any(word.meaning == OTHERS for word in words(parts, "SPEAKER_IS", "SOMEBODY")))


def _reason_after(parts: Parts) -> Any:
    """The reason behind a command, which a mark or "because" parts from it."""
    return parts[-1] if len(parts) > 1 else None


def named_thing(
    item: Item, places: Sequence[Where] = (), *, sorts: AbstractSet[str] = frozenset({"thing"})
) -> Mention:
    """What is named for the command beside it, which may be of some sorts, and where it is said to be."""
    (one,) = arranged((item, *places))
    of = one.object
    moved = one.goal is not None or one.back or one.hand is not None or one.person is not None
    if moved or of.sort not in sorts or of.reference or of.anaphoric:
        raise unfit()
    if of.sort != "thing" and one.source is not None:
        raise unfit()
    if not places and (of.is_vague or (of.plural and not of.determined and not of.counted)):
        raise unfit()  # "I dropped some cups"
    if of.is_vague or (of.plural and not of.counted):
        of = replace(of, count="all")
    return Mention(of, one.source)


def _stated(mention: Mention | None = None, about: tuple[Nominal, ...] = ()) -> Clause:
    return Clause((), "base", mention=mention, about=about)


def _mention(parts: Parts) -> Clause:
    """A statement of where a thing is, or somebody; or that it is there at all."""
    (item,) = (part for part in parts if isinstance(part, Item))
    places = [_stays(part) for part in parts if isinstance(part, Where)]
    if places and item.of.sort in ("person", "name"):
        return _mention_of_somebody(item, places)
    inner = [detail for detail in item.details if isinstance(detail, Where)]
    mention = named_thing(replace(item, details=()), (*inner, *places), sorts=_EXISTS)
    exists = mention.source is None and mention.of.relation is None
    if len(inner) < len(item.details) or (exists and mention.of.is_vague):
        raise unfit()
    return _stated(replace(mention, exists=exists))


def _stays(where: Where) -> Where:
    """Where something is; what "is off the table" is elsewhere."""
    if where.role == "from":
        raise unfit()
    return where


def _mention_of_somebody(item: Item, places: Sequence[Where]) -> Clause:
    """A statement of where somebody is: "Ana is in the kitchen; take her the cup"."""
    if item.details or len(places) > 1 or places[0].role == "to":
        raise unfit()
    somebody = item.of
    if somebody.sort == "person":  # of a name the place is no part
        (one,) = arranged((item, *places), has_source=False)
        somebody = one.object
    return _stated(about=(somebody, places[0].of))


def _mention_how(parts: Parts) -> Clause:
    """A statement of how somebody is, or a thing: "Grandma is cold", "the plate is dirty"."""
    if words(parts, "SPEAKER_IS"):
        return _stated(about=(_stays(parts[-1]).of,))
    (nominal,) = (part for part in parts if isinstance(part, Nominal))
    wished = any(word.meaning == WISHED for word in words(parts, "IS_AT"))
    if wished or nominal.reference or nominal.anaphoric or nominal.sort in ("me", "you"):
        raise unfit()
    if nominal.sort in ("thing", "any"):
        return _stated(named_thing(Item(nominal), sorts=frozenset({"thing", "any"})))
    return _stated(about=(nominal,))


def _mention_wanted(parts: Parts) -> Clause:
    """A statement that somebody lost or needs a thing, which "find it" or "bring it to her" follows up."""
    (item,) = (part for part in parts if isinstance(part, Item))
    people = tuple(part for part in parts if isinstance(part, Nominal))
    if not all(one.sort in ("person", "name") and one.is_single and not one.reference for one in people):
        raise unfit()
    said = words(parts, "LOST", "LOSES", "LOST_WHERE")
    if item.details and any(word.meaning == NOWHERE for word in said):
        raise unfit()  # where it is, or where it is not?
    return _stated(named_thing(item), people)


def _mention_state(parts: Parts) -> Clause:
    """A statement that something is open or closed, which only one thing follows from."""
    (item,) = (part for part in parts if isinstance(part, Item))
    wished = any(word.meaning == WISHED for word in words(parts, "IS_AT"))
    if wished or item.details or not item.of.determined or not item.of.is_single:
        raise unfit()
    mention = named_thing(item, sorts=_EXISTS - {"thing"})
    return _stated(replace(mention, state="open" if words(parts, "OPENED") else "closed"))


def _warned(_parts: Parts) -> Trouble:
    """A warning before a statement: "careful, the cup is hot. Pick it up"."""
    return Trouble("that is a warning: shall it be done all the same?", asks=True, rivals=True)


def is_statement(part: Any) -> bool:
    """Whether it says something and commands nothing."""
    return isinstance(part, Clause) and not part.bundles


MEANINGS: Mapping[str, Meaning] = MappingProxyType(
    {
        "reason": _reason,
        "reason_after": _reason_after,
        "mention": guarded(_mention),
        "mention_how": guarded(_mention_how),
        "mention_wanted": guarded(_mention_wanted),
        "mention_state": guarded(_mention_state),
        "warned": _warned,
    }
)
