"""Several things that the same is done to: lists, alternatives, and what is said again of one thing."""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import Any

from executive.language.phrases.features import described
from executive.language.phrases.parts import Parts, nominal_of, words
from executive.language.phrases.values import Feature, Item, Items, Meaning, Nominal, Relative, Trouble, Where
from executive.language.text.word import Word

SORTS_OF_THINGS = frozenset(
    {"thing", "fruit", "vegetable", "utensil", "tool", "toy", "drink", "snack", "container", "food"}
    | {"cutlery", "silverware", "crockery", "clothes", "jewelry", "medicine", "game", "present", "gift"}
)
"""What a noun after a comma may say more exactly: "the blue thing, the cup"; "my drink, the juice"."""

_LATER = frozenset({"then", "after", "afterward", "afterwards", "finally", "followed"})


def _item(parts: Parts) -> Item:
    return Item(parts[0], tuple(part for part in parts[1:] if not isinstance(part, Word)))


def _item_too(parts: Parts) -> Item:
    return replace(_item(parts), too=True)


@dataclass(frozen=True, slots=True)
class Joined:
    """What stands between two things of a list; with ``commas`` nothing but those; ``then`` is one later.

    ``company`` is "together with": whoever is named so may be meant to come along.
    """

    commas: bool
    then: bool = False
    company: bool = False


def _joined(parts: Parts) -> Joined | None:
    if any(mark.meaning in (".", "!", "?") for mark in words(parts, "PAUSE")):
        return None  # "walk to the kitchen. The shelf": what about the shelf?
    said = [one for word in words(parts, "AND") for one in word.said.split()]
    return Joined(not said, not _LATER.isdisjoint(said), "with" in said)


def has_company(parts: Parts) -> bool:
    """Whether somebody is to come along: "go to the table together with Ana"."""
    return any(isinstance(part, Joined) and part.company for part in parts)


def named_together(goals: Sequence[Any], parts: Parts) -> tuple[Nominal, ...]:
    """The places before the last one, unless that is said to come later: "to the table and to the shelf".

    "There" may then be any of them, where "to the table, then to the shelf" leaves but the last one.
    """
    links = [part for part in parts if isinstance(part, Joined)]
    if not links or links[-1].then:
        return ()
    return tuple(goal for goal in goals[:-1] if isinstance(goal, Nominal) and goal.is_place)


def _items(parts: Parts) -> Items | Trouble | None:
    """A list; after a mere comma the last may say again which thing is meant: "the cup, the red one"."""
    each = with_others([part for part in parts if isinstance(part, Item)])
    links = [part for part in parts if isinstance(part, Joined)]
    if len(links) == len(each) - 1:
        each, links = _named_at_last(each, links)
    if len(each) > 1 and any(one.of.sort == "you" for one in each):
        return None  # "take the cup, you left it there"
    if len(each) > 1 and len(links) == len(each) - 1:
        placed = bool(each[-2].details and each[-1].details) and not _may_be_one(each[-2].of, each[-1].of)
        unclear = None if placed else said_again(each[-2].of, each[-1].of, links[-1:])
        for (first, second), link in zip(itertools.pairwise(each), links, strict=True):
            if unclear is None and _may_be_one(first.of, second.of):
                unclear = said_again(first.of, second.of, (link,))
        if any(not is_told_beside(first.of, second.of) for first, second in itertools.pairwise(each)):
            return None
        unclear = (
            unclear or said_twice(each, links) or _told_later(each, links) or _may_come_along(each, links)
        )
        if unclear is not None:
            return unclear
    return shared_adjective(each) or served_with(each) or Items(_with_article(each))


def served_with(each: Iterable[Item]) -> Trouble | None:
    """Coffee with milk and sugar: whether the sugar is in it is not said."""
    for first, second in itertools.pairwise(each):
        of = second.of
        bare = of.is_plain and (of.mass or of.plural) and not (of.determined or of.counted or of.reference)
        if first.of.laced and bare and not second.details:
            return Trouble(f"with {of.said} too, or shall the {of.said} come by itself?", asks=True)
    return None


def _named_at_last(each: tuple[Item, ...], links: list[Joined]) -> tuple[tuple[Item, ...], list[Joined]]:
    """With "that thing, the stapler" as one thing: nobody counts a thing without a name among others."""
    for index, link in enumerate(links):
        first, second = each[index], each[index + 1]
        features = ("color", "size", "material", "ordinal")
        if not (link.commas and is_nameless(first.of) and second.of.sort == "thing" and second.of.determined):
            continue
        told = {one: getattr(first.of, one) or getattr(second.of, one) for one in features}
        same = all(getattr(second.of, one) in (None, told[one]) for one in features)
        if not same or second.of.indefinite or not second.of.is_single or (first.details and second.details):
            continue
        named = Item(replace(second.of, **told), (*first.details, *second.details), second.too)
        return (*each[:index], named, *each[index + 2 :]), [*links[:index], *links[index + 1 :]]
    return each, links


def is_nameless(of: Nominal) -> bool:
    """Whether it is "that thing", of which no more than adjectives is told."""
    nameless = of.sort == "any" and of.kind is None and not of.anaphoric and of.reference is None
    return nameless and of.is_single and of.determined and not of.indefinite and of.relation is None


def is_told_beside(before: Nominal, of: Nominal) -> bool:
    """Whether what is named without its noun is told as the one before is: "the red cup and the blue"."""
    if not of.anaphoric or of.said or of.ordinal == "other":
        return True
    told = [name for name in ("color", "size", "ordinal") if getattr(of, name) is not None]
    return all(getattr(before, name) is not None for name in told)


def with_others(each: Sequence[Item]) -> tuple[Item, ...]:
    """With "one" after "a cup" as another one: "a cup to Ana and one to Ben"."""
    others = list(each)
    for index in range(1, len(others)):
        before, of = others[0].of, others[index].of
        any_one = before.indefinite or (before.counted and before.count == 1)
        if any_one and of.anaphoric and of.is_plain and of.is_single and not of.determined:
            others[index] = replace(others[index], of=replace(of, ordinal="other", determined=True))
    return tuple(others)


def _in_your_hand(_parts: Parts) -> Trouble:
    """The apple you are holding: no sentence alone tells which one it is, and another would be looked for."""
    told = "what is in the hand is called by its own words, or 'it' after it was picked up"
    return Trouble(told, "holding")


def _with_article(each: tuple[Item, ...]) -> tuple[Item, ...]:
    """With the article of the first: "the cups and saucers"."""
    first = each[0].of
    if not (first.determined and first.plural and first.is_plain) or first.counted:
        return each
    return tuple(
        replace(one, of=replace(one.of, determined=True)) if _is_bare_plural(one.of) else one for one in each
    )


def _is_bare_plural(nominal: Nominal) -> bool:
    return nominal.plural and nominal.is_plain and not (nominal.counted or nominal.reference)


def _both_items(parts: Parts) -> Items | Trouble | None:
    """Both the cup and the bottle: one of each."""
    each = tuple(part for part in parts if isinstance(part, Item))
    if not all(one.of.is_single and one.of.determined and one.of.reference is None for one in each):
        return None
    return None if any(link.commas for link in parts if isinstance(link, Joined)) else _items(parts)


def _may_be_one(before: Nominal, last: Nominal) -> bool:
    """Whether "the one next to the can" may be what was named just before it, and no other of its kind."""
    told = ("color", "size", "material", "ordinal")
    return last.anaphoric and all(
        getattr(last, name) is None or getattr(before, name) in (None, getattr(last, name)) for name in told
    )


def said_twice(each: Iterable[Item], links: Iterable[Any]) -> Trouble | None:
    """The question whether two things of a list, with no more than a comma between, are one."""
    items, joined = tuple(each), [link for link in links if isinstance(link, Joined)]
    for (first, second), link in zip(itertools.pairwise(items), joined, strict=False):
        if link.commas and _may_say_it_again(first, second, len(items)):
            return _one_or_two(first.of, second.of)
    return None


def _may_say_it_again(first: Item, second: Item, among: int) -> bool:
    """Whether two things with a comma between may be one: there are but two, or it is a sort of thing."""
    if first.details or first.of.reference or first.of.is_person != second.of.is_person:
        return False
    names_a_sort = first.of.sort in ("thing", "any") and first.of.kind in (None, *SORTS_OF_THINGS)
    return names_a_sort or (among == 2 and not second.details)


def _told_later(each: Iterable[Item], links: Iterable[Joined]) -> Trouble | None:
    """The cup, then the bottle to Ana: whether the cup is for her too is not said."""
    for (first, second), link in zip(itertools.pairwise(each), links, strict=False):
        goes = any(isinstance(one, Where) and one.role == "to" for one in second.details)
        if link.then and second.details and (goes or not first.details):
            return Trouble(f"does that hold for {spoken(first.of)} too? say it as two sentences", asks=True)
    return None


def _may_come_along(each: Iterable[Item], links: Iterable[Joined]) -> Trouble | None:
    """Wave to Ana together with Ben: he may be who waves too."""
    for (_, second), link in zip(itertools.pairwise(each), links, strict=False):
        if link.company and second.of.is_person:
            return Trouble(f"is it done to {spoken(second.of)} too, or together?", asks=True)
    return None


def said_again(before: Nominal, last: Nominal, links: Iterable[Any]) -> Trouble | None:
    """The cup, the red one: after a mere comma it may be told again which thing is meant."""
    commas = any(isinstance(link, Joined) and link.commas for link in links)
    if not commas or not (last.anaphoric or (last.kind is not None and last.kind == before.kind)):
        return None
    return _one_or_two(before, last)


def another_of(last: Nominal, before: Sequence[Nominal]) -> Nominal:
    """What "the bottom one" is after "the top drawer of the desk": a drawer, and of the desk too.

    It stays what it is where several sorts of things were named, or where the first is "next to the sink",
    which may hold of the other or not.
    """
    kinds = {(one.sort, one.kind) for one in before}
    if not last.anaphoric or len(kinds) != 1 or last.is_plain:
        return last
    first = before[0]
    inside = first.relation is not None and first.relation.kind == "in"
    if first.relation is not None and not inside and last.relation is None:
        return last
    return replace(last, sort=first.sort, kind=first.kind, relation=last.relation or first.relation)


def _one_or_two(before: Nominal, last: Nominal) -> Trouble:
    question = "is this one thing or two? say 'and' between two"
    return Trouble(f"{spoken(before)}, {spoken(last)}: {question}", asks=True)


def shared_adjective(each: Iterable[Item]) -> Trouble | None:
    """The red cup and bottle: whether the bottle is red too is not said."""
    for first, second in itertools.pairwise(one.of for one in each):
        told = first.color or first.size or first.material
        bare = second.is_plain and not (second.determined or second.plural or second.reference)
        if told and first.determined and bare and second.sort == "thing" and not second.paired:
            question = f"shall the {second.kind} be {told} too? say 'the' before it"
            return Trouble(f"{spoken(first)} and {second.kind}: {question}", asks=True)
    return None


def _only_item(parts: Parts) -> Item:
    item: Item = parts[-1]
    return item


def _alternatives(parts: Parts) -> Trouble:
    each = tuple(spoken(part.of) for part in parts if isinstance(part, Item))
    return Trouble(f"{' or '.join(each)}: which one is meant?", asks=True, choices=each)


def _alternatives_of_a_kind(parts: Parts) -> Trouble | None:
    features = [part for part in parts if isinstance(part, (Feature, Relative))]
    noun = nominal_of(parts)
    each = [described(noun, (feature,)) for feature in features]
    names = tuple(spoken(one) for one in each if isinstance(one, Nominal))
    return (
        Trouble(f"{' or '.join(names)}: which one is meant?", asks=True, choices=names)
        if len(names) == 2
        else None
    )


def _two_of_a_kind(parts: Parts) -> Items | Trouble | None:
    """The red and the blue box: two boxes; or more than two."""
    noun = nominal_of(parts)
    features = [part for part in parts if isinstance(part, (Feature, Relative))]
    if noun is None or len(words(parts, "DET")) != (1 if noun.plural else len(features)):
        return None
    if noun.plural and len({feature.slot for feature in features if isinstance(feature, Feature)}) != 1:
        return None  # "the red and big cups" may be both
    ranked = any(isinstance(one, Feature) and one.slot == "ordinal" for one in features)
    noun = replace(noun, determined=True, plural=noun.plural and not ranked)
    each = [described(noun, (feature,)) for feature in features]
    trouble = next((one for one in each if isinstance(one, Trouble)), None)
    if trouble is not None:
        return trouble
    details = tuple(
        part for part in parts if isinstance(part, Where) or type(part).__name__ in ("Hand", "Benefit")
    )
    return Items(tuple(Item(one, details) for one in each if isinstance(one, Nominal)))


def spoken(nominal: Nominal) -> str:
    """A short description for questions."""
    if nominal.sort in ("name", "me") and nominal.kind is not None:
        return nominal.kind
    attributes = (nominal.ordinal, nominal.size, nominal.color, nominal.material, nominal.kind or "one")
    return " ".join(["the", *(one for one in attributes if one)])


MEANINGS: Mapping[str, Meaning] = MappingProxyType(
    {
        "item": _item,
        "item_too": _item_too,
        "items": _items,
        "in_your_hand": _in_your_hand,
        "both_items": _both_items,
        "joined": _joined,
        "only_item": _only_item,
        "alternatives": _alternatives,
        "alternatives_of_a_kind": _alternatives_of_a_kind,
        "two_of_a_kind": _two_of_a_kind,
    }
)
