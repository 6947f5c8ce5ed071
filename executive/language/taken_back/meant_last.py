"""A correction that is told as one behind it: "to the kitchen, the office I mean"."""

from __future__ import annotations

from executive.language.taken_back.taking_back import BESIDE, CORRECTION
from executive.language.words.lattice import Lattice

_MEANT = frozenset({"MEANT"})


def told_as_meant_first(lattice: Lattice) -> str | None:
    """The sentence with these words before what is meant; None where it does not end with them.

    Args:
        lattice: The sentence. What is meant begins behind the last mark; where other words take something
            back already, those at the end say nothing more.
    """
    size = len(lattice.pieces)
    first = next((at for at in range(max(size - 5, 1), size) if _ends_with_meant(lattice, at)), None)
    if first is None:
        return None
    end = first - 1 if lattice.pieces[first - 1].is_mark else first
    begin = next((at for at in range(end - 1, 0, -1) if lattice.pieces[at - 1].is_mark), None)
    if begin is None or begin < 2:
        return None
    anew = lattice.text(begin, end)
    if any(_takes_back(lattice, at) for at in range(1, first)):
        return lattice.text(0, end)
    return f"{lattice.text(0, begin)}, {lattice.text(first, size)} {anew}"


def _ends_with_meant(lattice: Lattice, position: int) -> bool:
    words = lattice.phrase(position)
    return any(one.word_class in _MEANT and one.end == len(lattice.pieces) for one in words)


def _takes_back(lattice: Lattice, position: int) -> bool:
    words = lattice.phrase(position)
    return any(one.word_class == CORRECTION and one.meaning != BESIDE for one in words)
