"""What noun phrases mean: articles, numbers, adjectives and nouns put together."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import Any

from executive.language.lattice import Word
from executive.language.phrases import Feature, Meaning, Nominal, Relative, Sort, Trouble

SUPERLATIVES = frozenset({"smallest", "biggest", "tallest", "shortest", "longest", "thinnest", "widest"})
"""Sizes that one thing has among those in view."""

MAX_COUNT = 20
"""More things at once than anybody means; beyond it the number is taken for a mistake."""

ROBOT = Nominal("you", "robot")

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
    "ROOM": "room",
    "PERSON": "person",
    "PEOPLE": "person",
}
_PLURAL = frozenset({"KINDS", "THINGS", "ONES", "FURNITURES", "CONTAINERS", "DOORS", "PEOPLE"})
_MASS = frozenset({"SUBSTANCE", "PAIR"})
_COLLECTIVE = frozenset({"fruit", "food"})
"""Kinds of which the singular may mean several."""
_SLOTS = {
    "COLOR": "color",
    "SIZE": "size",
    "COMPARED": "size",
    "MATERIAL": "material",
    "ORDINAL": "ordinal",
    "ANOTHER": "ordinal",
}
_SIDES = {"left": "leftmost", "right": "rightmost"}
_WHOSE = frozenset({"my", "your", "our", "this", "that", "these", "those"})
_COUNTED_FROM = frozenset({"first", "second", "third", "fourth", "fifth", "sixth"})

Parts = tuple[Any, ...]


def words(parts: Iterable[Any], *classes: str) -> list[Word]:
    """The words of some classes among the parts."""
    return [part for part in parts if isinstance(part, Word) and part.word_class in classes]


@dataclass(frozen=True, slots=True)
class _FromSide:
    """Counted from the left, or from the right."""

    side: str


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
    return Nominal("thing", vessel.meaning, name=name, plural=vessel.word_class == "KINDS")


def _door_of(parts: Parts) -> Nominal | None:
    of, door = parts
    if of.word_class == "CONTAINER" and door.meaning != "door":
        return None
    if of.word_class == "CONTAINER":
        return Nominal("container", of.meaning)
    return Nominal("door", door.meaning, name=f"{of.meaning} {door.meaning}")


def _adjective(parts: Parts) -> Feature | Relative | None:
    word, *pause = parts
    if pause and pause[0].meaning != ",":
        return None
    return _feature(word)


def _feature(word: Any) -> Feature | Relative | None:
    if not isinstance(word, Word):
        return None
    if word.word_class == "LEFT_RIGHT":
        return Feature("ordinal", _SIDES[word.meaning])
    if word.word_class == "NEAREST":
        return Relative("nearest", ROBOT)
    return Feature(_SLOTS[word.word_class], word.meaning)


def _adjective_word(parts: Parts) -> Word:
    first: Word = parts[0]
    return first


def described(nominal: Nominal | Trouble | None, parts: Parts) -> Nominal | Trouble | None:
    """The nominal with every feature among the parts."""
    for part in parts:
        if not isinstance(nominal, Nominal):
            return nominal
        if isinstance(part, Feature):
            nominal = nominal.described(part)
        elif isinstance(part, Relative):
            nominal = nominal.placed(part)
        elif isinstance(part, _FromSide):
            if nominal.ordinal not in _COUNTED_FROM:
                return None
            if part.side == "right":
                first = nominal.ordinal == "first"
                nominal = replace(nominal, ordinal="rightmost" if first else f"{nominal.ordinal}_from_right")
        elif isinstance(part, Word) and part.word_class == "ANOTHER":
            nominal = nominal.described(Feature("ordinal", "other"))
    return nominal


def nominal_of(parts: Parts) -> Nominal | None:
    """The noun among the parts."""
    return next((part for part in reversed(parts) if isinstance(part, Nominal)), None)


def _one(parts: Parts) -> Nominal | Trouble | None:
    if len(parts) == 1 and isinstance(parts[0], Word):
        return None
    nominal = described(nominal_of(parts), parts)
    if not isinstance(nominal, Nominal):
        return nominal
    if nominal.ordinal in _COUNTED_FROM and any(word.said in ("a", "an") for word in words(parts, "DET")):
        return Trouble(f"one more, or the {nominal.ordinal} one?", nominal.ordinal, asks=True)
    whose = next((word.said for word in words(parts, "DET") if word.said in _WHOSE), "")
    indefinite = any(word.said in ("a", "an") for word in words(parts, "DET"))
    determined = bool(words(parts, "DET", "ANOTHER"))
    return replace(nominal, determined=determined, indefinite=indefinite, whose=whose)


def _several(parts: Parts) -> Nominal | Trouble | None:
    amounts = [part for part in parts if isinstance(part, float)]
    couple = words(parts, "COUPLE")
    amount = amounts[0] if amounts else float(couple[0].meaning)
    nominal = described(nominal_of(parts), parts)
    if not isinstance(nominal, Nominal):
        return nominal
    if (nominal.anaphoric and amount == 1) or (couple and not nominal.plural):
        return None
    if amount != int(amount) or not 1 <= amount <= MAX_COUNT:
        return Trouble(
            f"{amount:g} things at once: a whole number from 1 to {MAX_COUNT} is understood", f"{amount:g}"
        )
    if amount > 1 and words(parts, "DET") and not (nominal.plural or nominal.paired):
        message = f"{amount:g} of them, or the one with the number {amount:g}?"
        return Trouble(message, f"{amount:g}", asks=True)
    extreme = nominal.size if nominal.size in SUPERLATIVES else None
    if amount > 1 and extreme:
        return Trouble(f"{amount:g} things that are each the {extreme} one", extreme)
    if amount > 1 and nominal.ordinal not in (None, "other"):
        return Trouble(f"{amount:g} things that are each the {nominal.ordinal} one", nominal.ordinal)
    return replace(nominal, count=int(amount), counted=True, determined=True)


def _both(parts: Parts) -> Nominal | Trouble | None:
    nominal = described(nominal_of(parts), parts)
    if not isinstance(nominal, Nominal) or not nominal.plural:
        return nominal if isinstance(nominal, Trouble) else None
    return replace(nominal, count="both", counted=True, determined=True)


def _unclear_glasses(nominal: Nominal) -> Trouble:
    return Trouble("glasses to see with, or to drink from?", nominal.said, asks=True)


def _all(parts: Parts) -> Nominal | Trouble | None:
    nominal = described(nominal_of(parts), parts)
    if not isinstance(nominal, Nominal):
        return nominal
    each = bool(words(parts, "EVERY"))
    if nominal.kind == "glasses":
        return _unclear_glasses(nominal)
    if not each and not (nominal.plural or nominal.mass):
        return None
    if each and nominal.ordinal == "other" and not nominal.plural:
        return Trouble("every second one, or all the others?", "other", asks=True)
    only = nominal.size if nominal.size in SUPERLATIVES else nominal.ordinal
    if only not in (None, "other"):
        return Trouble(f"several things that are each the {only} one", only)
    amounts = [part for part in parts if isinstance(part, float)]
    count: int | str = int(amounts[0]) if amounts and 1 < amounts[0] <= MAX_COUNT else "all"
    return replace(nominal, count=count, counted=True, determined=True, plural=True)


def _one_of(parts: Parts) -> Nominal | Trouble | None:
    nominal = described(nominal_of(parts), parts)
    if not isinstance(nominal, Nominal) or not nominal.plural:
        return nominal if isinstance(nominal, Trouble) else None
    return replace(nominal, plural=False, determined=True)


def _out_of(parts: Parts) -> Nominal | Trouble | None:
    """The bigger of the two cups."""
    amounts = [part for part in parts if isinstance(part, float)]
    if nominal_of(parts) is None and not amounts:
        return None  # "on top of that"
    features = sum(isinstance(part, (Feature, Relative)) for part in parts)
    if nominal_of(parts) is None and features > 1:
        return None  # "the bigger of the two first"
    nominal = nominal_of(parts) or Nominal("any", plural=True)
    if not nominal.plural:
        return None
    result = described(nominal, parts)
    if not isinstance(result, Nominal):
        return result
    if result.ordinal in _COUNTED_FROM and any(word.said in ("a", "an") for word in words(parts, "DET")):
        return Trouble("how many of them?", result.ordinal, asks=True)  # "a third of the cups"
    return replace(result, plural=False, determined=True)


def _some(parts: Parts) -> Nominal | Trouble | None:
    """A few cups: nobody knows how many; some water, any cup: one."""
    nominal = described(nominal_of(parts), parts)
    if not isinstance(nominal, Nominal):
        return nominal
    if not nominal.plural and words(parts, "MANY")[0].meaning != "some":
        return None
    return replace(nominal, count="some" if nominal.plural else 1, determined=True)


def _everything(_parts: Parts) -> Nominal:
    return Nominal("any", count="all", counted=True, plural=True, determined=True)


def _vague(_parts: Parts) -> Trouble:
    return Trouble("which object is meant?", asks=True)


def _owned(parts: Parts) -> Nominal | Trouble | None:
    owner = words(parts, "OWNER", "OWNING")[0]
    named = owner.word_class == "OWNER"
    whose = f"{owner.meaning}'s" if named else owner.said
    nominal = described(nominal_of(parts), parts)
    if not isinstance(nominal, Nominal) or nominal.name is not None or nominal.kind is None:
        return nominal if isinstance(nominal, Trouble) else None
    if nominal.kind == "glass" and nominal.plural:
        return _unclear_glasses(nominal)
    somebody = Nominal("name" if named else "person", owner.meaning, determined=True)
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


def _np(parts: Parts) -> Nominal | Trouble | None:
    nominal: Nominal | Trouble | None = parts[0]
    if (
        len(parts) > 1
        and isinstance(nominal, Nominal)
        and (nominal.reference or nominal.sort in ("me", "you", "name"))
    ):
        return None
    told = described(nominal, parts[1:])
    if isinstance(told, Nominal) and told.ordinal in _COUNTED_FROM:
        nearest = told.relation is not None and told.relation.kind == "nearest"
        rank = told.size if told.size in SUPERLATIVES else "nearest" if nearest else None
        if rank is not None:
            return Trouble(f"the {told.ordinal} {rank}: things are counted from a side only", told.ordinal)
    if isinstance(told, Nominal) and told.plural and not told.counted and told.count == 1:
        only = told.size if told.size in SUPERLATIVES else told.ordinal
        if only not in (None, "other"):
            return Trouble(f"several things that are each the {only} one", only)
    if (
        isinstance(told, Nominal)
        and isinstance(nominal, Nominal)
        and told.counted
        and told.ordinal not in (nominal.ordinal, "other")
    ):
        return Trouble(f"several things that are each the {told.ordinal} one", told.ordinal)
    return told


def _on_side(parts: Parts) -> Feature | Trouble | None:
    sides = words(parts, "LEFT_RIGHT")
    whose = [word for word in words(parts, "DET") if word.said in ("my", "our")]
    if whose:
        side = f"{whose[0].said} {sides[0].said}" if sides else whose[0].said
        return Trouble(f"{side!r}: left and right are seen from the robot; which side is meant?", asks=True)
    if sides:
        return Feature("ordinal", _SIDES[sides[0].meaning])
    ordinal = words(parts, "ORDINAL")[0].meaning
    return (
        Feature("ordinal", ordinal)
        if ordinal in ("leftmost", "rightmost", "middle", "top", "bottom")
        else None
    )


def _from_side(parts: Parts) -> _FromSide:
    return _FromSide(words(parts, "LEFT_RIGHT")[0].meaning)


def _made_of(parts: Parts) -> Feature:
    return Feature("material", words(parts, "MATERIAL")[0].meaning)


def _which_is(parts: Parts) -> Feature | Relative | None:
    word = next(
        part for part in parts if isinstance(part, Word) and part.word_class not in ("REL_IS", "DET", "ONE")
    )
    seen = any("you" in link.said.split() for link in words(parts, "REL_IS"))
    return None if seen else _feature(word)  # "the cup you see first"


MEANINGS: Mapping[str, Meaning] = MappingProxyType(
    {
        "noun": _noun,
        "filled": _filled,
        "door_of": _door_of,
        "adjective": _adjective,
        "adjective_word": _adjective_word,
        "one": _one,
        "several": _several,
        "both": _both,
        "all": _all,
        "one_of": _one_of,
        "out_of": _out_of,
        "some": _some,
        "everything": _everything,
        "vague": _vague,
        "owned": _owned,
        "simple": _simple,
        "np": _np,
        "on_side": _on_side,
        "from_side": _from_side,
        "made_of": _made_of,
        "which_is": _which_is,
    }
)
