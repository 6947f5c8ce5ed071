"""What noun phrases mean: nouns, names and pronouns, with articles and owners."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from executive.language.phrases.amounts import WHICH_GLASSES
from executive.language.phrases.features import COUNTED_FROM, ROBOT, SUPERLATIVES, described, of_noun
from executive.language.phrases.parts import Parts, words
from executive.language.phrases.values import Meaning, Nominal, Relative, Sort, Trouble

_SORTS: Mapping[str, Sort] = {
    "KIND": "thing",
    "SUBSTANCE": "thing",
    "PAIR": "thing",
    "THING": "any",
    "ONE": "any",
    "FURNITURE": "furniture",
    "CONTAINER": "container",
    "DOOR": "door",
    "DRAWER_OF": "container",
    "SHELF_OF": "furniture",
    "ROOM": "room",
    "PERSON": "person",
    "ANIMAL": "animal",
}
_PARTS = {"DOOR": "door", "CONTAINER": "drawer"}
_PLURALS: Mapping[str, str] = {
    **{f"{name}S": name for name in ("KIND", "THING", "ONE", "FURNITURE", "CONTAINER", "DOOR", "ANIMAL")},
    "PEOPLE": "PERSON",
}
COLLECTIVE = frozenset({"fruit", "food"})
"""Kinds of which the singular may mean several."""

_PRONOUNS: Mapping[str, Nominal] = {
    "IT": Nominal("any", reference="it", determined=True),
    "THEM": Nominal("any", reference="them", plural=True, determined=True),
    "THIS": Nominal("any", reference="this", determined=True),
    "HIM": Nominal("person", reference="him", determined=True),
    "ME": Nominal("me", "me", determined=True),
    "YOU": ROBOT,
}


def _noun(parts: Parts) -> Nominal:
    (word,) = words(parts, *_SORTS, *_PLURALS)
    said_as = _PLURALS.get(word.word_class, word.word_class)
    sort = _SORTS[said_as]
    kind = None if sort == "any" else word.meaning
    return Nominal(
        sort,
        kind,
        plural=word.word_class in _PLURALS,
        anaphoric=said_as == "ONE",
        paired=said_as == "PAIR",
        mass=said_as in ("SUBSTANCE", "PAIR") or (kind in COLLECTIVE and word.word_class == "KIND"),
        said=word.said,
    )


def _filled(parts: Parts) -> Nominal:
    """A cup of tea."""
    vessel, preposition, content = parts
    name = f"{vessel.meaning} {preposition.meaning} {content.said}"
    return Nominal("thing", vessel.meaning, name=name, plural=vessel.word_class in _PLURALS)


def _door_of(parts: Parts) -> Nominal | None:
    """The fridge door is the fridge; the kitchen door is a door of its own."""
    (door,), (of,) = words(parts, "DOOR"), words(parts, "CONTAINER", "ROOM", "WHICH_DOOR")
    if of.word_class == "CONTAINER":
        return Nominal("container", of.meaning) if door.meaning == "door" else None
    return Nominal("door", door.meaning, name=f"{of.meaning} {door.meaning}")


def _part_of(parts: Parts) -> Nominal | Trouble | None:
    """The top drawer of the desk, the cabinet drawer: the drawer that is in it, and no other."""
    (part,) = words(parts, "DRAWER_OF", "SHELF_OF", "DOOR") or words(parts[-1:], "CONTAINER")
    of = parts[-1] if isinstance(parts[-1], Nominal) else _whole((words(parts, "CONTAINER")[0],))
    is_part = part.meaning == _PARTS.get(part.word_class, part.meaning)
    if not isinstance(of, Nominal) or part.meaning == of.kind or not is_part:
        return None
    named = Nominal(_SORTS[part.word_class], part.meaning, determined=True, relation=Relative("in", of))
    return described(named, parts)


def _whole(parts: Parts) -> Nominal | Trouble | None:
    """What something is a part of: "the wooden cabinet"."""
    told = described(_noun(parts[-1:]), parts)
    return replace(told, determined=True) if isinstance(told, Nominal) else told


def _one(nominal: Nominal, parts: Parts) -> Nominal | Trouble | None:
    if nominal.plural and nominal.said == nominal.kind:
        return None  # "the fish" is one, "two fish" are two
    if nominal.sort in ("door", "room") and nominal.ordinal in ("front", "back"):
        return None  # which door it is has a name of its own
    told = next((word.meaning for word in words(parts, "DET")), "")
    if nominal.ordinal in COUNTED_FROM and told == "a":
        return Trouble(f"one more, or the {nominal.ordinal} one?", nominal.ordinal, asks=True)
    if nominal.sort == "thing" and told == "your":
        return Trouble(f"this robot has no {nominal.said} of its own: which one is meant?", asks=True)
    whose = told if told not in ("the", "a") else ""
    determined = bool(told or words(parts, "ANOTHER"))
    return replace(nominal, determined=determined, indefinite=told == "a", whose=whose)


def _owned(nominal: Nominal, parts: Parts) -> Nominal | Trouble | None:
    """Ana's cup, the dog's leash."""
    (owner,) = words(parts, "OWNER", "OWNING", "OWNING_ANIMAL")
    named = owner.word_class == "OWNER"
    if nominal.name is not None or nominal.kind is None:
        return None
    if nominal.plural and nominal.kind == "glass":
        return WHICH_GLASSES
    whose = f"{owner.meaning}'s" if named else owner.said
    somebody = Nominal("name" if named else "person", owner.meaning, determined=True)
    person = None if owner.word_class == "OWNING_ANIMAL" else somebody
    return replace(nominal, name=f"{whose} {nominal.kind}", determined=True, owner=person)


def _simple(parts: Parts) -> Nominal:
    """Pronouns and names."""
    (word,) = words(parts, "NAME", *_PRONOUNS)
    if word.word_class == "NAME":
        return Nominal("name", word.meaning, determined=True)
    pronoun = _PRONOUNS[word.word_class]
    said = word.said if word.word_class == "HIM" else word.meaning
    return replace(pronoun, said="" if said == pronoun.kind else said)


def _np(parts: Parts) -> Nominal | Trouble | None:
    """A noun with what is said behind it; of what only one thing is there are not several."""
    nominal, *said = parts
    if said and (nominal.reference or nominal.sort in ("me", "you", "name")):
        return None
    told = described(nominal, tuple(said))
    if not isinstance(told, Nominal):
        return told
    nearest = told.relation is not None and told.relation.kind == "nearest"
    rank = told.size if told.size in SUPERLATIVES else told.ordinal
    if told.ordinal in COUNTED_FROM and (nearest or rank != told.ordinal):
        return Trouble(f"the {told.ordinal}: things are counted from a side only", told.ordinal)
    if rank is not None and rank != "other" and (told.plural or told.count != 1):
        return Trouble(f"{rank!r} is one of them; name several things one by one", rank)
    return told


MEANINGS: Mapping[str, Meaning] = {
    "noun": _noun,
    "filled": _filled,
    "door_of": _door_of,
    "part_of": _part_of,
    "whole": _whole,
    "one": of_noun(_one),
    "owned": of_noun(_owned),
    "simple": _simple,
    "np": _np,
}
