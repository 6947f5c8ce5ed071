"""Several turns after one verb: "turn left and then right"."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from executive.language.commands.going import TURN_RAD_S
from executive.language.phrases.arranging import clause, guarded, trouble, unfit
from executive.language.phrases.parts import Parts, words
from executive.language.phrases.values import Clause, Meaning, Measure, draft

_TURNS = {"left": TURN_RAD_S, "right": -TURN_RAD_S}


def _turns(parts: Parts) -> Clause:
    """One turn a side; how far is said of all of them, which is read as commands of their own, or of none."""
    if any(mark.meaning != "," for mark in words(parts, "PAUSE")):
        raise unfit()
    sides = [one.meaning.partition(":")[0] for one in words(parts, "TURN_SIDE", "LEFT_RIGHT")]
    measured = [isinstance(part, Measure) for part in parts]
    if sum(measured) >= len(sides):
        raise unfit()
    if any(measured):
        raise trouble(f"how far to the {sides[0] if measured[-1] else sides[-1]}?", asks=True)
    turns = [draft("move", linear_m_s=0.0, angular_rad_s=_TURNS[side]) for side in sides]
    return clause(parts, [(one,) for one in turns])


MEANINGS: Mapping[str, Meaning] = MappingProxyType({"turns": guarded(_turns)})
