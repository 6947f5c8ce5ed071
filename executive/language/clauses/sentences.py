"""Clauses put together to a sentence, unless one of them may mean something else beside the others."""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any

from executive.language.clauses.scopes import UNCLEAR_ORDER, Further, Group, Separator, in_order
from executive.language.clauses.statements import Reason, is_statement
from executive.language.commands.speech import UNQUOTED
from executive.language.phrases.handled_thing import ASKER
from executive.language.phrases.parts import Parts
from executive.language.phrases.values import Clause, Draft, Meaning, Nominal, Trouble

_PERCEIVES = frozenset({"look_at", "find", "describe"})


@dataclass(frozen=True, slots=True)
class Sentence:
    """All clauses; ``unseparated`` counts those that nothing stands before."""

    clauses: tuple[Clause, ...]
    unseparated: int = 0


def _more(parts: Parts) -> Further | None:
    """One more clause; what begins with its thing or place may after a comma belong to what precedes."""
    separator, part = parts
    leans = isinstance(part, Clause) and part.topic and separator < Separator.STOP
    return None if leans else Further(separator, part)


def _without_separator(parts: Parts) -> Further | None:
    (part,) = parts
    if isinstance(part, Group) or part.terse or part.question or is_statement(part):
        return None  # "before you ..." belongs to what was said before it
    return Further(Separator.NOTHING, part)


def _sentence(parts: Parts) -> Sentence | Trouble | None:
    said = [
        part if isinstance(part, Further) else Further(Separator.NOTHING, part)
        for part in parts
        if isinstance(part, (Clause, Group, Further))
    ]
    numbers = [(one.part if isinstance(one.part, Clause) else one.part.first).number for one in said]
    counted = [one for one in numbers if one is not None]
    if counted and (numbers[0] is None or max(counted) - min(counted) != len(counted) - 1):
        return None  # "turn left 90. Move forward": no number of a list
    if counted != sorted(counted):
        return UNCLEAR_ORDER  # "2. open the drawer 1. go to the kitchen"
    clauses = in_order(said)
    if isinstance(clauses, tuple) and len(clauses) > 1 and all(map(_stops, clauses)):
        return Sentence(clauses[:1])  # "whoa, stop right there" is one stop
    revoked = [one.part.revokes for one in said if isinstance(one.part, Clause) and one.part.revokes]
    if revoked and len(said) > 1:
        return Trouble(f"{revoked[0]!r} takes back what was said; nothing is done", revoked[0])
    doubt = _doubt_of_reasons(parts) or (clauses if isinstance(clauses, Trouble) else _doubt_of_clauses(said))
    if doubt is not None or isinstance(clauses, Trouble):
        return doubt
    unseparated = [pair for pair in itertools.pairwise(said) if pair[1].separator is Separator.NOTHING]
    if any(clause.form != "base" for clause in clauses) or any(_run_together(*pair) for pair in unseparated):
        return None
    return Sentence(clauses, len(unseparated))


def _doubt_of_reasons(parts: Parts) -> Trouble | None:
    """What has to be asked of a command and the reason behind it."""
    for before, after in itertools.pairwise(parts):
        last = _last(before)
        if last is not None and last.action == "say" and _goes_on(after):
            return Trouble(UNQUOTED, asks=True)  # "say hello, I'm cold"
        if last is not None and isinstance(after, Reason) and after.of_another and last.get("to") == ASKER:
            return Trouble("to whom?", asks=True)  # "bring a blanket, she is cold"
    return None


def _goes_on(part: Any) -> bool:
    """Whether it states something, and no full stop stands before it."""
    if not isinstance(part, Further):
        return isinstance(part, Reason)
    return is_statement(part.part) and part.separator is not Separator.STOP


def _doubt_of_clauses(said: Sequence[Further]) -> Trouble | None:
    """What is a task of its own when it is said alone, and may be something else beside another one."""
    for one, other in itertools.pairwise(said):
        if is_statement(one.part) and other.separator is Separator.ASKED:
            return Trouble("is that so, or is it asked?", asks=True)  # "the cup is dirty? Put it in the sink"
        if isinstance(one.part, Clause) and isinstance(other.part, Clause):
            question = _doubt_of_two(one.part, other.part, other.separator)
            if question:
                return Trouble(question, asks=True)
    reporting = [last.get("reports") for last in map(_last, said) if last is not None]
    if any(reporting[:-1]) or reporting == ["when"]:
        return Trouble("when what is done?", asks=True)  # "tell me when you are done and go home"
    return None


def _doubt_of_two(first: Clause, second: Clause, separator: Separator) -> str:
    """The question about two clauses; the empty string where there is none."""
    joined = separator in (Separator.AND, Separator.COMMA)
    if joined and first.hand_first and not second.hand_first:
        return "shall all of that be done with the same hand?"
    if joined and _action(first) == _action(second) is not None and not first.bundles[0][0].slots:
        return "once, or twice?"  # "wave, wave to Ana"
    if separator is Separator.COMMA and _stops(second):
        return "shall it be stopped now, or when that is done?"
    if (_is_endless(first) and (first.terse or second.terse)) or (second.terse and _is_endless(second)):
        return "how far in that direction?"  # "go home, backwards"
    return ""


def _run_together(before: Further, after: Further) -> bool:
    """Whether two clauses with nothing between them may be one: "stop pick it up", "wave wave to Ana"."""
    both = [one.part for one in (before, after) if isinstance(one.part, Clause)]
    unclear = any(_stops(one) or _is_endless(one) for one in both) or any(map(_may_go_on, both[:1]))
    return unclear or len(set(map(_action, both)) - {None}) < len((before, after))


def _may_go_on(clause: Clause) -> bool:
    """Whether what follows may be what somebody does whom it names last.

    "Look at Ana open the fridge" asks for no opening, and "bring me the cup, Tom can wave" for no can.
    """
    drafts = [one for bundle in clause.bundles for one in bundle]
    named = [value for one in drafts for _, value in one.slots[:1] if isinstance(value, Nominal)]
    things = [one for one in named if not one.is_person and not one.reference]
    seen = bool(named) and named[-1].is_person and drafts[-1].action in _PERCEIVES
    return seen or (len(things) > 1 and not things[-1].determined)


def _last(part: Any) -> Draft | None:
    """The last task of a part of the sentence, if it has one."""
    part = part.part if isinstance(part, Further) else part
    clause = part.second if isinstance(part, Group) else part
    return clause.bundles[-1][-1] if isinstance(clause, Clause) and clause.bundles else None


def _action(clause: Clause) -> str | None:
    """What a clause begins with, if it commands anything."""
    return clause.bundles[0][0].action if clause.bundles else None


def _is_endless(clause: Clause) -> bool:
    """Whether it ends with a motion of which nobody says how long it takes."""
    last = _last(clause)
    measured = last is not None and (last.get("duration_s") or last.get("distance_m"))
    return last is not None and last.action == "move" and not measured


def _stops(clause: Clause) -> bool:
    return bool(clause.bundles) and all(one.action == "stop" for bundle in clause.bundles for one in bundle)


MEANINGS: Mapping[str, Meaning] = MappingProxyType(
    {"sentence": _sentence, "more": _more, "unseparated": _without_separator}
)
