"""Transports of which only the thing and two places are said: "three cans from the shelf to the counter"."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from types import MappingProxyType

from executive.language.commands.placing import moved
from executive.language.noun_phrases.arranging import guarded, unfit
from executive.language.phrase_parts import Parts
from executive.language.phrases import Clause, Hand, Item, Meaning, Nominal, Where
from executive.language.words.word import Word


def _transport(parts: Parts) -> Item:
    """A thing, from where to where; what goes to somebody may as well be for him, as a letter is."""
    of, *told = (part for part in parts if not isinstance(part, Word))
    (source,) = (part for part in told if isinstance(part, Nominal))
    (goal,) = (part for part in told if isinstance(part, Where))
    hands = tuple(part for part in told if isinstance(part, Hand))
    named = of.sort == "thing" and not of.anaphoric
    somewhere = all((one.is_place or one.sort == "thing") and not one.reference for one in (source, goal.of))
    if not named or not somewhere or goal.role != "to":
        raise unfit()
    return Item(of, (Where("from", source, "on"), goal, *hands))


def _transports(parts: Parts) -> Clause:
    """One or more of them, which after the things of another command may belong to it."""
    each = [moved((part,), "move") for part in parts if isinstance(part, Item)]
    bundles = tuple(bundle for one in each for bundle in one.bundles)
    return replace(each[0], bundles=bundles, terse=True, topic=True)


MEANINGS: Mapping[str, Meaning] = MappingProxyType(
    {"transport": guarded(_transport), "transports": guarded(_transports)}
)
