"""A thing for somebody, in one breath: "Ana the cup", "Ana her cup", "us the biscuits"."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from executive.language.commands.handling import given, handed, picked, recipient
from executive.language.phrases.arranging import ME, Arranged, arranged, clause, guarded, trouble, unfit
from executive.language.phrases.parts import Parts, always, words
from executive.language.phrases.values import (
    Clause,
    Items,
    Meaning,
    Nominal,
    Pair,
    Trouble,
)
from executive.language.resolve.genders import may_be
from executive.language.text.word import Word


def _pair(parts: Parts) -> Pair | Trouble | None:
    """Who gets what: "Ana the cup and the bottle"."""
    person, items = (part for part in parts if not isinstance(part, Word))
    gets = isinstance(person, Nominal) and (person.is_person or person.reference == "them")
    if not gets or any(one.of.is_person for one in items.each):
        return None
    shared = next((one.of.count for one in items.each if one.of.count in ("both", "all")), None)
    if person is ME and shared:
        return Trouble("one for each of you, or all of them?", asks=True)  # "us both a beer"
    return Pair(person, items)


def _own_pair(parts: Parts) -> Pair | Trouble | None:
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
    own = replace(item, of=replace(of, name=name, determined=True, owner=person))
    return Pair(person, Items((own,)))


def _pairs(parts: Parts) -> list[tuple[Nominal, Arranged]]:
    """Who gets what: "me the cup and the can, Ana the box"."""
    pairs = [part for part in parts if isinstance(part, Pair)]
    if any(pair.person.reference == "him" for pair in pairs[1:]):
        raise trouble("who is meant?", asks=True)  # "give Ben the cup and her the bottle": not Ben
    result = [(recipient(pair.person), one) for pair in pairs for one in arranged((pair.items,))]
    if any(one.goal is not None or one.is_for_another for _, one in result):
        raise unfit()
    return result


def _pairs_given(parts: Parts) -> Clause:
    """Everybody gets theirs; what is brought is picked up first."""
    gives = bool(words(parts, "GIVE"))
    return clause(
        parts,
        [given(one, who) if gives else handed(picked(one, fetched=True), who) for who, one in _pairs(parts)],
    )


MEANINGS: Mapping[str, Meaning] = {
    "us": always(ME),
    "pair": _pair,
    "own_pair": _own_pair,
    "bring_pairs": guarded(_pairs_given),
    "give_pairs": guarded(_pairs_given),
}
