"""The words of a sentence that take back what was said before them: "no wait", "I mean", "scratch that"."""

from __future__ import annotations

from dataclasses import dataclass

from executive.language.words.lattice import Lattice
from executive.language.words.word import Word

CORRECTION = "CORRECTION"

REPLACES, DISCARDS, DENIES, BESIDE = "replaces", "discards", "denies", "beside"
"""Meanings in the vocabulary: "I mean", "scratch that", "no", and what only stands beside these: "wait"."""

_STRENGTHS = (BESIDE, DENIES, REPLACES, DISCARDS)


@dataclass(frozen=True, slots=True)
class Span:
    """Some pieces; ``end`` is after the last."""

    start: int
    end: int


@dataclass(frozen=True, slots=True)
class Marker:
    """The words that take something back."""

    span: Span
    meaning: str
    marked: bool
    """Whether a mark stands right after them."""


def marker_of(lattice: Lattice) -> Marker | None:
    """The only correction of a sentence; None when there is none, or several."""
    found: Marker | None = None
    position = 1
    while position < len(lattice.pieces):
        word = _correction(lattice, position)
        start = _before(lattice, position)
        denies = word is not None and word.meaning == DENIES and start == position
        if word is None or word.meaning == BESIDE or (denies and not _names_anew(lattice, word.end)):
            position += 1
            continue
        if found is not None:
            return None
        end, meaning = word.end, word.meaning
        marked = False
        while (after := _passed(lattice, end)) is not None:
            end, more = after
            marked = marked or more is None
            meaning = max(meaning, more or meaning, key=_STRENGTHS.index)
        found = Marker(Span(start, end), meaning, marked)
        position = end
    return found if found is not None and found.span.start > 0 else None


_NAMES = frozenset({"the", "my", "your"})
_LEADS = frozenset({"to", "on", "in", "into", "from"})


def _names_anew(lattice: Lattice, position: int) -> bool:
    """Whether a thing follows that "no" cannot deny: "the spoon no the fork", but "no sugar"."""
    said = [piece.text for piece in lattice.pieces[position : position + 2]]
    return len(said) == 2 and (said[0] in _NAMES or (said[0] in _LEADS and said[1] in _NAMES))


def _correction(lattice: Lattice, position: int) -> Word | None:
    words = [one for one in lattice.phrase(position) if one.word_class == CORRECTION]
    return max(words, key=lambda one: one.end, default=None)


def is_mark(lattice: Lattice, position: int) -> bool:
    """Whether a punctuation mark or a dash stands at a place."""
    return lattice.pieces[position].is_mark or lattice.pieces[position].text == "-"


def _passed(lattice: Lattice, position: int) -> tuple[int, str | None] | None:
    """The end of one more word of a correction, or of a mark, at a place, and its meaning."""
    if position >= len(lattice.pieces):
        return None
    if is_mark(lattice, position):
        return position + 1, None
    word = _correction(lattice, position)
    return None if word is None else (word.end, word.meaning)


def _before(lattice: Lattice, start: int) -> int:
    """Where a correction begins, with the marks and the "wait" that stand before it."""
    while start > 0:
        if is_mark(lattice, start - 1):
            start -= 1
            continue
        word = _correction(lattice, start - 1)
        if word is None or word.end != start:
            break
        if word.meaning != DENIES and (start < 2 or not is_mark(lattice, start - 2)):
            break  # "go there and wait, I mean ..." waits
        start -= 1
    return start
