"""Statements of any words beside a command: "My knees are bad, so pick up the ball".

A sentence that is refused as a whole may be a command and a remark, which says why and changes nothing of
what is asked. What remains without it has to be a command by itself. That the remark is no more than that is
judged before (``remark_guard.py``).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import dataclass
from typing import Protocol

from executive.language.motives.free_reasons import free_reasons
from executive.language.motives.reason import Reason, words_of
from executive.language.motives.remark_guard import is_mere_remark, may_go_on_as, says_nothing
from executive.language.motives.set_remarks import plainer
from executive.language.motives.small_talk import is_small_talk
from executive.language.motives.told_by_remarks import Place, whom_it_names
from executive.language.words.piece import Piece
from executive.vocabulary import Vocabulary

_MOST_BEHIND = 2
"""Remarks behind commands that are passed over in one sentence."""

_MOST_BEFORE = 4
"""Remarks before a command; all but one of them in words that are always the same."""

_DASH = "-"
_FRONT_ENDS = frozenset({"", ",", ";", ".", ":", "!", _DASH})
_PLACES = {
    ".": Place.SENTENCE_BEFORE,
    "!": Place.SENTENCE_BEFORE,
    "?": Place.SENTENCE_BEFORE,
    ":": Place.BEFORE_COLON,
}
_BEHIND_BEGINS = frozenset({",", ";", ".", "!", _DASH})
_CLOSING = {"(": ")", _DASH: _DASH}
_TALK_ENDS = frozenset({".", "!"})
_JOINING = frozenset({"SEP"})


class Read(Protocol):
    """A sentence as the vocabulary reads it; a ``Lattice``."""

    plain: str

    @property
    def pieces(self) -> Sequence[Piece]:
        """Its words and marks."""

    @property
    def begun(self) -> Sequence[AbstractSet[str]]:
        """Word classes that begin at each place."""

    @property
    def nothing_said(self) -> Sequence[bool]:
        """For each place, whether only courtesies stand before it."""

    def classes(self, position: int) -> Mapping[str, object]:
        """The words that begin at a place or behind courtesies there, by word class."""


@dataclass(frozen=True, slots=True)
class Rest:
    """What remains of a sentence without its remarks.

    Attributes:
        text: Its words.
        behind: Whether a remark behind a command is left out, which might be words to say.
    """

    text: str
    behind: bool


def without_remarks(read: Read, vocabulary: Vocabulary, commands: AbstractSet[str]) -> Iterator[Rest]:
    """What may remain of a sentence without its remarks.

    Args:
        read: The sentence.
        vocabulary: What is known.
        commands: Word classes that a command begins with.
    """
    search = _Search(read, vocabulary, commands)
    for front in (*search.before_a_command(), None):
        begun = 0 if front is None else front.end
        behind = list(search.behind_commands(begun))
        if len(behind) <= _MOST_BEHIND and (front is not None or behind):
            spans = [*([] if front is None else [front]), *sorted(behind, key=lambda span: span.start)]
            yield Rest(_cut(read, spans), bool(behind))


@dataclass(frozen=True, slots=True)
class _Span:
    """Pieces that are left out, and what is said instead of them."""

    start: int
    end: int
    instead: str = ""


def _cut(read: Read, spans: Sequence[_Span]) -> str:
    kept, position = [], 0
    for span in spans:
        kept += [read.plain[position : _where(read, span.start)].rstrip(), span.instead]
        position = _where(read, span.end)
    kept.append(read.plain[position:])
    return " ".join(part for part in kept if part.strip())


def _where(read: Read, position: int) -> int:
    return read.pieces[position].start if position < len(read.pieces) else len(read.plain)


class _Search:
    """Where remarks stand in a sentence."""

    def __init__(self, read: Read, vocabulary: Vocabulary, commands: AbstractSet[str]) -> None:
        self._read = read
        self._pieces = read.pieces
        self._vocabulary = vocabulary
        self._commands = commands

    def before_a_command(self) -> Iterator[_Span]:
        """Remarks in front, from their first word to that of the command."""
        size = len(self._pieces)
        first = max((index for index in range(size) if self._read.nothing_said[index]), default=0)
        yield from self._from(first, first, _MOST_BEFORE, may_be_free=True)
        if first:
            yield from self._from(0, 0, _MOST_BEFORE, may_be_free=False)
        talked = self._end_of_small_talk()
        if talked:
            if self._begins_command(talked):
                yield _Span(0, talked)
            yield from self._from(0, talked, _MOST_BEFORE, may_be_free=True)

    def _end_of_small_talk(self) -> int:
        """Where sentences in front end that are mere fragments; courtesies may stand among them."""
        start, talked = 0, False
        for mark, piece in enumerate(self._pieces[:-1]):
            if piece.text in _TALK_ENDS and mark > start:
                fragment = is_small_talk(Reason(*self._of(start, mark)))
                if not fragment and not self._read.nothing_said[mark]:
                    break
                start, talked = mark + 1, talked or fragment
        return start if talked else 0

    def _from(self, first: int, start: int, most: int, *, may_be_free: bool) -> Iterator[_Span]:
        """Remarks from a place on, one of which may be of any words."""
        for end in range(start + 1, len(self._pieces) - 1):
            mark = self._mark_at(end)
            begins = end + bool(mark)
            word = self._pieces[begins].text
            leads = word in words_of("leading" if mark else "leading_alone")
            turns = bool(mark) and word in words_of("turning")
            if mark or leads:
                place = Place.LED if leads else _PLACES.get(mark, Place.BEFORE)
                remark = Reason(*self._of(start, end))
                following = begins + (leads or turns)
                idle = bool(mark) and says_nothing(remark, place)
                free = not idle and may_be_free and end > start + 1 and mark in _FRONT_ENDS
                if idle or free:
                    yield from self._front(first, remark, following, place)
                if most > 1 and mark and (idle or (free and self._is_one_of_several(remark, place))):
                    may_be = may_be_free and idle
                    yield from self._from(first, following, most - 1, may_be_free=may_be)
            if mark and end > start + 1:
                return

    def _mark_at(self, index: int) -> str:
        if index >= len(self._pieces):
            return ""
        piece = self._pieces[index]
        return piece.text if piece.is_mark or piece.text == _DASH else ""

    def _is_one_of_several(self, remark: Reason, place: Place) -> bool:
        """Whether another remark may follow it, which is always the same."""
        return whom_it_names(plainer(remark)) is None and is_mere_remark(remark, place)

    def _front(self, first: int, remark: Reason, begins: int, place: Place) -> Iterator[_Span]:
        if not self._begins_command(begins) or not is_mere_remark(remark, place):
            return
        begins_later = begins - remark.end
        plain = plainer(remark)
        chained = place is Place.BEFORE and may_go_on_as(plain, plain.end + begins_later)
        if not chained or says_nothing(remark, place):
            yield _Span(first, begins, self._named_before(remark))

    def _named_before(self, remark: Reason) -> str:
        """What is left of a remark that names whom the command means by "him" or "her"."""
        plain = plainer(remark)
        named = whom_it_names(plain)
        if named is None:
            return ""
        piece = plain.pieces[named]
        return f"{self._read.plain[piece.start : piece.end]} {' '.join(words_of('naming'))}."

    def _of(
        self, start: int, end: int
    ) -> tuple[Sequence[Piece], int, int, Sequence[AbstractSet[str]], Vocabulary]:
        return self._pieces, start, end, self._read.begun, self._vocabulary

    def _begins_command(self, position: int) -> bool:
        return not self._commands.isdisjoint(self._read.classes(position))

    def behind_commands(self, begun: int) -> Iterator[_Span]:
        """Remarks behind a command or within it, each with the marks around it."""
        within = list(self._asides(begun))
        yield from within
        size = len(self._pieces)
        for mark in range(begun + 1, size - 1):
            if self._pieces[mark].text not in _BEHIND_BEGINS or self._read.nothing_said[mark]:
                continue
            if any(one.start <= mark < one.end for one in within):
                continue
            end = next((index for index in range(mark + 1, size) if self._mark_at(index)), size)
            if self._may_go_on(end) and is_mere_remark(Reason(*self._of(mark + 1, end)), Place.BEHIND):
                yield _Span(mark, end)

    def _asides(self, begun: int) -> Iterator[_Span]:
        """Remarks in brackets or between two dashes, and reasons between two commas."""
        reasons = free_reasons(self._pieces, self._read.begun, self._read.nothing_said, self._vocabulary)
        for start, end in reasons:
            if begun < start - 1 and [self._mark_at(start - 1), self._mark_at(end)] == [",", ","]:
                yield _Span(start - 1, end + 1)
        texts = [piece.text for piece in self._pieces]
        position = begun + 1
        while position < len(texts):
            closing = _CLOSING.get(texts[position], "")
            if closing in texts[position + 1 :] and closing:
                end = texts.index(closing, position + 1)
                if is_mere_remark(Reason(*self._of(position + 1, end)), Place.BEHIND):
                    yield _Span(position, end + 1)
                    position = end
            position += 1

    def _may_go_on(self, end: int) -> bool:
        """Whether the sentence ends there, or goes on with another command."""
        behind = end + 1
        if behind >= len(self._pieces):
            return end >= len(self._pieces) or self._pieces[end].text != "?"
        if self._pieces[end].text in (".", "!", ";"):
            return True
        return self._pieces[end].text == "," and not self._read.begun[behind].isdisjoint(_JOINING)
