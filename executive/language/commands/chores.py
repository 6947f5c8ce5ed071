"""A chore and how it is to be done: "clear the table by putting the cup in the sink and the can in the bin".

The chore itself is no skill of the robot; what follows "by", or a colon, is. What is cleared or tidied is
where the things are.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from types import MappingProxyType

from executive.language.clauses.scopes import Group
from executive.language.noun_phrases.arranging import guarded, trouble, unfit
from executive.language.phrase_parts import Parts, words
from executive.language.phrases import Clause, Draft, Meaning, Nominal

_TIDIES = frozenset({"place", "put_in", "hand_over", "pick"})


def _by_doing(parts: Parts) -> Group:
    (chore,), (mark,) = words(parts, "CHORE"), words(parts, "BY_DOING", "PAUSE")
    of = next((part for part in parts if isinstance(part, Nominal)), None)
    clauses = [part for part in parts if isinstance(part, Clause)]
    forms = {one.form for one in clauses}
    expected = {"base"} if mark.meaning == ":" else {"ing"}
    if mark.meaning not in ("by", ":", ",") or forms != expected:
        raise unfit()
    if of is not None and (not of.is_place or not of.is_plain):
        raise unfit()
    source = of if chore.meaning == "clear" else None
    if not all(_TIDIES & {one.action for one in bundle} for each in clauses for bundle in each.bundles):
        raise unfit()
    done = tuple(_taken_from(replace(one, form="base"), source) for one in clauses)
    about = () if of is None else (of,)
    return Group((replace(done[0], about=(*done[0].about, *about)), *done[1:]), (), "after_first", doing=True)


def _chore(parts: Parts) -> None:
    (chore,) = words(parts, "CHORE")
    of = next((part for part in parts if isinstance(part, Nominal)), None)
    if of is not None and not of.is_place:
        raise unfit()
    raise trouble(
        f"housework ({chore.said!r}) is no skill of this robot yet; say what goes where", chore.said
    )


def _taken_from(clause: Clause, source: Nominal | None) -> Clause:
    """The clause with where its things are, unless it says so."""

    def told(one: Draft) -> Draft:
        thing = one.get("object")
        named = isinstance(thing, Nominal) and thing.sort in ("thing", "any") and not thing.reference
        free = (
            one.action in _TIDIES
            and one.get("source") is None
            and source not in (one.get("to"), one.get("on"))
        )
        return one.with_slot("source", source) if named and free else one

    if source is None:
        return clause
    return replace(clause, bundles=tuple((told(first), *rest) for first, *rest in clause.bundles))


MEANINGS: Mapping[str, Meaning] = MappingProxyType({"by_doing": guarded(_by_doing), "chore": guarded(_chore)})
