"""Several things that the same is done to: lists, alternatives, and what is said again of one thing."""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from executive.language.phrases.features import described
from executive.language.phrases.parts import Parts, nominal_of, words
from executive.language.phrases.values import (
    Benefit,
    Feature,
    Hand,
    Item,
    Items,
    Meaning,
    Nominal,
    Relative,
    Trouble,
    Where,
)
from executive.language.text.word import Word

SORTS_OF_THINGS = frozenset(
    {"food", "fruit", "vegetable", "drink", "snack", "dish", "utensil", "tool", "toy", "game", "clothes"}
)
"""What a noun behind a comma may say more exactly: "my drink, the juice"."""


@dataclass(frozen=True, slots=True)
class Joined:
    """What stands between two things of a list; with ``commas`` nothing but those; ``then`` is one later."""

    commas: bool
    then: bool = False


def _joined(parts: Parts) -> Joined | None:
    if any(mark.meaning in (".", "!", "?") for mark in words(parts, "PAUSE")):
        return None  # "walk to the kitchen. The shelf": what about the shelf?
    said = words(parts, "AND")
    return Joined(not said, any(word.meaning == "then" for word in said))


def _item(parts: Parts) -> Item | Trouble | None:
    """A noun with its details; "people in the kitchen who are waving" is told by what is said last too."""
    features = tuple(part for part in parts[1:] if isinstance(part, Feature))
    of = described(parts[0], features)
    details = tuple(part for part in parts[1:] if not isinstance(part, (Word, Feature)))
    return Item(of, details) if isinstance(of, Nominal) else of


def _centre(parts: Parts) -> Nominal | None:
    """The table's centre, as what stands there is told by: the table."""
    (place,), (rank,) = words(parts, "FURNITURE"), words(parts, "ORDINAL")
    return Nominal("furniture", place.meaning, determined=True) if rank.meaning == "middle" else None


def _item_from_centre(parts: Parts) -> Item | Trouble | None:
    """What is in the middle of a piece of furniture, among those that stand on it."""
    nominal, _, place, *details = parts
    told = _item((nominal, Feature("ordinal", "middle"), *details))
    if not isinstance(told, Item):
        return told
    return replace(told, details=(Where("from", place, "on"), *told.details))


def _items(parts: Parts) -> Items | Trouble | None:
    """A list; what stands after no more than a comma may say again what stands before it."""
    each = tuple(part for part in parts if isinstance(part, Item))
    links = [part for part in parts if isinstance(part, Joined)]
    if any(link.then and item.details for link, item in zip(links, each[1:], strict=True)):
        return None  # "the cup, then the bottle to Ana": is the cup for her too?
    if len(each) > 1 and any(one.of.sort == "you" or one.of.is_bare_one for one in each):
        return None  # "take the cup, you left it there"; "a cup to Ana and one to Ben"
    both = len(each) == 2 and all(one.of.determined and not one.of.plural for one in each)
    if words(parts, "BOTH") and not both:
        return None
    for (first, second), link in zip(itertools.pairwise(each), links, strict=True):
        unclear = said_again(first.of, second.of, (link,)) or _shared_adjective(first.of, second.of)
        if unclear is not None:
            return unclear
    apart = all(one.details for one in each) or not all(link.commas for link in links)
    return Items(each) if apart or len(each) == 1 else _one_or_two(each[0].of, each[1].of)


def said_again(before: Nominal, last: Nominal, links: Iterable[Any]) -> Trouble | None:
    """The cup, the red one: after a mere comma it may be told again which thing is meant."""
    commas = any(isinstance(link, Joined) and link.commas for link in links)
    sort = before.kind in SORTS_OF_THINGS or (before.sort == "any" and not before.reference)
    same = last.anaphoric or sort or (last.kind is not None and last.kind == before.kind)
    return _one_or_two(before, last) if commas and same else None


def _one_or_two(before: Nominal, last: Nominal) -> Trouble:
    both = f"{spoken(before)}, {spoken(last)}"
    return Trouble(f"{both}: is this one thing or two? say 'and' between two", asks=True)


def _shared_adjective(first: Nominal, second: Nominal) -> Trouble | None:
    """The red cup and bottle: whether the bottle is red too is not said."""
    told = first.color or first.size or first.material
    bare = second.is_plain and not (second.determined or second.plural or second.reference)
    if not (told and first.determined and bare and second.sort == "thing") or second.paired:
        return None
    both = f"{spoken(first)} and {second.kind}"
    return Trouble(f"{both}: shall the {second.kind} be {told} too? say 'the' before it", asks=True)


def another_of(last: Nominal, before: Sequence[Nominal]) -> Nominal:
    """What "the bottom one" is after "the top drawer of the desk": a drawer, and of the desk too.

    Where the first is "next to the sink", that may hold of the other or not.
    """
    kinds = {(one.sort, one.kind) for one in before}
    if not last.anaphoric or len(kinds) != 1 or last.is_plain:
        return last
    first = before[0]
    inside = first.relation is not None and first.relation.kind == "in"
    if first.relation is not None and not inside and last.relation is None:
        return last
    return replace(last, sort=first.sort, kind=first.kind, relation=last.relation or first.relation)


def _alternatives(parts: Parts) -> Trouble:
    each = tuple(spoken(part.of) for part in parts if isinstance(part, Item))
    return Trouble(f"{' or '.join(each)}: which one is meant?", asks=True, choices=each)


def _two_of_a_kind(parts: Parts) -> Items | Trouble | None:
    """The red and the blue box, the red and blue boxes: one of each, or all of each."""
    noun = nominal_of(parts)
    features = [part for part in parts if isinstance(part, (Feature, Relative))]
    if noun is None or len(words(parts, "DET")) != (1 if noun.plural else len(features)):
        return None
    if noun.plural and len({feature.slot for feature in features if isinstance(feature, Feature)}) != 1:
        return None  # "the red and big cups" may be both
    ranked = any(isinstance(one, Feature) and one.slot == "ordinal" for one in features)
    noun = replace(noun, determined=True, plural=noun.plural and not ranked)
    each = [described(noun, (feature,)) for feature in features]
    details = tuple(part for part in parts if isinstance(part, (Where, Hand, Benefit)))
    items = tuple(Item(one, details) for one in each if isinstance(one, Nominal))
    return Items(items) if len(items) == len(each) else None


def spoken(nominal: Nominal) -> str:
    """A short description for questions."""
    if nominal.sort in ("name", "me") and nominal.kind is not None:
        return nominal.kind
    attributes = (nominal.ordinal, nominal.size, nominal.color, nominal.material, nominal.kind or "one")
    return " ".join(["the", *(one for one in attributes if one)])


MEANINGS: Mapping[str, Meaning] = {
    "item": _item,
    "item_from_centre": _item_from_centre,
    "centre": _centre,
    "items": _items,
    "joined": _joined,
    "alternatives": _alternatives,
    "two_of_a_kind": _two_of_a_kind,
}
