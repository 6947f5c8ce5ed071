"""What noun phrases mean: nouns, names and pronouns, with articles and owners."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from types import MappingProxyType

from executive.language.phrases.amounts import one_by_one, unclear_glasses
from executive.language.phrases.features import (
    COUNTED_FROM,
    ROBOT,
    SUPERLATIVES,
    described,
    feature_of,
    from_side,
)
from executive.language.phrases.parts import Parts, nominal_of, words
from executive.language.phrases.values import Meaning, Nominal, Relative, Sort, Trouble
from executive.language.text.word import Word

_SORTS: Mapping[str, Sort] = {
    "KIND": "thing",
    "KINDS": "thing",
    "SUBSTANCE": "thing",
    "PAIR": "thing",
    "THING": "any",
    "THINGS": "any",
    "ONE": "any",
    "ONES": "any",
    "FURNITURE": "furniture",
    "FURNITURES": "furniture",
    "CONTAINER": "container",
    "CONTAINERS": "container",
    "DOOR": "door",
    "DOORS": "door",
    "DRAWER_OF": "container",
    "SHELF_OF": "furniture",
    "ROOM": "room",
    "PERSON": "person",
    "PEOPLE": "person",
    "ANIMAL": "animal",
    "ANIMALS": "animal",
}
_PLURAL = frozenset({"KINDS", "THINGS", "ONES", "FURNITURES", "CONTAINERS", "DOORS", "PEOPLE", "ANIMALS"})
_MASS = frozenset({"SUBSTANCE", "PAIR"})
_COLLECTIVE = frozenset({"fruit", "food"})
"""Kinds of which the singular may mean several."""
_WHOSE = frozenset({"my", "your", "our", "this", "that", "these", "those"})


def _noun(parts: Parts) -> Nominal | None:
    (word,) = parts if len(parts) == 1 else (None,)
    if isinstance(word, Nominal):
        return word
    if not isinstance(word, Word):
        return None
    sort = _SORTS[word.word_class]
    anaphoric = word.word_class in ("ONE", "ONES")
    kind = None if sort == "any" else word.meaning
    return Nominal(
        sort,
        kind,
        plural=word.word_class in _PLURAL,
        anaphoric=anaphoric,
        paired=word.word_class == "PAIR",
        mass=word.word_class in _MASS or (kind in _COLLECTIVE and word.word_class == "KIND"),
        said=word.said,
    )


def _filled(parts: Parts) -> Nominal | None:
    vessel, preposition, content = parts
    name = f"{vessel.meaning} {preposition.meaning} {content.said}"
    laced = preposition.said == "with"
    return Nominal("thing", vessel.meaning, name=name, plural=vessel.word_class == "KINDS", laced=laced)


def _door_of(parts: Parts) -> Nominal | None:
    (door,), (of,) = words(parts, "DOOR"), words(parts, "CONTAINER", "ROOM", "WHICH_DOOR")
    if of.word_class == "CONTAINER" and door.meaning != "door":
        return None
    if of.word_class == "CONTAINER":
        return Nominal("container", of.meaning)
    return Nominal("door", door.meaning, name=f"{of.meaning} {door.meaning}")


def _part_of(parts: Parts) -> Nominal | Trouble | None:
    """The top drawer of the desk: the drawer that is in it, and no other."""
    *_, whole = words(parts, "FURNITURE", "CONTAINER")
    (part,) = words(parts, "DRAWER_OF", "SHELF_OF", "DOOR")
    if part.meaning == whole.meaning or (part.word_class == "DOOR" and part.meaning != "door"):
        return None
    of = Nominal(_SORTS[whole.word_class], whole.meaning, determined=True, said=whole.said)
    named = Nominal(_SORTS[part.word_class], part.meaning, determined=True, relation=Relative("in", of))
    return described(named, parts)


def _untold(parts: Parts) -> Trouble | None:
    """The selected object: what was selected is not said."""
    (word,) = words(parts, "UNTOLD")
    noun = nominal_of(parts)
    if noun is None:
        return None
    return Trouble(f"which {noun.said or 'object'} is meant by {word.said!r}?", asks=True)


def _one(parts: Parts) -> Nominal | Trouble | None:
    if len(parts) == 1 and isinstance(parts[0], Word):
        return None
    nominal = described(nominal_of(parts), parts)
    if not isinstance(nominal, Nominal):
        return nominal
    if nominal.plural and nominal.said == nominal.kind:
        return None  # "the fish" is one, "two fish" are two
    if nominal.ordinal in COUNTED_FROM and any(word.said in ("a", "an") for word in words(parts, "DET")):
        return Trouble(f"one more, or the {nominal.ordinal} one?", nominal.ordinal, asks=True)
    if nominal.sort == "thing" and any(word.meaning == "your" for word in words(parts, "DET")):
        return Trouble(f"this robot has no {nominal.said} of its own: which one is meant?", asks=True)
    whose = next((word.said for word in words(parts, "DET") if word.said in _WHOSE), "")
    indefinite = any(word.said in ("a", "an") for word in words(parts, "DET"))
    determined = bool(words(parts, "DET", "ANOTHER"))
    return replace(nominal, determined=determined, indefinite=indefinite, whose=whose)


def _rank(parts: Parts) -> Nominal | Trouble | None:
    """The second from the right, without a noun."""
    one = Nominal("any", anaphoric=True, determined=True, said="one")
    (rank,), (side,) = words(parts, "ORDINAL"), words(parts, "LEFT_RIGHT")
    return described(described(one, (feature_of(rank),)), (from_side((side,)),))


def _owned(parts: Parts) -> Nominal | Trouble | None:
    owner = words(parts, "OWNER", "OWNING", "OWNING_ANIMAL")[0]
    named, animal = owner.word_class == "OWNER", owner.word_class == "OWNING_ANIMAL"
    whose = f"{owner.meaning}'s" if named else owner.said
    nominal = described(nominal_of(parts), parts)
    if not isinstance(nominal, Nominal) or nominal.name is not None or nominal.kind is None:
        return nominal if isinstance(nominal, Trouble) else None
    if nominal.kind == "glass" and nominal.plural:
        return unclear_glasses(nominal)
    sort: Sort = "name" if named else "person"
    somebody = None if animal else Nominal(sort, owner.meaning, determined=True)
    return replace(nominal, name=f"{whose} {nominal.kind}", determined=True, owner=somebody)


def _simple(parts: Parts) -> Nominal | None:
    """Pronouns and names."""
    word = parts[0]
    if len(parts) != 1:
        return None
    if isinstance(word, Nominal):
        return word
    if not isinstance(word, Word):
        return None
    match word.word_class:
        case "IT":
            return Nominal("any", reference="it", determined=True)
        case "THEM":
            return Nominal("any", reference="them", plural=True, determined=True, said=word.meaning)
        case "THIS":
            return Nominal("any", reference="this", determined=True)
        case "HIM":
            return Nominal("person", reference="him", determined=True, said=word.said)
        case "ME":
            return Nominal("me", "me", determined=True)
        case "YOU":
            return ROBOT
        case "NAME":
            return Nominal("name", word.meaning, determined=True)
    return None


def _whichever(parts: Parts) -> Nominal | Trouble | None:
    """Whichever book is nearest to the lamp: the one that is."""
    *said, last = (part for part in parts if part not in words(parts, "WHICHEVER", "IS_AT", "DET", "ONE"))
    noun = described(nominal_of(tuple(said)), tuple(said))
    if not isinstance(noun, Nominal) or noun.plural:
        return noun if isinstance(noun, Trouble) else None
    one = replace(noun, determined=True)
    if isinstance(last, Nominal):
        return one.placed(Relative("nearest", last))
    if last.word_class != "NEAREST" and last.meaning not in SUPERLATIVES and last.word_class != "ORDINAL":
        return None  # "whichever cup is big"
    feature = feature_of(last)
    return None if feature is None else described(one, (feature,))


def _whoever(parts: Parts) -> Nominal | Trouble:
    """Whoever is closest to you."""
    to = next((part for part in parts if isinstance(part, Nominal)), ROBOT)
    return Nominal("person", "person", determined=True).placed(Relative("nearest", to))


def _np(parts: Parts) -> Nominal | Trouble | None:
    nominal: Nominal | Trouble | None = parts[0]
    if (
        len(parts) > 1
        and isinstance(nominal, Nominal)
        and (nominal.reference or nominal.sort in ("me", "you", "name"))
    ):
        return None
    told = described(nominal, parts[1:])
    if isinstance(told, Nominal) and told.ordinal in COUNTED_FROM:
        nearest = told.relation is not None and told.relation.kind == "nearest"
        rank = told.size if told.size in SUPERLATIVES else "nearest" if nearest else None
        if rank is not None:
            return Trouble(f"the {told.ordinal} {rank}: things are counted from a side only", told.ordinal)
    if isinstance(told, Nominal) and told.plural and not told.counted and told.count == 1:
        only = told.size if told.size in SUPERLATIVES else told.ordinal
        if only not in (None, "other"):
            return Trouble(one_by_one(str(only)), only)
    if (
        isinstance(told, Nominal)
        and isinstance(nominal, Nominal)
        and told.counted
        and told.ordinal not in (nominal.ordinal, "other")
    ):
        return Trouble(one_by_one(str(told.ordinal)), told.ordinal)
    return told


def _person_ahead(parts: Parts) -> Nominal | Trouble | None:
    """The person in front: of the robot. Of things, the front one may be meant."""
    nominal = parts[0]
    if not isinstance(nominal, Nominal) or nominal.sort != "person" or nominal.reference:
        return None
    return nominal.placed(Relative("in_front_of", ROBOT))


MEANINGS: Mapping[str, Meaning] = MappingProxyType(
    {
        "noun": _noun,
        "filled": _filled,
        "door_of": _door_of,
        "part_of": _part_of,
        "one": _one,
        "untold": _untold,
        "owned": _owned,
        "rank": _rank,
        "simple": _simple,
        "np": _np,
        "person_ahead": _person_ahead,
        "whichever": _whichever,
        "whoever": _whoever,
    }
)
