"""What is said of where things are and go, and which hand is used."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from executive.language.phrases.handled_thing import BIN
from executive.language.phrases.parts import Parts, always, words
from executive.language.phrases.values import (
    Benefit,
    Hand,
    Meaning,
    Nominal,
    Preposition,
    Relative,
    Role,
    Trouble,
    Where,
    relation_kind,
)
from executive.language.text.word import Word
from trees.tasks import RelationKind

_PLACES: Mapping[str, tuple[Role, Preposition]] = {
    "ON": ("either", "on"),
    "ONTO": ("to", "on"),
    "IN": ("either", "in"),
    "INTO": ("to", "in"),
    "AT": ("either", "at"),
    "TO": ("to", "to"),
    "FROM": ("from", "on"),
}
_LINKS = ("NEXT_TO", "RELATION", "NEAREST_TO")
_ROLES: Mapping[str, Role] = {"REL_IS": "is", "FROM": "is", "TO": "to"}
"""What is said of a place by the word before it; the cup from under the table is under it."""

_POINTED: Mapping[str, Where] = {
    "HERE": Where("to", Nominal("me", "me", reference="here"), "to"),
    "THERE": Where("to", Nominal("any", reference="there"), "at"),
    "INSIDE": Where("to", Nominal("any", reference="it"), "in"),
}
_FLAT = frozenset({"tray", "baking tray", "platter", "chopping board", "placemat", "mat", "rug"})
"""Things that others stand on, so that the left side of one is a part of it."""

_POSTURES = frozenset({"sitting", "standing", "lying"})


def _where(parts: Parts) -> Where | None:
    """Where a thing is or goes: on, in, at or beside something."""
    *_, of = parts
    if not isinstance(of, Nominal) or of.sort == "animal":
        return None  # where an animal is, is no place: it moves
    clauses, links = words(parts, "REL_IS"), words(parts, *_LINKS)
    posture = next((one.meaning for one in clauses if one.meaning in _POSTURES), "")
    if links:
        kind = _relation_of(links[0], of)
        said: list[Role] = [_ROLES[word.word_class] for word in words(parts, *_ROLES)]
        return None if kind is None else Where([*said, "either"][0], of, None, kind, posture=posture)
    (word,) = words(parts, *_PLACES)
    role, preposition = _PLACES[word.word_class]
    return Where("is" if clauses else role, of, preposition, atop=word.meaning == "top", posture=posture)


def _relation_of(link: Word, of: Nominal) -> RelationKind | None:
    """The relation that a word says; the left side of a table is a part of it, and no relation."""
    if link.meaning.endswith("_side_of"):
        apart = not of.is_place and of.kind not in _FLAT
        return relation_kind(link.meaning.replace("_side", "")) if apart else None
    return None if of.sort == "you" and of.said else relation_kind(link.meaning)  # "by yourself"


def _within(parts: Parts) -> Relative | None:
    """The second half of "the person next to the table", said of the noun before it."""
    where = _where(parts)
    return where.told if where is not None and (where.relation or where.of.is_place) else None


def _qualified(parts: Parts) -> Nominal | None:
    """The person next to the table, the table in the kitchen."""
    nominal, relation = parts
    inside = nominal.is_place and relation.kind in ("on", "in") and relation.to.sort != "room"
    if not (nominal.is_person or nominal.is_place) or nominal.reference or inside:
        return None
    placed: Nominal | Trouble = nominal.placed(relation)
    return placed if isinstance(placed, Nominal) else None


def _trash(parts: Parts) -> Where:
    return Where("either" if words(parts, "IN") else "to", BIN, "in")


def _pointed(parts: Parts) -> Where:
    """Here, there and inside, and from there."""
    *came, word = parts
    where = _POINTED[word.word_class]
    return replace(where, role="from") if came else where


def _located_first(parts: Parts) -> Where | None:
    """A place before the command: "in the kitchen, take the cup"."""
    place = parts[-1]
    return Where("is", place, "in") if isinstance(place, Nominal) and place.is_place else None


def _hand(parts: Parts) -> Hand | None:
    (side,) = words(parts, "LEFT_RIGHT")
    if any(mark.meaning != "," for mark in words(parts, "PAUSE")):
        return None
    named = words(parts, "HAND") or any(word.meaning in ("your", "the") for word in words(parts, "DET"))
    return Hand(side.meaning) if named or side.end - side.start > 1 else None


def _benefit(parts: Parts) -> Benefit | None:
    person = parts[-1]
    return Benefit(person) if isinstance(person, Nominal) and person.is_person else None


MEANINGS: Mapping[str, Meaning] = {
    "where": _where,
    "located_from": _where,
    "located_first": _located_first,
    "within": _within,
    "qualified": _qualified,
    "trash": _trash,
    "here": _pointed,
    "there": _pointed,
    "inside": _pointed,
    "back": always("back"),
    "hand": _hand,
    "benefit": _benefit,
}
