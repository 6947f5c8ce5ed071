"""Clauses put in the order in which they are to be done."""

from __future__ import annotations

import itertools
from collections.abc import Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import Any, Literal

from executive.language.clauses.given_reasons import are_reasons_fit, doubts_of_reasons
from executive.language.clauses.neighbours import is_endless, runs_together, stops, unclear_among
from executive.language.clauses.scopes import UNCLEAR_ORDER, Further, Group, Separator, in_order, separator_of
from executive.language.clauses.statements import is_statement
from executive.language.phrases.parts import Parts, words
from executive.language.phrases.values import Clause, Meaning, Nominal, Trouble


@dataclass(frozen=True, slots=True)
class Sentence:
    """All clauses; ``unseparated`` counts those that nothing stands before."""

    clauses: tuple[Clause, ...]
    unseparated: int = 0


def _clauses(parts: Parts) -> list[Clause]:
    return [part for part in parts if isinstance(part, Clause)]


def _done_before(parts: Parts) -> Clause | None:
    (clause,) = _clauses(parts)
    return replace(clause, form="base") if clause.form == "ed" else None


def _belongs_before(one: Any, other: Any) -> bool:
    """Whether nothing parts the first words of a clause from the one before: "closing it in the hall, wave".

    "Before taking the apple home, wave" does not begin to wave at home either.
    """
    both = isinstance(one, Clause) and isinstance(other, Clause)
    return both and (other.placed or other.topic or other.terse)


def _ordered(scope: Literal["after_first", "after_last", "before_first", "before_last"]) -> Meaning:
    """Two clauses, one of them after a conjunction, which asks for a form of its own."""

    def meaning(parts: Parts) -> Group | None:
        clauses = _clauses(parts)
        if any(_belongs_before(one, other) for one, other in itertools.pairwise(parts)):
            return None
        expected = "base" if words(parts, "YOU_DO", "AFTER", "BUT_FIRST") else "ing"
        main = clauses.pop(0 if scope.endswith("last") else -1)
        if any(one.form != expected for one in clauses) or main.form != "base":
            return None
        but_first = bool(words(parts, "BUT_FIRST"))
        apart = any(one in parts for one in (Separator.ASKED, Separator.STOP, Separator.THEN))
        if scope.endswith("last") and apart and not but_first:
            return None  # "A. Before B, C": a full stop ends what the conjunction belongs to
        others = tuple(replace(clause, form="base") for clause in clauses)
        if scope == "before_first":
            main = _said_after(main, others)
            others = tuple(replace(clause, said_first=True) for clause in others)
        if scope == "before_last" and _takes_out(main):
            main = _said_after(main, others)  # "take the pen out before closing the drawer"
        if scope == "after_last" and not but_first:
            others = tuple(_said_after(one, (main,)) for one in others)
        return Group(
            others if scope.startswith("after") else (main,),
            (main,) if scope.startswith("after") else others,
            "but_first" if but_first else scope,
            doing=expected == "ing",
            breaks=but_first and (Separator.STOP in parts or Separator.ASKED in parts),
        )

    return meaning


def _takes_out(command: Clause) -> bool:
    return any(one.get("out") and one.get("source") is None for bundle in command.bundles for one in bundle)


def _said_after(done_first: Clause, said_first: tuple[Clause, ...]) -> Clause:
    """A clause with what "it" may stand for that is named before it, in what is done after it."""
    opens = any(bundle[0].action == "open" for bundle in done_first.bundles)
    named = [
        value
        for clause in said_first
        for bundle in clause.bundles
        for one in bundle
        for _, value in one.slots
        if isinstance(value, Nominal)
        and (one.action == "close" or opens or value.sort in ("thing", "any", "name", "person"))
    ]
    fitting = [one for one in named if one.is_single and not one.reference]
    if any(one.action == "say" for clause in said_first for bundle in clause.bundles for one in bundle):
        fitting = [one for one in fitting if not one.is_person]  # "him" may be somebody in words to say
    return replace(done_first, said_before=tuple(dict.fromkeys(fitting)))


def _sentence(parts: Parts) -> Sentence | Trouble | None:
    said = [
        part if isinstance(part, Further) else Further(Separator.NOTHING, part)
        for part in parts
        if isinstance(part, (Clause, Group, Further))
    ]
    doubt = doubts_of_reasons(parts)
    if doubt is not None:
        return doubt
    if not are_reasons_fit(parts):
        return None
    if any(after.asked and is_statement(before.part) for before, after in itertools.pairwise(said)):
        return Trouble("is that so, or is it asked?", asks=True)  # "the cup is dirty? Put it in the sink"
    clauses = in_order(said)
    if isinstance(clauses, Trouble):
        return clauses
    numbers = [_number_of(one.part) for one in said]
    counted = [one for one in numbers if one is not None]
    if any(after <= before for before, after in itertools.pairwise(counted)):
        return UNCLEAR_ORDER  # "2. open the drawer 1. go to the kitchen"
    if counted and counted[0] > 1 and clauses[0].spelled:
        return None  # "two: wave"
    if counted and (numbers[0] is None or counted[-1] - counted[0] != len(counted) - 1):
        return None  # "turn left 90. Move forward": no number of a list
    unseparated = sum(one.separator is Separator.NOTHING for one in said[1:])
    if any(_reports(one) for one in clauses[:-1]):
        return UNCLEAR_ORDER  # "tell me when you are done and go home"
    if len(clauses) == 1 and _reports(clauses[0]) == "when":
        return Trouble("when what is done?", asks=True)
    revoked = next((one.revokes for one in clauses if one.revokes), None)
    if len(clauses) > 1 and all(stops(clause) for clause in clauses):
        return Sentence(tuple(clauses[:1]))
    if revoked is not None and len(clauses) > 1:
        return Trouble(f"{revoked!r} takes back what was said; nothing is done", revoked)
    if any(after.terse and is_endless(before) for before, after in itertools.pairwise(clauses)):
        return None  # "turn left, then right 90 degrees": how far to the left?
    forms = {clause.form for clause in clauses}
    if forms - {"base"}:
        return None
    if runs_together(said) or any(map(_is_begun_twice, said, said[1:])):
        return None
    return unclear_among(said) or Sentence(tuple(clauses), unseparated)


def _is_begun_twice(before: Further, after: Further) -> bool:
    """Whether the same is done again with nothing between: "wave wave to Ana" may be one wave or two."""
    clauses = [one.part for one in (before, after) if isinstance(one.part, Clause) and one.part.bundles]
    return after.separator is Separator.NOTHING and len({one.bundles[0][0].action for one in clauses}) < len(
        clauses
    )


def _reports(clause: Clause) -> Any:
    """Whether it is to be said that all is done, which is "when" it is."""
    return clause.bundles[0][0].get("reports") if clause.bundles else None


def _number_of(part: Clause | Group) -> int | None:
    """Which one of a numbered list it is."""
    clauses = (part,) if isinstance(part, Clause) else (*part.first, *part.second)
    return next((one.number for one in clauses if one.number is not None), None)


def _without_separator(parts: Parts) -> Further | None:
    (part,) = parts
    if isinstance(part, Group) or part.terse or part.question or is_statement(part):
        return None  # "before you ..." belongs to what was said before it
    return Further(Separator.NOTHING, part)


def _doing_too(parts: Parts) -> Clause | None:
    """One more clause after "before" or "after": an -ing form, which cannot be the command itself."""
    (clause,) = _clauses(parts)
    return clause if clause.form == "ing" else None


def _done_first(parts: Parts) -> Further | None:
    """What follows "open the drawer first, then"."""
    said = _more(parts[-2:])
    return None if said is None else replace(said, after_first=True)


def _more(parts: Parts) -> Further | None:
    separator, part = parts
    if separator is Separator.COMMA and isinstance(part, Clause) and part.placed:
        return None  # "find the cup, in the kitchen, take the bowl"
    if isinstance(part, Clause) and part.topic and separator not in (Separator.STOP, Separator.ASKED):
        return None
    asked = separator is Separator.ASKED
    return Further(Separator.STOP if asked else separator, part, asked=asked)


def _more_afterwards(parts: Parts) -> Further | None:
    """With "after that" behind what it is said of: "and wave after that"."""
    said = _more(parts[:-1])
    if said is None:
        return None
    return said if said.separator is Separator.STOP else replace(said, separator=Separator.THEN)


def _separator(parts: Parts) -> Separator:
    return separator_of(parts)


MEANINGS: Mapping[str, Meaning] = MappingProxyType(
    {
        "done_before": _done_before,
        "after_first": _ordered("after_first"),
        "after_last": _ordered("after_last"),
        "before_first": _ordered("before_first"),
        "before_last": _ordered("before_last"),
        "sentence": _sentence,
        "unseparated": _without_separator,
        "more": _more,
        "more_afterwards": _more_afterwards,
        "doing_too": _doing_too,
        "done_first": _done_first,
        "separator": _separator,
    }
)
