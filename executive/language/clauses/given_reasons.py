"""Why a command was given, before it or after it: "it's beeping", "because she just got home".

A reason changes nothing about the command, and names nothing that may be meant after it.
"""

from __future__ import annotations

import itertools
from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any

from executive.language.clauses.scopes import Further, Group, Separator
from executive.language.clauses.statements import is_statement
from executive.language.commands.speech import UNQUOTED
from executive.language.phrases.handled_thing import ASKER
from executive.language.phrases.parts import Parts, words
from executive.language.phrases.values import Clause, Meaning, Nominal, Trouble

_OPPOSITES = {"open": "close", "closed": "open"}
"""What is done to something because it is open, or closed."""

_SOMEBODY_ELSE = frozenset({"he", "she", "they"})


@dataclass(frozen=True, slots=True)
class Reason:
    """Why a command was given.

    Attributes:
        state: Whether it says that something is "open" or "closed", which only the opposite follows from.
        of_another: Whether it is about somebody of whom nobody says who it is: "she is cold".
        wants_it: Whether it says who needs the thing, who then is to get it.
    """

    state: str = ""
    of_another: bool = False
    wants_it: bool = False


def _reason(parts: Parts) -> Reason:
    said = [one for word in words(parts, "SPEAKER_IS", "SOMEBODY") for one in word.said.split("'")[0].split()]
    return Reason(of_another=not _SOMEBODY_ELSE.isdisjoint(said), wants_it=bool(words(parts, "NEEDS_IT")))


def _reason_state(parts: Parts) -> Reason:
    return Reason(state="open" if words(parts, "OPENED") else "closed")


def _reason_blocks(parts: Parts) -> Reason | None:
    """What the robot is in the way of: furniture and rooms, which no "it" behind it stands for."""
    of = parts[-1]
    in_the_way = isinstance(of, Nominal) and (of.sort in ("me", "name") or (of.is_place and not of.reference))
    return Reason() if in_the_way else None


def _reason_after(parts: Parts) -> Reason | None:
    reason: Reason | None = parts[-1]
    return reason


def doubts_of_reasons(parts: Parts) -> Trouble | None:
    """What has to be asked of a command and the reason behind it; None where nothing has."""
    for before, after in itertools.pairwise(parts):
        if _goes_on(after) and _last_action(before) == "say":
            return Trouble(UNQUOTED, asks=True)  # "say hello, I'm cold"
        if isinstance(after, Reason) and after.of_another and _for_whoever_asks(before):
            return Trouble("to whom?", asks=True)  # "bring a blanket, she is cold"
    return None


def are_reasons_fit(parts: Parts) -> bool:
    """Whether nothing is opened because it is open, or only taken because somebody needs it."""
    return all(
        _follows_from(_last_action(before), after)
        for before, after in itertools.pairwise(parts)
        if isinstance(after, Reason)
    )


def _follows_from(action: str | None, reason: Reason) -> bool:
    if reason.state:
        return action == _OPPOSITES[reason.state]
    return action in ("hand_over", "find") or not reason.wants_it


def _goes_on(part: Any) -> bool:
    """Whether it states something, and no full stop stands before it."""
    if not isinstance(part, Further):
        return isinstance(part, Reason)
    stated = isinstance(part.part, Clause) and is_statement(part.part) and bool(part.part.about)
    return stated and part.separator is not Separator.STOP


def _last_of(part: Any) -> Any:
    """The last task of a clause, if it has one."""
    part = part.part if isinstance(part, Further) else part
    last = (*part.first, *part.second)[-1] if isinstance(part, Group) else part
    return last.bundles[-1][-1] if isinstance(last, Clause) and last.bundles else None


def _last_action(part: Any) -> str | None:
    last = _last_of(part)
    return None if last is None else str(last.action)


def _for_whoever_asks(part: Any) -> bool:
    """Whether it brings something, and does not say to whom."""
    last = _last_of(part)
    return last is not None and last.get("to") == ASKER


MEANINGS: Mapping[str, Meaning] = MappingProxyType(
    {
        "reason": _reason,
        "reason_state": _reason_state,
        "reason_blocks": _reason_blocks,
        "reason_after": _reason_after,
    }
)
