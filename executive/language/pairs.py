"""A thing for somebody, in one breath: "Ana the cup", "Ana her cup", "us the biscuits"."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from types import MappingProxyType

from executive.language.arranging import ME
from executive.language.genders import may_be
from executive.language.lattice import Word
from executive.language.phrase_parts import Parts, words
from executive.language.phrases import Item, Meaning, Nominal, Pair, Trouble


def _us(_parts: Parts) -> Nominal:
    """Who asks, where something is handed over; nobody else is waved to, looked at or gone to."""
    return ME


def _pair(parts: Parts) -> Pair | None:
    person, item = (part for part in parts if not isinstance(part, Word))
    if (
        not isinstance(person, Nominal)
        or not (person.is_person or person.reference == "them")
        or item.of.is_person
    ):
        return None
    return Pair(person, item)


def _pair_for_us(parts: Parts) -> Pair | Trouble | None:
    """A thing for whoever speaks for several: "us the biscuits", but not "us both a beer"."""
    item = next(part for part in parts if isinstance(part, Item))
    if item.of.counted and item.of.count in ("both", "all"):
        return Trouble("one for each of you, or all of them?", asks=True)
    return _pair(parts)


def _own_pair(parts: Parts) -> Pair | Trouble | None:
    """A thing for whom it belongs to: "Ana her cup"."""
    (owns,) = words(parts, "WHOSE")
    made = _pair(tuple(part for part in parts if part is not owns))
    if made is None:
        return None
    of = made.item.of
    if of.determined or of.reference or of.anaphoric or of.kind is None or of.name is not None:
        return None
    known = made.person.sort in ("name", "person") and not made.person.reference
    if not known or not may_be("him" if owns.meaning == "his" else owns.meaning, made.person):
        return Trouble(f"{owns.said!r}: whose it is cannot be told", owns.said)
    if of.kind in ("glass", "glasses"):
        if not of.plural:
            return None
        of = replace(of, kind="glasses", plural=False, paired=True)  # those to see with
    name = f"{made.person.said or made.person.kind}'s {of.kind}"
    own = replace(of, name=name, determined=True, owner=made.person)
    return Pair(made.person, replace(made.item, of=own))


MEANINGS: Mapping[str, Meaning] = MappingProxyType(
    {"us": _us, "pair": _pair, "pair_for_us": _pair_for_us, "own_pair": _own_pair}
)
