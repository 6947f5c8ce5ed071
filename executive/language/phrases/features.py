"""What tells a thing from others: adjectives, sides and materials, put to a noun."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import Any

from executive.language.phrases.parts import Parts, words
from executive.language.phrases.values import Feature, Meaning, Nominal, Relative, Trouble
from executive.language.text.word import Word

SUPERLATIVES = frozenset({"smallest", "biggest", "tallest", "shortest", "longest", "thinnest", "widest"})
"""Sizes that one thing has among those in view."""

COUNTED_FROM = frozenset({"first", "second", "third", "fourth", "fifth", "sixth"})
"""Ranks that are counted from a side."""

ROBOT = Nominal("you", "robot")

_SLOTS = {
    "COLOR": "color",
    "SIZE": "size",
    "COMPARED": "size",
    "MATERIAL": "material",
    "ORDINAL": "ordinal",
    "ANOTHER": "ordinal",
}
_SIDES = {"left": "leftmost", "right": "rightmost"}


@dataclass(frozen=True, slots=True)
class _FromSide:
    """Counted from the left, or from the right."""

    side: str


def described(nominal: Nominal | Trouble | None, parts: Parts) -> Nominal | Trouble | None:
    """The nominal with every feature among the parts."""
    for part in parts:
        if not isinstance(nominal, Nominal):
            return nominal
        if isinstance(part, Feature) and part.said == "little" and nominal.mass and not nominal.paired:
            return Trouble("how much of it ('little') cannot be chosen", "little")
        if isinstance(part, Feature):
            nominal = nominal.described(part)
        elif isinstance(part, Relative):
            nominal = nominal.placed(part)
        elif isinstance(part, _FromSide):
            if nominal.ordinal not in COUNTED_FROM:
                return None
            if part.side == "right":
                first = nominal.ordinal == "first"
                nominal = replace(nominal, ordinal="rightmost" if first else f"{nominal.ordinal}_from_right")
        elif isinstance(part, Word) and part.word_class in ("ANOTHER", "OTHER"):
            nominal = nominal.described(Feature("ordinal", "other"))
    return nominal


def _adjective(parts: Parts) -> Feature | Relative | None:
    word, *pause = parts
    if pause and pause[0].meaning != ",":
        return None
    return feature_of(word)


def _adjective_word(parts: Parts) -> Word:
    first: Word = parts[0]
    return first


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


def from_side(parts: Parts) -> _FromSide:
    """From which side things are counted."""
    return _FromSide(words(parts, "LEFT_RIGHT")[0].meaning)


def _made_of(parts: Parts) -> Feature:
    return Feature("material", words(parts, "MATERIAL")[0].meaning)


def _wearing(parts: Parts) -> Trouble:
    (how,) = words(parts, "WEARING")
    return Trouble(f"people cannot be told apart by what they wear ({how.said!r})", how.said)


def _which_is(parts: Parts) -> Feature | Relative | None:
    word = next(
        part for part in parts if isinstance(part, Word) and part.word_class not in ("REL_IS", "DET", "ONE")
    )
    seen = any("you" in link.said.split() for link in words(parts, "REL_IS"))
    return None if seen else feature_of(word)  # "the cup you see first"


def feature_of(word: Any) -> Feature | Relative | None:
    """What an adjective says of a thing."""
    if not isinstance(word, Word):
        return None
    if word.word_class == "LEFT_RIGHT":
        return Feature("ordinal", _SIDES[word.meaning])
    if word.word_class == "NEAREST":
        return Relative("nearest", ROBOT)
    return Feature(_SLOTS[word.word_class], word.meaning, word.said)


MEANINGS: Mapping[str, Meaning] = MappingProxyType(
    {
        "adjective": _adjective,
        "adjective_word": _adjective_word,
        "on_side": _on_side,
        "from_side": from_side,
        "made_of": _made_of,
        "which_is": _which_is,
        "wearing": _wearing,
    }
)
