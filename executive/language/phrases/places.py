"""What is said of where things are and go, and which hand is used."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType

from executive.language.phrases.features import ROBOT
from executive.language.phrases.handled_thing import BIN, TRASH
from executive.language.phrases.parts import Parts, words
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
    may_be_found,
    relation_kind,
)
from executive.language.text.word import Word
from trees.tasks import RelationKind

_LINKS = frozenset({"NEXT_TO", "RELATION", "NEAREST_TO", "ROUND"})
_WITHIN: Mapping[str, RelationKind] = {"ON": "on", "IN": "in", "AT": "next_to"}
_FLAT = frozenset(
    {"tray", "baking tray", "platter", "chopping board", "placemat", "mat", "tablecloth", "rug"}
)
"""Things that other things stand on."""
_POSTURES = frozenset(
    {*("sitting", "standing", "lying", "sits", "stands", "lies"), *("sit", "stand", "lie", "seated")}
)
"""Words that say how somebody is somewhere, which of a thing say nothing."""
_KIND = {"NEXT_TO": "next_to", "NEAREST_TO": "nearest"}


@dataclass(frozen=True, slots=True)
class _LeftBy:
    """Who left a thing somewhere."""

    who: Nominal


def _place(role: Role, preposition: Preposition) -> Meaning:
    def meaning(parts: Parts) -> Where | Trouble | None:
        nominal = parts[-1]
        if not isinstance(nominal, Nominal):
            return None
        if nominal.sort == "animal":
            return _at_an_animal(nominal)
        atop = any("top" in word.said.split() for word in words(parts, "ON"))
        return Where(role, nominal, preposition, atop=atop, left_by=_left_by(parts), posture=_posture(parts))

    return meaning


def _posture(parts: Parts) -> str:
    said = [one for word in words(parts, "REL_IS") for one in word.said.split()]
    return next((one for one in said if one in _POSTURES), "")


def _at_an_animal(nominal: Nominal) -> Trouble:
    return Trouble(f"where an animal ({nominal.kind!r}) is, is no place: it moves", nominal.kind)


def _relation(role: Role) -> Meaning:
    def meaning(parts: Parts) -> Where | Trouble | None:
        nominal = parts[-1]
        link = words(parts, *_LINKS)[-1]
        if not isinstance(nominal, Nominal) or (nominal.sort == "you" and link.said == "by"):
            return None  # "by yourself"
        if nominal.sort == "animal":
            return _at_an_animal(nominal)
        kind = _relation_of(link, nominal)
        return None if kind is None else Where(role, nominal, None, kind, left_by=_left_by(parts))

    return meaning


def _located_round(parts: Parts) -> Where | None:
    """Near something on any of its sides; what is round somebody may be wherever he goes."""
    of = parts[-1]
    fits = isinstance(of, Nominal) and (of.is_place or of.sort == "thing")
    return _BESIDE(parts) if fits else None


_BESIDE = _relation("is")


def _left(parts: Parts) -> _LeftBy | Trouble:
    """Who left a thing where it is; who put it there may tell it from others, and nobody can see that."""
    (who,) = words(parts, "NAME", "PERSON")
    (did,) = words(parts, "LEFT_IT")
    if did.meaning != "left":
        return Trouble(
            f"who put it there ({who.said} {did.said}) cannot be seen: is it any that is there?", asks=True
        )
    return _LeftBy(Nominal("name" if who.word_class == "NAME" else "person", who.meaning, determined=True))


def _left_by(parts: Parts) -> Nominal | None:
    return next((part.who for part in parts if isinstance(part, _LeftBy)), None)


def _relation_of(link: Word, of: Nominal) -> RelationKind | None:
    """The relation that a word says; the left side of a table or tray is a part of it, and no relation."""
    kind = _KIND.get(link.word_class, link.meaning)
    if kind.endswith("_side_of"):
        return None if of.is_place or of.kind in _FLAT else relation_kind(kind.replace("_side", ""))
    return relation_kind(kind)


def _within(parts: Parts) -> Relative | Trouble | None:
    """The second half of "the person next to the table", said of the noun before it."""
    link, of = parts
    if of.sort == "animal":
        return _at_an_animal(of)
    if link.word_class in ("ON", "IN", "AT"):
        return Relative(_WITHIN[link.word_class], of) if of.is_place else None
    kind = _relation_of(link, of)
    return None if kind is None else Relative(kind, of)


def _qualified(parts: Parts) -> Nominal | Trouble | None:
    nominal, relation = parts
    if (
        not isinstance(nominal, Nominal)
        or not (nominal.is_person or nominal.is_place)
        or nominal.sort == "me"
        or (nominal.sort == "name" and not may_be_found(relation))
    ):
        return None
    if nominal.reference or (
        relation.kind in ("on", "in") and nominal.is_place and relation.to.sort != "room"
    ):
        return None
    return nominal.placed(relation)


def _trash(parts: Parts) -> Where:
    return Where("either" if words(parts, "IN") else "to", replace(BIN, said=TRASH), "in")


def _here(_parts: Parts) -> Where:
    return Where("to", Nominal("me", "me", reference="here"), "to")


def _there(_parts: Parts) -> Where:
    return Where("to", Nominal("any", reference="there"), "at")


def _located_first(parts: Parts) -> Where | None:
    """A place before the command: "in the kitchen, take the cup"."""
    place = parts[-1]
    return Where("is", place, "in") if isinstance(place, Nominal) and place.is_place else None


def _from_there(_parts: Parts) -> Where:
    return Where("from", Nominal("any", reference="there"), "at")


def _back(_parts: Parts) -> str:
    return "back"


def _somewhere(parts: Parts) -> Trouble:
    (said,) = words(parts, "SOMEWHERE")
    told = f"which place is {said.said!r}?" if said.meaning == "there" else "where shall it go?"
    return Trouble(told, asks=True)


def _inside(_parts: Parts) -> Where:
    return Where("to", Nominal("any", reference="it"), "in")


def _from_inside(_parts: Parts) -> Where:
    return Where("from", Nominal("any", reference="it", determined=True), "at")


def _hand(parts: Parts) -> Hand | None:
    sides = words(parts, "LEFT_RIGHT")
    marks = words(parts, "PAUSE")
    if any(mark.meaning != "," for mark in marks):
        return None
    owned = any(word.said in ("your", "the") for word in words(parts, "DET"))
    named = words(parts, "HAND") or owned or sides[0].end - sides[0].start > 1
    return Hand(sides[0].meaning) if named else None


def _benefit(parts: Parts) -> Benefit | None:
    person = parts[-1]
    return Benefit(person) if isinstance(person, Nominal) and person.is_person else None


def _two_relations(parts: Parts) -> Trouble | None:
    """To the right of the spoon and to the left of the fork."""
    said = words(parts, "RELATION", "NEXT_TO")
    if len({word.meaning for word in said}) < len(said):
        return None  # "next to Ana and next to Ben" may be two things for two
    both = " and ".join(repr(word.said) for word in said)
    return Trouble(f"{both}: where something is, or goes, is told by one of them", said[-1].said)


MEANINGS: Mapping[str, Meaning] = MappingProxyType(
    {
        "located_on": _place("is", "on"),
        "located_in": _place("is", "in"),
        "located_at": _place("is", "at"),
        "located_relation": _relation("is"),
        "at_on": _place("either", "on"),
        "at_in": _place("either", "in"),
        "at_place": _place("either", "at"),
        "to_on": _place("to", "on"),
        "to_in": _place("to", "in"),
        "to_place": _place("to", "to"),
        "located_from": _place("from", "on"),
        "located_round": _located_round,
        "at_relation": _relation("either"),
        "to_relation": _relation("to"),
        "two_relations": _two_relations,
        "within": _within,
        "qualified": _qualified,
        "trash": _trash,
        "here": _here,
        "there": _there,
        "from_there": _from_there,
        "back": _back,
        "somewhere": _somewhere,
        "inside": _inside,
        "from_inside": _from_inside,
        "left": _left,
        "hand": _hand,
        "benefit": _benefit,
        "located_first": _located_first,
    }
)

__all__ = ["MEANINGS", "ROBOT"]
