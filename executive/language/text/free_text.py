"""Words that may be said aloud: from a place up to each separator, and to the end."""

from __future__ import annotations

from collections.abc import Set as AbstractSet

from executive.language.text.lattice import FILLER, Lattice
from executive.language.text.word import Word

TIME = "time"
"""Meaning of those fillers that may belong to words to say: "tell Ben that I'm leaving now"."""

_SEPARATES = frozenset({"PAUSE", "SEP", "BEFORE", "AFTER", "AFTER_DOING"})


def free_text(lattice: Lattice, start: int, commands: AbstractSet[str]) -> list[Word]:
    """What may be words to say.

    Args:
        lattice: The sentence.
        start: The place.
        commands: Word classes that a command begins with. What was ``said`` of a text that goes on
            after a separator with one of them is that separator: it may be a command of its own. Of
            a text that a time follows it is ``TIME``.
    """
    size = len(lattice.pieces)
    if start >= size or lattice.pieces[start].is_mark:
        return []
    open_at, by = _may_end(lattice, start, commands)
    return [
        Word(
            "TEXT", lattice.text(start, end), start, end, by if end > open_at else _time_at(lattice, end)
        )
        for end in range(start + 1, size + 1)
        if lattice.text_may_end(end)
    ]  # fmt: skip


def _time_at(lattice: Lattice, position: int) -> str:
    """``TIME`` where a time begins that may belong to the words before it."""
    begins = lattice.phrase(position) if position < len(lattice.pieces) else ()
    return TIME if any((word.word_class, word.meaning) == (FILLER, TIME) for word in begins) else ""


def _may_end(lattice: Lattice, start: int, commands: AbstractSet[str]) -> tuple[int, str]:
    """The first place where words to say may end though they go on, and what is said there.

    A dictated mark stands there ("hello period"), or a separator that a command may follow.
    """
    size = len(lattice.pieces)
    for position in range(start + 1, size):
        for word in lattice.phrase(position):
            follows = word.end < size and lattice.classes(word.end)
            parted = word.word_class in _SEPARATES and follows and not commands.isdisjoint(follows)
            if parted or word.word_class == "SPOKEN_MARK":
                return position, word.said or lattice.pieces[position].text
    return size, ""
