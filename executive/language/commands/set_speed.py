"""A speed that is set in words of its own: "set the speed to 0.2 m/s and go forward for three seconds"."""

from __future__ import annotations

import itertools
import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from types import MappingProxyType

from executive.language.clauses.scopes import Separator
from executive.language.commands.going import FORWARD_M_S
from executive.language.commands.limits import bounded
from executive.language.noun_phrases.arranging import guarded, unfit
from executive.language.phrase_parts import Parts
from executive.language.phrases import Clause, Meaning, Measure, Trouble

_SET = "sets_speed"
"""Slot of a motion whose speed was set before it."""

_MOVES = frozenset({"move", "walk_to", "go_home"})


def _at_set_speed(parts: Parts) -> Clause:
    """The motion that follows, along a line and at no other speed; to a place no speed can be chosen."""
    command: Clause = parts[-1]
    speed = next(part for part in parts if isinstance(part, Measure))
    value = bounded(speed)
    move = command.bundles[0][0] if len(command.bundles) == 1 and len(command.bundles[0]) == 1 else None
    joined = next(part for part in parts if isinstance(part, Separator))
    if speed.of != "linear_speed" or joined is Separator.ASKED or move is None or move.action != "move":
        raise unfit()
    usual = move.get("linear_m_s")
    if abs(usual) != FORWARD_M_S or not (move.get("duration_s") or move.get("distance_m")):
        raise unfit()
    moved = move.replacing("linear_m_s", round(math.copysign(value, usual), 3))
    return replace(command, bundles=((moved.with_slot(_SET, True),),))


def doubt_of_speed(clauses: Sequence[Clause]) -> Trouble | None:
    """Ask whether a speed that was set holds for what moves after the next motion too."""
    tasks = [one for clause in clauses for bundle in clause.bundles for one in bundle]
    later = itertools.dropwhile(lambda one: not one.get(_SET), tasks)
    moves = [one for one in itertools.islice(later, 1, None) if one.action in _MOVES]
    return Trouble("shall that be done at the same speed?", asks=True) if moves else None


MEANINGS: Mapping[str, Meaning] = MappingProxyType({"at_set_speed": guarded(_at_set_speed)})
