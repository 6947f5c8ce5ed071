"""Two counts asked for in one breath: "how many cups are on the table and on the shelf?"."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from types import MappingProxyType
from typing import Any

from executive.language.commands.attention import MEANINGS as ATTENTION
from executive.language.noun_phrases.arranging import guarded, unfit
from executive.language.noun_phrases.features import described
from executive.language.phrase_parts import Parts, words
from executive.language.phrases import Feature, Item, Items, Meaning, Nominal, Where


def _count_each(parts: Parts, items: tuple[Item, ...]) -> Any:
    return ATTENTION["count"]((*words(parts, "COUNT", "HOW_MANY"), Items(items)))


def _count_at_each(parts: Parts) -> Any:
    """One count for each of two places, of which neither can be in the other."""
    (of,) = (part for part in parts if isinstance(part, Nominal))
    wheres = [part for part in parts if isinstance(part, Where)]
    if of.sort not in ("thing", "person") or any(not _is_clear(where) for where in wheres):
        raise unfit()
    places = [where.of for where in wheres]
    if len(set(places)) < len(places) or len({place.sort == "room" for place in places}) > 1:
        raise unfit()
    return _count_each(parts, tuple(Item(of, (where,)) for where in wheres))


def _is_clear(where: Where) -> bool:
    place = where.of
    named = place.is_place and place.kind is not None and place.is_single and not place.reference
    return named and where.preposition in ("on", "in") and where.role in ("is", "either")


def _count_of_each(parts: Parts) -> Any:
    """The red and the blue cups: one count for each colour; nobody asks so for cups that are both."""
    noun = next(part for part in reversed(parts) if isinstance(part, Nominal))
    colors = [part for part in parts if isinstance(part, Feature)]
    wheres = tuple(part for part in parts if isinstance(part, Where))
    told = all(one.slot == "color" for one in colors) and len({one.value for one in colors}) == len(colors)
    if not told or not noun.plural or len(words(parts, "DET")) != len(colors):
        raise unfit()
    each = [described(replace(noun, determined=True), (color,)) for color in colors]
    if not all(isinstance(one, Nominal) for one in each) or not all(where.role != "to" for where in wheres):
        raise unfit()
    return _count_each(parts, tuple(Item(one, wheres) for one in each if isinstance(one, Nominal)))


_COMMANDS: Mapping[str, Callable[[Parts], Any]] = {
    "count_at_each": _count_at_each,
    "count_of_each": _count_of_each,
}

MEANINGS: Mapping[str, Meaning] = MappingProxyType(
    {name: guarded(meaning) for name, meaning in _COMMANDS.items()}
)
