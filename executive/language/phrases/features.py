"""What tells a thing or a person from others: adjectives, sides, materials, and what is seen of people."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from executive.language.phrases.parts import Parts, nominal_of, words
from executive.language.phrases.values import Feature, Meaning, Nominal, Relative, Trouble
from executive.language.text.word import Word

WEIGHTS = frozenset({"heaviest", "lightest"})
"""What nobody sees: it may be asked about, and nothing is chosen by it."""

SUPERLATIVES = WEIGHTS | {"smallest", "biggest", "tallest", "shortest", "longest", "thinnest", "widest"}
"""Sizes that one thing has among those in view."""

COUNTED_FROM = frozenset({"first", "second", "third", "fourth", "fifth", "sixth"})
"""Ranks that are counted from a side."""

ROBOT = Nominal("you", "robot")

_SLOTS = {
    "COLOR": "color",
    "SIZE": "size",
    "COMPARED": "size",
    "WEIGHT": "size",
    "MATERIAL": "material",
    "ORDINAL": "ordinal",
    "ANOTHER": "ordinal",
    "TRAIT": "traits",
}
_SIDES = {"left": "leftmost", "right": "rightmost"}
_ENDS = frozenset({"leftmost", "rightmost", "middle", "top", "bottom", "front", "back"})
"""Ranks of a thing that is said to be at an end, or in the middle, of a row."""

_FROM_SIDE = "from side"
"""The slot of the side that things are counted from."""


def described(nominal: Nominal | Trouble | None, parts: Parts) -> Nominal | Trouble | None:
    """The nominal with every feature among the parts."""
    for part in parts:
        if not isinstance(nominal, Nominal):
            return nominal
        if isinstance(part, Feature) and part.slot == _FROM_SIDE:
            nominal = nominal.counted_from(part.value) if nominal.ordinal in COUNTED_FROM else None
        elif isinstance(part, Feature):
            nominal = nominal.described(part)
        elif isinstance(part, Relative):
            nominal = nominal.placed(part)
        elif isinstance(part, Word) and part.word_class == "ANOTHER":
            nominal = nominal.described(Feature("ordinal", part.meaning))
    return nominal


def of_noun(meaning: Callable[[Nominal, Parts], Any]) -> Meaning:
    """A meaning that is made of the noun among the parts, with every feature among them."""

    def run(parts: Parts) -> Any:
        nominal = described(nominal_of(parts), parts)
        return meaning(nominal, parts) if isinstance(nominal, Nominal) else nominal

    return run


def _adjective(parts: Parts) -> Feature | Relative | None:
    """Before its noun or behind it: "red", "made of wood", "that is red"; not "the cup you see first"."""
    *_, word = words(parts, *_SLOTS, "LEFT_RIGHT", "NEAREST")
    if any(link.meaning == "seen" for link in words(parts, "REL_IS")):
        return None
    if word.word_class == "NEAREST":
        return Relative("nearest", ROBOT)
    slot = _SLOTS.get(word.word_class, "ordinal")
    return Feature(slot, _SIDES[word.meaning] if word.word_class == "LEFT_RIGHT" else word.meaning)


def _on_side(parts: Parts) -> Feature | Trouble | None:
    """On the left, in the middle."""
    (side,) = words(parts, "LEFT_RIGHT", "ORDINAL")
    if any(word.meaning in ("my", "our") for word in words(parts, "DET")):
        return Trouble("left and right are seen from the robot; which side is meant?", asks=True)
    rank = _SIDES.get(side.meaning, side.meaning)
    before = rank == "front" and not words(parts, "DET")  # "the person in front"
    return Feature("ordinal", rank) if rank in _ENDS and not before else None


def _from_side(parts: Parts) -> Feature:
    """Counted from the left, or from the right."""
    return Feature(_FROM_SIDE, _SIDES[words(parts, "LEFT_RIGHT")[0].meaning])


def _wearing(parts: Parts) -> Feature | Trouble:
    """Wearing a red shirt: a garment and its colour, as people's clothes are seen."""
    (garment,) = words(parts, "GARMENT", "GARMENTS")
    colors = words(parts, "COLOR")
    if len(colors) != 1:
        told = "people are told from others by what they wear and its colour"
        return Trouble(f"{garment.said!r}: of which colour? {told}", asks=True)
    return Feature("traits", f"{colors[0].meaning} {garment.meaning}")


MEANINGS: Mapping[str, Meaning] = {
    "adjective": _adjective,
    "on_side": _on_side,
    "from_side": _from_side,
    "told_after": _adjective,
    "wearing": _wearing,
}
