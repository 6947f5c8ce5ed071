"""What stands beside a stop or a motion without an end: whether it is a task of its own."""

from __future__ import annotations

import itertools
from collections.abc import Sequence

from executive.language.phrases import Clause, Trouble
from executive.language.scopes import Further, Separator


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
        goes_on = second.terse and is_endless(second) and not _moves(first)
        if goes_on or (first.terse and is_endless(first)):
            return Trouble("how far in that direction?", asks=True)  # "go home, backwards"
        if stops(second) and after.separator is Separator.COMMA and not _moves(first):
            return Trouble("shall it be stopped now, or when that is done?", asks=True)
    return None


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
