"""What was done to one thing, done to another: "take the red cup, then do the same with the green one"."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from types import MappingProxyType

from executive.language.noun_phrases.arranging import Arranged, arranged, guarded, unfit
from executive.language.phrase_parts import Parts
from executive.language.phrases import Bundle, Clause, Draft, Meaning, Nominal, Trouble, draft

_SAME = "same"
_DONE_AGAIN = frozenset(
    {
        "pick",
        "place",
        "put_in",
        "hand_over",
        "open",
        "close",
        "find",
        "point_at",
        "look_at",
        "describe",
        "wave",
    }
)


def _same(parts: Parts) -> Clause:
    """What it is done to; what that is, the clause before it says."""
    each = arranged(parts)
    if any(one.goal is not None or one.back or one.hand or one.person is not None for one in each):
        raise unfit()
    return Clause(tuple(map(_with, each)), "base")


def _with(one: Arranged) -> Bundle:
    of = one.object
    if of.reference or of.count != 1 or of.plural or not of.determined:
        raise unfit()
    return (draft(_SAME, object=of, source=one.source),)


def with_the_same(clauses: Sequence[Clause]) -> tuple[Clause, ...] | Trouble:
    """The clauses with what is done again; what that is has to be all that was said before."""
    done: list[Clause] = []
    told: list[Clause] = []
    for one in clauses:
        if not _is_same(one):
            done.append(one)
            told.append(one)
            continue
        before = told[0].bundles if len(told) == 1 else ()
        again = tuple(_again(before[0], bundle[0]) for bundle in one.bundles) if len(before) == 1 else (None,)
        bundles = tuple(bundle for bundle in again if bundle is not None)
        if len(bundles) < len(one.bundles):
            return Trouble("what shall be done with it?", asks=True)
        done.append(replace(one, bundles=bundles))
    return tuple(done)


def _is_same(clause: Clause) -> bool:
    return bool(clause.bundles) and all(bundle[0].action == _SAME for bundle in clause.bundles)


def _again(before: Bundle, same: Draft) -> Bundle | None:
    """What was done before, done to another of the same sort; None where that is not clear."""
    first, *rest = before
    slot = "object" if first.get("object") is not None else "person"
    old, new, source = first.get(slot), same.get("object"), same.get("source")
    if first.action not in _DONE_AGAIN or not isinstance(old, Nominal) or old.reference:
        return None
    if new.sort != old.sort and not (new.anaphoric and not old.is_person):
        return None
    if new.is_plain and source is None and (new.anaphoric or new.kind == old.kind):
        return None  # "put the red cup there, do the same with the cup"
    kept = tuple((name, new if name == slot else value) for name, value in first.slots if name != "count")
    again = replace(first, slots=kept)
    if source is not None:
        again = replace(again, slots=tuple(one for one in again.slots if one[0] != "source"))
        again = again.with_slot("source", source)
    return (again, *rest)


MEANINGS: Mapping[str, Meaning] = MappingProxyType({"same": guarded(_same)})
