"""Two verbs for one thing: "locate and pick up the cup", "pick and place the cup on the table"."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from types import MappingProxyType

from executive.language.noun_phrases.arranging import form_of, guarded, unfit
from executive.language.noun_phrases.handled_thing import PREVIOUS
from executive.language.phrase_parts import Parts, words
from executive.language.phrases import Bundle, Clause, Draft, Meaning, Nominal

_TAKEN = frozenset({"pick", "place", "put_in", "hand_over", "point_at", "look_at"})
_SLOTS = {"find": ("object", "source", "count"), "pick": ("object", "source", "count", "hand")}
"""What of the second verb's task is said of the first one's."""


def _two_verbs(parts: Parts) -> Clause:
    command: Clause = parts[-1]
    (joined,) = words(parts, "AND")
    first = "find" if words(parts, "FIND") else "pick"
    if joined.said not in ("and", "and then") or form_of(parts[:1]) != command.form:
        raise unfit()
    return replace(command, bundles=tuple(_both(first, bundle) for bundle in command.bundles))


def _both(action: str, bundle: Bundle) -> Bundle:
    """The second verb's tasks with the first one's before them, unless these begin with it."""
    then, *rest = bundle
    of = then.get("object")
    if then.action not in _TAKEN or not isinstance(of, Nominal) or of.reference:
        raise unfit()
    if then.action == action:
        return bundle
    slots = _SLOTS[action]
    before = Draft(action, tuple(slot for slot in then.slots if slot[0] in slots))
    left = tuple(slot for slot in then.slots if slot[0] not in (*slots, "fetched", "out"))
    return (before, Draft(then.action, (("object", PREVIOUS), *left)), *rest)


MEANINGS: Mapping[str, Meaning] = MappingProxyType({"two_verbs": guarded(_two_verbs)})
