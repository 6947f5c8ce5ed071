"""How far "before" and "after" reach in a sentence of several clauses.

"Before you close the fridge, take out the milk and put it on the table" puts both in front of the closing;
"go to the kitchen and wave after opening the fridge" may open it first of all or in between, which is asked.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from enum import IntEnum
from types import MappingProxyType
from typing import Any

from executive.language.phrases.parts import Parts, words
from executive.language.phrases.values import Clause, Meaning, Nominal, Trouble


class Separator(IntEnum):
    """What stands between two clauses; the order of the members is how strongly it separates."""

    NOTHING = 0
    AND = 1
    COMMA = 2
    THEN = 3
    STOP = 4
    ASKED = 5  # a question mark: what stands before it is no statement


@dataclass(frozen=True, slots=True)
class Group:
    """Two clauses in the order in which they are done.

    ``order`` is the conjunction, "before" or "after", which ``leads`` where it is said before both clauses.
    """

    first: Clause
    second: Clause
    order: str
    leads: bool


@dataclass(frozen=True, slots=True)
class Further:
    """A clause or group, and what stands before it."""

    separator: Separator
    part: Clause | Group


UNCLEAR_ORDER = Trouble("in which order shall that be done? say it with 'first' and 'then'", asks=True)

_MARKS: Mapping[str, Separator] = {"?": Separator.ASKED, **dict.fromkeys(".;!", Separator.STOP)}
_AND, _AFTER = "and", "after"
"""Meanings of joining words and of conjunctions."""


def _separator(parts: Parts) -> Separator:
    """What some marks and joining words are together."""
    return max(_separates(word) for word in parts)


def _separates(word: Any) -> Separator:
    if word.word_class == "PAUSE":
        return _MARKS.get(word.meaning, Separator.COMMA)
    if word.word_class == "BULLET":
        return Separator.STOP
    return Separator.AND if word.meaning == _AND else Separator.THEN


def _ordered(parts: Parts) -> Group | None:
    """A command, and what is done before it or after it: "after you have opened it", "after opening it"."""
    (conjunction,) = words(parts, "AFTER", "AFTER_DOING", "BEFORE")
    leads = parts[0] is conjunction
    clauses = [part for part in parts if isinstance(part, Clause)]
    main, other = reversed(clauses) if leads else clauses
    separator = next((part for part in parts if isinstance(part, Separator)), Separator.NOTHING)
    form = "ed" if words(parts, "HAVE") else "base" if words(parts, "YOU_DO") else "ing"
    if main.form != "base" or other.form != form:
        return None
    if leads and separator is Separator.NOTHING and main.terse:
        return None  # "before taking the apple home, wave" does not begin to wave at home
    if not leads and separator >= Separator.THEN:
        return None  # "A. Before B, C": a full stop ends what the conjunction belongs to
    other = replace(other, form="base")
    if conjunction.meaning == _AFTER:
        return Group(other if leads else _said_after(other, main), main, _AFTER, leads)
    if leads or _takes_out(main):
        main = _said_after(main, other)
    return Group(main, replace(other, said_first=leads), conjunction.meaning, leads)


def _takes_out(command: Clause) -> bool:
    """Whether it takes something out of what may be named behind it: "take it out before closing the box"."""
    return any(one.get("out") and one.get("source") is None for bundle in command.bundles for one in bundle)


def _said_after(done_first: Clause, said_first: Clause) -> Clause:
    """A clause with what "it" may stand for that is named before it, in what is done after it."""
    drafts = [one for bundle in said_first.bundles for one in bundle]
    opens = any(bundle[0].action == "open" for bundle in done_first.bundles)
    named = [
        value
        for one in drafts
        for _, value in one.slots
        if isinstance(value, Nominal)
        and (one.action == "close" or opens or value.sort in ("thing", "any", "name", "person"))
    ]
    fitting = [one for one in named if one.is_single and not one.reference]
    if any(one.action == "say" for one in drafts):
        fitting = [one for one in fitting if not one.is_person]  # "him" may be somebody in words to say
    return replace(done_first, said_before=tuple(dict.fromkeys(fitting)))


def in_order(parts: Sequence[Further]) -> tuple[Clause, ...] | Trouble:
    """All clauses of a sentence as they are to be done, or the question for their order."""
    done: list[Clause] = []
    waiting: list[Clause] = []
    for index, one in enumerate(parts):
        before = one.separator if index else Separator.STOP
        follows = parts[index + 1].separator if index + 1 < len(parts) else Separator.STOP
        if waiting and before is not Separator.AND:
            if before < Separator.STOP:
                return UNCLEAR_ORDER  # "before A, B, then C": is C before A as well?
            done += waiting
            waiting = []
        if isinstance(one.part, Clause):
            done.append(one.part)
            continue
        group = one.part
        again = group.order == _AFTER and not _actions([group.first]).isdisjoint(_actions(done))
        if waiting or again or not _is_clear(group, before, follows):
            return UNCLEAR_ORDER  # "find the cup. After finding it, ...": is it found once, or twice?
        done.append(group.first)
        (waiting if group.leads and group.order != _AFTER else done).append(group.second)
    return (*done, *waiting)


def _actions(clauses: Sequence[Clause]) -> set[str]:
    return {one.action for clause in clauses for bundle in clause.bundles for one in bundle}


def _is_clear(group: Group, before: Separator, follows: Separator) -> bool:
    """Whether the order is the same however far the conjunction reaches."""
    if group.leads:
        return True
    if follows is Separator.NOTHING:
        return False  # "A after B C": is it "after B, C"?
    joins = follows in (Separator.AND, Separator.COMMA)
    return group.order != _AFTER or (before >= Separator.THEN and not joins)


MEANINGS: Mapping[str, Meaning] = MappingProxyType({"separator": _separator, "ordered": _ordered})
