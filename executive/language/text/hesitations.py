"""Where "uh" says nothing: it takes nothing back, for nothing that was said could be meant anew after it."""

from __future__ import annotations

from collections.abc import Sequence
from collections.abc import Set as AbstractSet

from executive.language.text.piece import Piece

_PEOPLE = frozenset({"ME", "US", "NAME", "PERSON", "PEOPLE", "HIM"})
_NAMES_A_THING = frozenset({"DET", "AMOUNT", "ANOTHER", "MANY", "COUPLE", "COLOR", "KIND", "SUBSTANCE", "IT"})
_PLACES = frozenset(
    {"ON", "ONTO", "IN", "INTO", "AT", "FROM", "TO", "TO_ALSO", "NEXT_TO", "RELATION", "NEAREST_TO", "WITH"}
)
_GOES_ON = frozenset({"SEP", "AND"})
_UNITS = frozenset({"TIME", "LENGTH", "ANGLE", "LINEAR_SPEED", "ANGULAR_SPEED"})
_ENDS_CLAUSE = frozenset({"SEP", "AFTER", "BEFORE"})

SET_OFF = "set_off"
"""Meaning of those hesitations that say something elsewhere: "do it well"."""

Classes = Sequence[AbstractSet[str]]


def says_nothing(start: int, end: int, pieces: Sequence[Piece], begins: Classes, ends: Classes) -> bool:
    """Whether a hesitation after something that may be complete cannot be followed by a correction of it.

    Args:
        start: Where the hesitation begins.
        end: Where it ends.
        pieces: Of the sentence.
        begins: Word classes that begin at each place.
        ends: Word classes that end at each place.
    """
    before = start
    while before > 0 and pieces[before - 1].is_mark:
        before -= 1
    after = end
    while after < len(pieces) and (pieces[after].is_mark or "HESITATION" in begins[after]):
        after += 1
    if after >= len(pieces) or before == 0:
        return False
    follows = begins[after]
    if not _GOES_ON.isdisjoint(follows):
        return True  # "the cup, um, and the bowl"
    if pieces[before - 1].is_number or "AMOUNT" in ends[before]:
        return not _UNITS.isdisjoint(follows)
    if not _PLACES.isdisjoint(follows):
        return _is_first_place(before, begins, pieces)
    noun = after + 1 if "DET" in follows and after + 1 < len(pieces) else after
    somebody = not _PEOPLE.isdisjoint(begins[noun]) or not _PEOPLE.isdisjoint(follows)
    received = bool(_PEOPLE & ends[before])
    return received and not somebody and not _NAMES_A_THING.isdisjoint(follows)


def is_set_off(start: int, end: int, pieces: Sequence[Piece], ends: Classes) -> bool:
    """Whether marks or a connective part a hesitation from what it could describe: "and then, well, put it".

    Args:
        start: Where it begins.
        end: Where it ends.
        pieces: Of the sentence.
        ends: Word classes that end at each place.
    """
    if start == 0 or end >= len(pieces):
        return False
    joined = not _GOES_ON.isdisjoint(ends[start])
    return (joined or pieces[start - 1].text == ",") and (joined or pieces[end].text == ",")


def _is_first_place(before: int, begins: Classes, pieces: Sequence[Piece]) -> bool:
    """Whether no place was named yet in the clause, so that "um, on the table" corrects none."""
    for position in range(before - 1, -1, -1):
        if pieces[position].text in ".;!?" or not _ENDS_CLAUSE.isdisjoint(begins[position]):
            return True
        if not _PLACES.isdisjoint(begins[position]):
            return False
    return True
