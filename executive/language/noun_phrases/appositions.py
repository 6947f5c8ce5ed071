"""What is said once more of a thing to tell it from others: "the blue ball, the big one"."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from types import MappingProxyType
from typing import Any

from executive.language.noun_phrases.features import SUPERLATIVES
from executive.language.phrase_parts import Parts, words
from executive.language.phrases import Hand, Item, Meaning, Nominal, Trouble, Where
from executive.language.words.word import Word

_TELLS = ("color", "size", "material", "ordinal")
_QUANTITIES = frozenset({"both", "all"})
"""What "them" may be of several things that were just named: "both of them", "all of them"."""
_OF_WHAT_IS_HANDLED = frozenset({"small", "big", "smaller", "bigger", "smallest", "biggest"})
"""Sizes by which things are told apart rather than the furniture that they are on."""


def told_once_more(first: Item, second: Item) -> Item | None:
    """One thing of two that only a comma parts, if the second can be no other one; else None.

    "The one" is told by what the first says and by more; what contradicts it ("the red cup, the blue
    one") may be another thing, and so may be what is said behind a place ("the cup from the shelf, the
    blue one"), but for its mere size ("the cup from the shelf, the small one"). Of a rank it is not said
    among which things it is counted: "the biggest cup, the red one".
    """
    places = [one for one in first.details if not isinstance(one, Hand)]
    if not all(map(_is_where_it_is_taken, places)) or not _may_be_told(first.of):
        return None
    quantity = _quantity(first.of, second.of)
    told = _narrowed(first.of, second.of) if quantity is None else quantity
    if told is None or second.too or (places and (second.details or not _tells_mere_size(first.of, told))):
        return None
    return Item(told, (*first.details, *second.details), first.too)


def _is_where_it_is_taken(detail: Any) -> bool:
    """Whether it is "from" furniture that no more is said of."""
    plain = isinstance(detail, Where) and detail.of.is_place and detail.of.is_plain
    return plain and detail.role == "from" and detail.relation is None and detail.of.sort != "room"


def _tells_mere_size(of: Nominal, told: Nominal) -> bool:
    return told.size in _OF_WHAT_IS_HANDLED and told == replace(of, size=told.size)


def _may_be_told(of: Nominal) -> bool:
    named = of.sort not in ("me", "you", "name", "animal") and of.kind is not None and of.reference is None
    return named and not of.anaphoric and of.determined and not of.indefinite and of.ordinal != "other"


def _quantity(of: Nominal, again: Nominal) -> Nominal | None:
    """With how many there are: "my shoes, both of them"."""
    told = again.reference == "them" and again.said in _QUANTITIES
    same = of.count == again.said or (of.count, again.said) == (2, "both")
    is_open = of.plural and (same or not of.counted)
    return replace(of, count=again.said, counted=True) if told and is_open else None


def _narrowed(of: Nominal, again: Nominal) -> Nominal | None:
    """With what "the one" says of it besides."""
    bare = not (again.determined and again.anaphoric and again.said) or again.indefinite or again.whose
    if bare or again.ordinal == "other" or again.plural != of.plural or again.counted or of.count != 1:
        return None
    more = {name: value for name in _TELLS if (value := getattr(again, name)) is not None}
    if any(getattr(of, name) not in (None, value) for name, value in more.items()):
        return None
    ranked = of.ordinal is not None or of.size in SUPERLATIVES or of.relation is not None
    if (ranked and (more or again.relation is not None)) or again.name is not None:
        return None
    told = replace(of, **more)
    placed: Nominal | Trouble = told if again.relation is None else told.placed(again.relation)
    return placed if isinstance(placed, Nominal) else None


def _apposed(parts: Parts) -> Item | None:
    """Between two commas, before what is said of both: "the cup, the red one, to Ana"."""
    if any(mark.meaning != "," for mark in words(parts, "PAUSE")):
        return None
    of, again, *details = (part for part in parts if not isinstance(part, Word))
    told = told_once_more(Item(of), replace(again, details=tuple(map(_where_it_is, again.details))))
    return None if told is None else replace(told, details=(*told.details, *details))


def _where_it_is(detail: Any) -> Any:
    """A place that is enclosed with "the one" tells it from others: nothing goes there."""
    is_open = isinstance(detail, Where) and detail.role == "either"
    return replace(detail, role="is") if is_open else detail


MEANINGS: Mapping[str, Meaning] = MappingProxyType({"apposed": _apposed})
