"""Lists with no more than their last "and": "pick up the spoon the fork and the knife"."""

from __future__ import annotations

from executive.language.words.lattice import Lattice

_THINGS = frozenset({"KIND", "KINDS", "SUBSTANCE", "PAIR", "CONTAINER", "DOOR"})
_NAMES_ANOTHER = frozenset({"DET", "AMOUNT"})
_JOINS = ("and", "&")


def with_commas(lattice: Lattice) -> str | None:
    """The sentence with the commas of such a list, or None where it has none.

    Nobody says a list of two like that, so the last "and" has to follow; whether the things with a comma
    between are one and the same is asked as ever.
    """
    size = len(lattice.pieces)
    gaps = [one for one in range(1, size) if _is_gap(lattice, one)]
    last = (
        next((one for one in range(gaps[-1], size) if lattice.pieces[one].text in _JOINS), size)
        if gaps
        else size
    )
    if last + 1 >= size or not lattice.begins_with(last + 1, _NAMES_ANOTHER):
        return None
    plain, text, written = lattice.plain, "", 0
    for gap in gaps:
        end = lattice.pieces[gap - 1].end
        text, written = f"{text}{plain[written:end]},", end
    return text + plain[written:]


def _is_gap(lattice: Lattice, position: int) -> bool:
    """Whether one thing ends there and another is named, with nothing between."""
    return lattice.ends_with(position, _THINGS) and lattice.begins_with(position, _NAMES_ANOTHER)
