"""Words of structured actions, held against the vocabulary: what is in no list is not acted on."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import fields, replace
from functools import lru_cache
from types import MappingProxyType
from typing import Any

from executive.config import cache_directory
from executive.language.commands.moving import MAX_ANGULAR_RAD_S, MAX_LINEAR_M_S
from executive.language.phrases.features import COUNTED_FROM
from executive.meaning import Command, Refusal
from executive.vocabulary import NOWHERE, PlaceWords, Vocabulary, load_vocabulary
from executive.vocabulary.place_words import place_words
from robots.scenes.scene_words import nearest_word
from trees.tasks import MoveTask, ObjectDescription, ObjectOf, Relation

_TOLD_BY: Mapping[str, tuple[str, ...]] = MappingProxyType(
    {
        "size": ("SIZE", "COMPARED"),
        "material": ("MATERIAL",),
        "ordinal": ("ORDINAL", "ANOTHER", "NEAREST", "LEFT_RIGHT"),
    }
)
"""The word classes of what tells a thing from others of its kind. Names are the scene's: it judges them."""
_SIDES: Mapping[str, str] = MappingProxyType({"left": "leftmost", "right": "rightmost"})
_FROM_SIDE = re.compile(r"(?P<rank>\w+) from (the )?(?P<side>left|right)( side)?")
_DESTINATIONS = ("source", "to", "on", "person")
_NOUNS = ("KIND", "SUBSTANCE", "PAIR", "CONTAINER", "DOOR", "FURNITURE", "PERSON", "ROOM")
_KINDS = ("KIND", "SUBSTANCE", "PAIR", "CONTAINER")
_GOALS = ("FURNITURE", "CONTAINER", "DOOR", "ROOM", "PERSON", "NAME")
_ALWAYS_KNOWN = ("me", "in_front", "you", "robot", "start")


class UnknownWordError(Exception):
    """A word that the vocabulary does not have, or that is never acted on."""

    def __init__(self, message: str, word: str) -> None:
        self.message, self.word = message, word
        super().__init__(message)


def checked_command(command: Command) -> Command | Refusal:
    """The command with canonical words, or why it is not acted on."""
    if isinstance(command, MoveTask):
        refusal = _too_fast(command)
        if refusal is not None:
            return refusal
    try:
        changes = {field.name: _slot(field.name, getattr(command, field.name)) for field in fields(command)}
    except UnknownWordError as unknown:
        return Refusal(unknown.message, unknown.word)
    return replace(command, **changes)


def _too_fast(move: MoveTask) -> Refusal | None:
    for name, value, limit, unit in (
        ("linear speed", move.linear_m_s, MAX_LINEAR_M_S, "m/s"),
        ("angular speed", move.angular_rad_s, MAX_ANGULAR_RAD_S, "rad/s"),
    ):
        if abs(value) > limit:
            return Refusal(f"the {name} {value:g} {unit} exceeds the limit of {limit:g} {unit}", f"{value:g}")
    return None


def _slot(name: str, value: Any) -> Any:
    if isinstance(value, ObjectDescription):
        return _object(value)
    if name in _DESTINATIONS and isinstance(value, str):
        return _destination(value)
    if name == "duration_s" and value is not None and value <= 0.0:
        raise UnknownWordError(f"a duration of {value:g} s is none", f"{value:g}")
    return value


def _object(wanted: ObjectDescription) -> ObjectDescription:
    if wanted == ObjectDescription():
        raise UnknownWordError("an object without any slot says nothing", "object")
    relation = wanted.relation
    if relation is not None:
        to: Any = relation.to
        if isinstance(to, ObjectDescription):
            to = _object(to)
        elif not isinstance(to, ObjectOf):
            to = _destination(to)
        relation = Relation(relation.kind, to)
    told: dict[str, Any] = {
        slot: _told(slot, said) for slot in _TOLD_BY if (said := getattr(wanted, slot)) is not None
    }
    return replace(
        wanted,
        kind=None if wanted.kind is None else _canonical(wanted.kind, _NOUNS),
        color=None if wanted.color is None else _canonical(wanted.color, ("COLOR",)),
        relation=relation,
        **told,
    )


def _told(slot: str, word: str) -> str:
    """A size, a material or an order as sentences have it.

    Raises:
        UnknownWordError: Sentences know no such word in this place.
    """
    plain = " ".join(word.lower().replace("_", " ").replace("-", " ").split())
    counted = _FROM_SIDE.fullmatch(plain) if slot == "ordinal" else None
    if counted is not None and (rank := _of_slot(slot, counted["rank"])) in COUNTED_FROM:
        if rank == "first":
            return _SIDES[counted["side"]]
        return rank if counted["side"] == "left" else f"{rank}_from_right"
    meaning = _of_slot(slot, plain)
    if meaning is None:
        classes = vocabulary().classes
        phrases = [one for name in _TOLD_BY[slot] for some in classes[name].words.values() for one in some]
        near = nearest_word(plain, phrases)
        raise UnknownWordError(f"the {slot} {word[:40]!r} is not known; the nearest is {near!r}", word[:40])
    return _SIDES.get(meaning, meaning)


def _of_slot(slot: str, plain: str) -> str | None:
    words = plain.split()
    length, readings = vocabulary().match(words)
    fitting = [one.meaning for one in readings if one.word_class in _TOLD_BY[slot]]
    return fitting[0] if fitting and length == len(words) else None


def _destination(word: str) -> str:
    if word in _ALWAYS_KNOWN:
        return word
    parts = word.split()
    if len(parts) == 2 and all(_is_a_name(part) for part in parts):
        return " ".join(_canonical(part, ("NAME",)) for part in parts)
    return _canonical(word, _GOALS)


def _is_a_name(word: str) -> bool:
    """Whether it is a name of people and nothing else."""
    length, readings = vocabulary().match([word.lower()])
    return length == 1 and {one.word_class for one in readings} == {"NAME"}


def _canonical(word: str, preferred: Sequence[str]) -> str:
    """The canonical form of a word; of several readings one of the preferred classes.

    Raises:
        UnknownWordError: It is in no list, or only in lists of words that are refused.
    """
    known = vocabulary()
    words = word.lower().replace("_", " ").split()
    length, readings = known.match(words)
    if length != len(words) or not readings:
        raise UnknownWordError(f"the word {word[:40]!r} is not known", word[:40])
    usable = [reading for reading in readings if known.classes[reading.word_class].refusal is None]
    if not usable:
        message = next(filter(None, (known.refusal(reading, word[:40]) for reading in readings)), "")
        raise UnknownWordError(message, word[:40])
    first = next((reading for reading in usable if reading.word_class in preferred), usable[0])
    return first.meaning


def canonical_kind(word: str) -> str:
    """What sentences call a kind of thing, "cup" for a mug; what is in no list of things stays as it is."""
    known, words = vocabulary(), word.casefold().split()
    length, readings = known.match(words)
    if length != len(words):
        return word
    kinds = [one.meaning for name in _KINDS for one in readings if one.word_class in (name, f"{name}S")]
    return kinds[0] if kinds else word


def vocabulary() -> Vocabulary:
    """The words that are shipped, and those of the place that is spoken of."""
    return _vocabulary(place_words())


@lru_cache(maxsize=4)
def _vocabulary(place: PlaceWords) -> Vocabulary:
    shipped = load_vocabulary((), cache_directory())
    if place == NOWHERE:
        return shipped
    from executive.vocabulary.of_place import of_place  # a mere sentence needs none

    return of_place(shipped, place)
