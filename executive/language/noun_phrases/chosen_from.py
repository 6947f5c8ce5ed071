"""One of several things that stand before the command: "of the bowls on the table, pick up the biggest"."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from types import MappingProxyType
from typing import Any

from executive.language.commands.handling import MEANINGS as HANDLING
from executive.language.commands.placing import HOLDERS
from executive.language.noun_phrases.arranging import Arranged, arranged, guarded, unfit
from executive.language.phrase_parts import Parts, words
from executive.language.phrases import Bundle, Clause, Item, Meaning, Nominal, Where
from executive.language.words.word import Word

_CHOOSES = frozenset({"pick", "place", "put_in", "hand_over", "find", "point_at", "look_at", "describe"})
"""Tasks of one thing that is chosen."""

_WITH_A_PLACE = frozenset({"pick", "place", "put_in", "hand_over", "find", "describe"})
"""Those of them that can say where it is."""


def _takes(parts: Parts) -> Word:
    """The verb of a command whose noun is left out."""
    verb: Word = parts[0]
    return verb


def _out_of_these(parts: Parts) -> Clause:
    """The command with the kind of the things before it, and with where they are."""
    command: Clause = parts[-1]
    these = next(part for part in parts if isinstance(part, Item))
    return _chosen(these, command, parts)


def _picked_of_these(parts: Parts) -> Clause:
    """The same where the noun is left out: "... pick up the biggest"."""
    these, one = (part for part in parts if isinstance(part, Item))
    (verb,) = words(parts, "PICK_UP", "PICK", "FETCH")
    taken = HANDLING["fetch" if verb.word_class == "FETCH" else "pick"]((verb, one))
    if not isinstance(taken, Clause):
        raise unfit()
    return _chosen(these, taken, parts)


def _chosen(these: Item, command: Clause, parts: Parts) -> Clause:
    mark = words(parts, "PAUSE")[0]
    stays = all(isinstance(one, Where) and one.role in ("is", "either") for one in these.details)
    if mark.meaning != "," or not stays or len(command.bundles) != 1:
        raise unfit()
    if these.of.kind in HOLDERS and any(word.meaning == "from" for word in words(parts, "AMONG")):
        raise unfit()  # "from the boxes, take the biggest one": a box, or what is in one?
    (among,) = arranged((these,))
    return replace(command, bundles=(_one_of(among, command.bundles[0]),), terse=True)


def _one_of(among: Arranged, bundle: Bundle) -> Bundle:
    of, (first, *rest) = among.object, bundle
    one: Any = first.get("object")
    several = of.plural and of.determined and of.sort == "thing" and not of.reference and of.is_plain
    if not several or of.count == "both" or first.action not in _CHOOSES:
        raise unfit()
    if not isinstance(one, Nominal) or not one.anaphoric or one.is_plain or one.count != 1 or one.plural:
        raise unfit()
    if among.source is not None and (first.action not in _WITH_A_PLACE or first.get("source") is not None):
        raise unfit()
    told = first.replacing("object", replace(one, kind=of.kind, sort=of.sort, anaphoric=False))
    return (told.with_slot("source", among.source), *rest)


_COMMANDS = {"takes": _takes, "out_of_these": _out_of_these, "picked_of_these": _picked_of_these}

MEANINGS: Mapping[str, Meaning] = MappingProxyType(
    {name: guarded(meaning) for name, meaning in _COMMANDS.items()}
)
