"""The words of a sentence, parted where it names alternatives."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

from executive.language.words.lattice import Lattice
from executive.language.words.piece import Piece
from executive.language.words.word import Word

MAX_SPAN = 10
"""Words of one alternative, so that no text takes long."""

MAX_ROW = 5
"""Gaps between alternatives."""

_OR, _LISTS = "OR", "ONE_OF_THESE"
_PASSED = frozenset({"EITHER", _LISTS})
"""Word classes that announce alternatives and say no more."""

_MARKED = "marked"
"""Meaning of those that are followed by a colon: "one of these cups" names what is meant."""

_JOINS = frozenset({"AND", _OR})

_LIST_MARKS = frozenset({",", ";"})


@dataclass(frozen=True, slots=True)
class Gap:
    """What stands between two alternatives: places of the words, the second after the last."""

    start: int
    end: int


class Parted:
    """The words of a sentence without those that announce alternatives; places count these words.

    Attributes:
        size: How many words these are, marks among them.
    """

    def __init__(self, lattice: Lattice) -> None:
        self._lattice = lattice
        passed: set[int] = set()
        self._joining, self._marks = frozenset({_OR}), frozenset({","})
        for start in range(len(lattice.pieces)):
            for word in lattice.phrase(start):
                colon = self._colon(word.end)
                if word.word_class not in _PASSED or (word.meaning == _MARKED and not colon):
                    continue
                passed |= {*range(start, word.end), *colon}
                if word.word_class == _LISTS:
                    self._joining, self._marks = _JOINS, _LIST_MARKS
        self._kept = [one for one in range(len(lattice.pieces)) if one not in passed]
        self.size = len(self._kept)

    def _colon(self, position: int) -> set[int]:
        pieces = self._lattice.pieces
        marked = position < len(pieces) and pieces[position].text in (":", ",")
        return {position} if marked else set()

    def rows(self) -> Iterator[tuple[Gap, ...]]:
        """The gaps between alternatives, first the longest rows of them: "the can, the cup or the bowl"."""
        gaps = self._gaps
        last = next((one for one in reversed(range(len(gaps))) if self._parts(gaps[one])), None)
        if last is None:
            return
        first = last
        while first > max(0, last - MAX_ROW) and gaps[first].start - gaps[first - 1].end <= MAX_SPAN:
            first -= 1
        for start in range(first, last + 1):
            yield tuple(gaps[start : last + 1])

    @cached_property
    def _gaps(self) -> list[Gap]:
        """Every comma and every "or", with the comma before it; in an announced list, all that joins."""
        gaps: list[Gap] = []
        for place in range(self.size):
            joins = any(one.word_class in self._joining for one in self.phrase(place))
            if not (joins or self.piece(place).text in self._marks):
                continue
            if gaps and gaps[-1].end == place:
                gaps[-1] = Gap(gaps[-1].start, place + 1)
            else:
                gaps.append(Gap(place, place + 1))
        return [one for one in gaps if one.start > 0 and one.end < self.size]

    def _parts(self, gap: Gap) -> bool:
        """Whether more than a comma stands there, or the sentence has announced a list."""
        listed = self._marks == _LIST_MARKS
        return listed or any(self.piece(one).text != "," for one in range(gap.start, gap.end))

    def position(self, place: int) -> int:
        """Where a word stands in the whole sentence."""
        return self._kept[place]

    def piece(self, place: int) -> Piece:
        """A word."""
        return self._lattice.pieces[self._kept[place]]

    def phrase(self, place: int) -> Sequence[Word]:
        """The phrases that begin at a place."""
        return self._lattice.phrase(self._kept[place])

    def is_closing(self, place: int) -> bool:
        """Whether a word says nothing at the end of what is said: a mark, a last courtesy."""
        return self._lattice.ends[self._kept[place]] or self.piece(place).is_mark

    def text(self, spans: Sequence[tuple[int, int]]) -> str:
        """The words of some spans, as they were written."""
        runs: list[tuple[int, int]] = []
        for start, end in spans:
            for position in self._kept[start:end]:
                if runs and runs[-1][1] == position:
                    runs[-1] = (runs[-1][0], position + 1)
                else:
                    runs.append((position, position + 1))
        plain, pieces = self._lattice.plain, self._lattice.pieces
        said = ((pieces[start], plain[pieces[start].start : pieces[end - 1].end]) for start, end in runs)
        return "".join(words if first.is_mark else f" {words}" for first, words in said).strip()
