"""A thing for somebody, in one breath: "Ana the cup", "Ana her cup", "us the biscuits"."""

from __future__ import annotations

import itertools
from collections.abc import Mapping
from dataclasses import replace

from executive.language.commands.handling import given, handed, picked, recipient
from executive.language.phrases.arranging import ME, arranged, clause, guarded, trouble, unfit
from executive.language.phrases.parts import Parts, always, words
from executive.language.phrases.values import Benefit, Clause, Item, Items, Meaning, Nominal, Trouble
from executive.language.resolve.people import may_be
from executive.language.text.word import Word


def _pair(parts: Parts) -> Items | Trouble | None:
    """Who gets what: "Ana the cup and the bottle"."""
    person, items = (part for part in parts if not isinstance(part, Word))
    gets = isinstance(person, Nominal) and (person.is_person or person.reference == "them")
    if not gets or any(one.of.is_person for one in items.each):
        return None
    shared = next((one.of.count for one in items.each if one.of.count in ("both", "all")), None)
    if person is ME and shared:
        return Trouble("one for each of you, or all of them?", asks=True)  # "us both a beer"
    return _for(person, items.each)


def _for(person: Nominal, each: tuple[Item, ...]) -> Items:
    """For somebody; what is said of the last of them holds for those before it of which nothing is said."""
    *others, last = (replace(one, details=(*one.details, Benefit(person))) for one in each)
    return Items((*(new if old.details else old for old, new in zip(each, others, strict=False)), last))


def _own_pair(parts: Parts) -> Items | Trouble | None:
    """A thing for whom it belongs to: "Ana her cup"."""
    (owns,) = words(parts, "WHOSE")
    person, item = (part for part in parts if not isinstance(part, Word))
    of = item.of
    if of.determined or of.plural or of.kind is None or of.name is not None:
        return None
    known = person.sort in ("name", "person") and not person.reference
    if not known or not may_be(owns.meaning, person):
        return Trouble(f"{owns.said!r}: whose it is cannot be told", owns.said)
    name = f"{person.said or person.kind}'s {of.kind}"
    return _for(person, (replace(item, of=replace(of, name=name, determined=True, owner=person)),))


def _given(parts: Parts) -> Clause:
    """Everybody gets theirs, "me the cup and the can, Ana the box"; what is brought is picked up first."""
    each = [arranged((part,)) for part in parts if isinstance(part, Items)]
    if any(one.person is not None and one.person.reference == "him" for pair in each[1:] for one in pair):
        raise trouble("who is meant?", asks=True)  # "give Ben the cup and her the bottle": not Ben
    bundles = []
    for one in itertools.chain.from_iterable(each):
        if one.goal is not None or one.person is None:
            raise unfit()
        gives, person = words(parts, "GIVE"), recipient(one.person)
        bundles.append(given(one, person) if gives else handed(picked(one, fetched=True), person))
    return clause(parts, bundles)


MEANINGS: Mapping[str, Meaning] = {
    "us": always(ME),
    "pair": _pair,
    "own_pair": _own_pair,
    "bring_pairs": guarded(_given),
    "give_pairs": guarded(_given),
}
