"""What stands beside a stop or a motion without an end: whether it is a task of its own."""

from __future__ import annotations

import itertools
import re
from collections.abc import Sequence

from executive.language.clauses.scopes import Further, Separator
from executive.language.phrases.values import Clause, Nominal, Trouble

_IF = re.compile(r"(?:and |then |please |so )*if you can \w")
"""How a courtesy begins that is a condition of what follows: "if you can find it, bring it to me"."""

WITH_A_HAND = frozenset({"pick", "place", "put_in", "hand_over", "open", "close", "wave", "point_at"})
"""Tasks of which it can be said which hand does them."""


def runs_together(said: Sequence[Further]) -> bool:
    """Whether a stop, or a motion without an end, has nothing between it and the next: "stop pick it up"."""
    for before, after in itertools.pairwise(said):
        both = [one.part for one in (before, after) if isinstance(one.part, Clause)]
        if after.separator is Separator.NOTHING and any(map(_watches, both[:1])):
            return True  # "watch Ana open the door": she opens it
        ends = all(not stops(one) and not is_endless(one) for one in both)
        if after.separator is Separator.NOTHING and not ends and not all(_moves(one) for one in both):
            return True
    return False


def unclear_among(said: Sequence[Further]) -> Trouble | None:
    """What is a task of its own when it is said alone, and may be something else beside another one."""
    for before, after in itertools.pairwise(said):
        first, second = before.part, after.part
        if not isinstance(first, Clause) or not isinstance(second, Clause):
            continue
        if _IF.match(first.text.lower()):
            return Trouble("a condition ('if') cannot be honoured; say what to do", "if")
        joined = after.separator in (Separator.AND, Separator.COMMA)
        if first.hand_first and joined and _may_use(second):
            return Trouble("shall all of that be done with the same hand?", asks=True)
        if (
            joined
            and _waves_at_nobody(first)
            and second.bundles[:1]
            and second.bundles[0][0].action == "wave"
        ):
            return Trouble("once, or twice?", asks=True)  # "wave, wave to Ana"
        goes_on = second.terse and is_endless(second) and not _moves(first)
        if goes_on or (first.terse and is_endless(first)):
            return Trouble("how far in that direction?", asks=True)  # "go home, backwards"
        if stops(second) and after.separator is Separator.COMMA and not _moves(first):
            return Trouble("shall it be stopped now, or when that is done?", asks=True)
    return None


def _may_use(clause: Clause) -> bool:
    """Whether a hand does it, nobody says which one, and it is not done to what is in the hand."""
    first = clause.bundles[0][0] if clause.bundles else None
    if first is None or first.action not in WITH_A_HAND or first.get("hand") is not None:
        return False
    thing = first.get("object")
    return not isinstance(thing, Nominal) or thing.reference is None


def _waves(clause: Clause) -> bool:
    return bool(clause.bundles) and clause.bundles[0][0].action == "wave"


def _waves_at_nobody(clause: Clause) -> bool:
    return _waves(clause) and clause.bundles[0][0].get("person") is None


def _watches(clause: Clause) -> bool:
    """Whether it watches somebody, whose doing may follow."""
    return bool(clause.bundles) and bool(clause.bundles[-1][-1].get("watches"))


def _moves(clause: Clause) -> bool:
    """Whether it says how to move, rather than where to."""
    return bool(clause.bundles) and clause.bundles[-1][-1].action == "move"


def is_endless(clause: Clause) -> bool:
    """Whether it ends with a motion of which nobody says how long it takes."""
    last = clause.bundles[-1][-1] if clause.bundles else None
    measured = last is not None and (last.get("duration_s") or last.get("distance_m"))
    return last is not None and last.action == "move" and not measured


def stops(clause: Clause) -> bool:
    """Whether it says nothing but to stop: "whoa, stop right there" is one stop."""
    return bool(clause.bundles) and all(one.action == "stop" for bundle in clause.bundles for one in bundle)
