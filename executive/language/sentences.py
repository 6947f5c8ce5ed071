"""Clauses put in the order in which they are to be done."""

from __future__ import annotations

import itertools
from collections.abc import Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import Any, Literal

from executive.language import (
    amounts,
    arrivals,
    attention,
    chores,
    counted_apart,
    features,
    going,
    handling,
    lists,
    nominals,
    one_after_another,
    pairs,
    places,
    placing,
    quantities,
    sharing,
    speech,
    statements,
    turns,
    two_verbs,
    waiting,
)
from executive.language.arrivals import as_done, at_last, done_by_then
from executive.language.begun_by import begun_by, in_base_form
from executive.language.brief_tasks import takes_a_moment
from executive.language.fronted import fronted
from executive.language.lattice import Word
from executive.language.neighbours import WITH_A_HAND, is_endless, runs_together, stops, unclear_among
from executive.language.phrase_parts import Parts, words
from executive.language.phrases import Clause, Draft, Hand, Meaning, Nominal, Trouble, Where
from executive.language.scopes import UNCLEAR_ORDER, Further, Group, Separator, in_order, separator_of
from executive.language.speech import UNQUOTED
from executive.language.statements import is_statement, may_be_said, with_places
from executive.language.told import as_told, told_or_done


@dataclass(frozen=True, slots=True)
class Sentence:
    """All clauses; ``unseparated`` counts those that nothing stands before."""

    clauses: tuple[Clause, ...]
    unseparated: int = 0


class _Nothing:
    """A part that says nothing of its own."""

    __slots__ = ()


NOTHING = _Nothing()


def _nothing(_parts: Parts) -> Any:
    return NOTHING


@dataclass(frozen=True, slots=True)
class _Numbered:
    """Which one of a numbered list a command is."""

    number: int


def _list_number(parts: Parts) -> _Numbered | None:
    is_mark = parts[-1].word_class == "BULLET" or parts[-1].meaning in (".", ")", ":", "paren")
    return _step_number(parts) if is_mark else None


def _step_number(parts: Parts) -> _Numbered | None:
    (said,) = words(parts, "NUM", "AMOUNT", "LETTER")
    return _Numbered(int(said.meaning)) if said.meaning.isdecimal() else None


def _clause(parts: Parts) -> Clause | None:
    """A command, with what was said before it."""
    command: Clause = parts[-1]
    if any(mark.meaning not in (",", ":") for mark in words(parts, "PAUSE")):
        return None  # "the cup. With your left hand. Wave"
    if sum(isinstance(part, _Numbered) for part in parts) > 1:
        return None  # "turn left 90. 2. Wave"
    for part in parts[:-1]:
        if isinstance(part, Where) and part.of.reference == "there" and _goes(command):
            command = replace(command, terse=True)  # else it belongs to what was said before
            continue
        slot = (
            ("hand", part.side)
            if isinstance(part, Hand)
            else ("source", part.of)
            if isinstance(part, Where)
            else None
        )
        if isinstance(part, _Numbered):
            command = replace(command, number=part.number)
        if isinstance(part, Where) and part.role == "is":
            if not _is_taken_or_seen(command):
                return None  # "in the kitchen, put the cup on the table"
            command = replace(command, placed=True)
        if slot is not None:  # "take the cup with the right, wave", "... from the table, wave": of which?
            command = replace(command, terse=True)
        if isinstance(part, Hand):
            command = replace(command, hand_first=True)
        if slot is not None:
            changed = _with_slot(command, *slot)
            if changed is None:
                return None
            command = changed
    return command


def _you_do(parts: Parts) -> Clause | None:
    """A command that begins with who is to do it: "you take the cup"."""
    command = as_told(parts[-1])
    if command is None:
        return None
    clause = _clause((*(part for part in parts[:-1] if not isinstance(part, Word)), command))
    return None if clause is None else replace(clause, terse=True)


def _briefly(parts: Parts) -> Clause | None:
    *said, moment = parts
    return _clause(tuple(said)) if takes_a_moment(said[-1], moment.said) else None


def _there_first(parts: Parts) -> Clause | None:
    """There, pick up the box: at the place that was gone to just before."""
    command: Clause = parts[-1]
    if words(parts, "THERE")[0].said != "there" or command.form != "base" or command.question:
        return None
    if any(mark.meaning != "," for mark in words(parts, "PAUSE")):
        return None
    arrived = _clause((*(part for part in parts[:-1] if isinstance(part, _Numbered)), command))
    if arrived is None:
        return None
    there = Nominal("any", reference="there")
    if _is_taken_or_seen(command):
        arrived = _with_slot(arrived, "source", there)
    return None if arrived is None else replace(arrived, bundles=((at_last(),), *arrived.bundles))


def _is_taken_or_seen(command: Clause) -> bool:
    """Whether a place before it can only be where its thing is."""
    return all(bundle[0].action in ("pick", "find", "count", "describe") for bundle in command.bundles)


def _goes(command: Clause) -> bool:
    """Whether it goes somewhere, where "from there" says nothing."""
    return all(one.action in ("walk_to", "move", "go_home") for bundle in command.bundles for one in bundle)


def _clause_with_hand(parts: Parts) -> Clause | Trouble | None:
    """A command with a hand before it; a mere "right," may be no more than how one begins to speak."""
    side = words(parts, "LEFT_RIGHT")[0]
    if not words(parts, "HAND", "USE") and side.said in ("left", "right"):
        return Trouble(f"is {side.said!r} the hand to use?", side.said, asks=True)
    joined = [part for part in parts if isinstance(part, Separator)]
    orders = any(word.said == "use" for word in words(parts, "USE"))
    if not orders and any(one.value >= Separator.THEN.value for one in joined):
        return None  # "take the cup with the right. Wave"
    return _clause((Hand(side.meaning), *words(parts, "PAUSE"), parts[-1]))


_STEPS = ("first", "second", "third", "fourth", "fifth", "sixth")


def _ordinal_step(parts: Parts) -> _Numbered | None:
    said = parts[0].meaning
    return _Numbered(_STEPS.index(said) + 1) if said in _STEPS else None


_TAKES = {
    "hand": WITH_A_HAND,
    "source": frozenset({"pick", "place", "put_in", "hand_over", "find", "count", "describe"}),
}


def _with_slot(command: Clause, name: str, value: Any) -> Clause | None:
    bundles = []
    for bundle in command.bundles:
        first, *rest = bundle
        if first.action not in _TAKES[name] or first.get(name) not in (None, value):
            return None
        bundles.append((_filled(first, name, value), *rest))
    return replace(command, bundles=tuple(bundles))


def _filled(first: Draft, name: str, value: Any) -> Draft:
    return first if first.get(name) is not None else first.with_slot(name, value)


def _clauses(parts: Parts) -> list[Clause]:
    return [part for part in parts if isinstance(part, Clause)]


def _done_before(parts: Parts) -> Clause | None:
    (clause,) = _clauses(parts)
    return as_done(clause) if clause.form == "ed" else None


def _belongs_before(one: Any, other: Any) -> bool:
    """Whether nothing parts the first words of a clause from the one before: "close it in the hall, wave"."""
    return isinstance(one, Clause) and isinstance(other, Clause) and (other.placed or other.topic)


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
        if scope.startswith("after") and not but_first:
            others = tuple(done_by_then(clause) for clause in others)
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
        if isinstance(value, Nominal) and (one.action == "close" or opens or value.sort in ("thing", "any"))
    ]
    fitting = (one for one in named if one.is_single and not one.reference and not one.is_person)
    return replace(done_first, said_before=tuple(dict.fromkeys(fitting)))


def _sentence(parts: Parts) -> Sentence | Trouble | None:
    placed = with_places(parts)
    if placed is None:
        return None
    parts = placed
    said = [
        part if isinstance(part, Further) else Further(Separator.NOTHING, part)
        for part in parts
        if isinstance(part, (Clause, Group, Further))
    ]
    begun = in_base_form(said)
    if isinstance(begun, Trouble):
        return begun
    said = begun
    told = told_or_done(one.part for one in said if isinstance(one.part, Clause))
    if told is not None:
        return told if isinstance(told, Trouble) else None
    if may_be_said(parts):
        return Trouble(UNQUOTED, asks=True)
    if any(after.asked and is_statement(before.part) for before, after in itertools.pairwise(said)):
        return Trouble("is that so, or is it asked?", asks=True)  # "the cup is dirty? Put it in the sink"
    clauses = in_order(said)
    if isinstance(clauses, Trouble):
        return clauses
    numbers = [_number_of(one.part) for one in said]
    counted = [one for one in numbers if one is not None]
    if any(after <= before for before, after in itertools.pairwise(counted)):
        return UNCLEAR_ORDER  # "2. open the drawer 1. go to the kitchen"
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
    if "ed" in forms or len(forms) > 1 or (unseparated and "ing" in forms):
        return None
    if runs_together(said):
        return None
    return unclear_among(said) or Sentence(tuple(clauses), unseparated)


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


def _more_at_last(parts: Parts) -> Further | None:
    """With "at the end" behind what is done at the place where the robot then is, last of all commands.

    What is taken or opened "at the end" may stand there: "go to the shelf and take the box at the end".
    """
    part = parts[1]
    bundles = part.bundles
    if (
        part.form != "base"
        or not bundles
        or any(not _is_gesture(one) for bundle in bundles for one in bundle)
    ):
        return None
    return _more_afterwards((parts[0], replace(part, begun="last"), parts[2]))


def _is_gesture(one: Draft) -> bool:
    """Whether it is done without going to or telling apart anything: it has no place of its own."""
    waved_at = one.get("person")
    plain = waved_at is None or (isinstance(waved_at, Nominal) and waved_at.sort in ("me", "name"))
    return one.action in ("say", "go_home") or (one.action == "wave" and plain)


def _separator(parts: Parts) -> Separator:
    return separator_of(parts)


MEANINGS: Mapping[str, Meaning] = MappingProxyType(
    {
        **features.MEANINGS,
        **amounts.MEANINGS,
        **nominals.MEANINGS,
        **lists.MEANINGS,
        **places.MEANINGS,
        **quantities.MEANINGS,
        **pairs.MEANINGS,
        **handling.MEANINGS,
        **placing.MEANINGS,
        **going.MEANINGS,
        **attention.MEANINGS,
        **speech.MEANINGS,
        **sharing.MEANINGS,
        **statements.MEANINGS,
        **arrivals.MEANINGS,
        **chores.MEANINGS,
        **two_verbs.MEANINGS,
        **turns.MEANINGS,
        **one_after_another.MEANINGS,
        **counted_apart.MEANINGS,
        **waiting.MEANINGS,
        "nothing": _nothing,
        "list_number": _list_number,
        "step_number": _step_number,
        "ordinal_step": _ordinal_step,
        "clause": _clause,
        "you_do": _you_do,
        "briefly": _briefly,
        "begun_by": begun_by,
        "clause_with_hand": _clause_with_hand,
        "fronted": fronted,
        "there_first": _there_first,
        "done_before": _done_before,
        "after_first": _ordered("after_first"),
        "after_last": _ordered("after_last"),
        "before_first": _ordered("before_first"),
        "before_last": _ordered("before_last"),
        "sentence": _sentence,
        "unseparated": _without_separator,
        "more": _more,
        "more_afterwards": _more_afterwards,
        "more_at_last": _more_at_last,
        "doing_too": _doing_too,
        "done_first": _done_first,
        "separator": _separator,
    }
)
