"""How far "before" and "after" reach in a sentence of several clauses.

"Before you close the fridge, take out the milk and put it on the table" puts both in front of the closing;
"go to the kitchen and wave after opening the fridge" may open it first of all or in between, which is asked.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum
from typing import Literal

from executive.language.phrases.values import Clause, Trouble
from executive.language.text.word import Word


class Separator(Enum):
    """What stands between two clauses; the order of the members is how strongly it separates."""

    NOTHING = 0
    AND = 1
    COMMA = 2
    THEN = 3
    STOP = 4
    ASKED = 5  # a question mark: what stands before it is no statement


@dataclass(frozen=True, slots=True)
class Group:
    """Clauses that a conjunction puts in order.

    Attributes:
        first: What is done first.
        second: What is done after it.
        scope: Which clause the conjunction stands before as they are said ("first" or "last"), and which of
            them it is that follows in time: ``after_first`` is "after A, B", ``by_then`` "B once A is done".
        doing: Whether the clause after the conjunction is an -ing form, which no other clause can join.
        breaks: Whether a full stop stands before the conjunction: "B. But first, A".
    """

    first: tuple[Clause, ...]
    second: tuple[Clause, ...]
    scope: Literal["after_first", "after_last", "before_first", "before_last", "but_first", "by_then"]
    doing: bool = False
    breaks: bool = False


@dataclass(frozen=True, slots=True)
class Further:
    """A clause or group after the first, and what stands before it.

    ``after_first`` is whether "first" was said right before that: "open the drawer first, then ...";
    ``asked`` is whether a question mark stands there, which ends a sentence as a full stop does.
    """

    separator: Separator
    part: Clause | Group
    after_first: bool = False
    asked: bool = False


UNCLEAR_ORDER = Trouble("in which order shall that be done? say it with 'first' and 'then'", asks=True)
_JOINS = frozenset({"and", "&", "n", "and to"})
_SENTENCE_ENDS = frozenset({".", ";", "!", "paren", ")"})


def separator_of(words: Sequence[Word]) -> Separator:
    """What some marks and joining words are together."""
    found = Separator.NOTHING
    for word in words:
        if word.meaning == "?":
            one = Separator.ASKED
        elif word.word_class == "BULLET" or word.meaning in _SENTENCE_ENDS:
            one = Separator.STOP
        elif word.word_class == "PAUSE":
            one = Separator.COMMA
        else:
            one = Separator.AND if word.said in _JOINS else Separator.THEN
        found = one if one.value > found.value else found
    return found


def in_order(parts: Sequence[Further]) -> tuple[Clause, ...] | Trouble:
    """All clauses as they are to be done.

    Args:
        parts: The sentence; what stands before its first part is left out.
    """
    done: list[Clause] = []
    waiting: tuple[Clause, ...] | None = None
    for index, one in enumerate(parts):
        if one.after_first and (index != 1 or isinstance(parts[0].part, Group)):
            return UNCLEAR_ORDER  # "go home, open the drawer first, then ..."
        separator = one.separator if index else Separator.STOP
        if waiting is not None and separator is not Separator.AND and not _is_listed(parts[index:]):
            if separator is not Separator.STOP:
                return UNCLEAR_ORDER  # "before A, B, then C": is C before A as well?
            done += waiting
            waiting = None
        if isinstance(one.part, Clause):
            done.append(one.part)
            continue
        follows = parts[index + 1].separator if index + 1 < len(parts) else Separator.STOP
        if waiting is not None or not _is_clear(
            one.part, separator if done else Separator.STOP, follows, bool(done)
        ):
            return UNCLEAR_ORDER
        if one.part.scope.startswith("after") and _is_repeated(one.part.first, done):
            return UNCLEAR_ORDER  # "find the cup. After finding it, ...": is it found once, or twice?
        done += one.part.first
        if one.part.scope == "before_first":
            waiting = one.part.second
        else:
            done += one.part.second
    return (*done, *(waiting or ()))


def _is_repeated(first: Sequence[Clause], done: Sequence[Clause]) -> bool:
    """Whether what is done first may be what was ordered already."""
    before, again = (
        {one.action for clause in clauses for bundle in clause.bundles for one in bundle}
        for clauses in (done, first)
    )
    return not before.isdisjoint(again)


def _is_listed(parts: Sequence[Further]) -> bool:
    """Whether commas go on to an "and", as in "before A, B, C and D"."""
    if not parts or parts[0].separator is not Separator.COMMA:
        return False
    rest = next((one for one in parts if one.separator is not Separator.COMMA), None)
    return rest is not None and rest.separator is Separator.AND


def _is_clear(group: Group, separator: Separator, follows: Separator, goes_before: bool) -> bool:
    """Whether the order is the same however far the conjunction reaches."""
    if group.scope == "by_then":
        return follows not in (Separator.NOTHING, Separator.AND, Separator.COMMA)
    if group.scope in ("after_last", "before_last", "but_first") and follows is Separator.NOTHING:
        return False  # "A after B C": is it "after B, C"?
    if group.scope == "but_first":
        return (
            separator is Separator.STOP and not (goes_before and group.breaks) and follows is Separator.STOP
        )
    if group.scope == "after_last":
        joins = not group.doing and follows in (Separator.AND, Separator.COMMA)
        return separator in (Separator.THEN, Separator.STOP) and not joins
    return True
