"""Corrections inside a sentence: "the red cup, no wait, the green one".

A correction is taken where it can mean one thing only. What is said after the words that take something back
must begin as what it stands for does (an article, a number, a preposition, the same verb) and name as many
things, of the same sorts; the sentence with it and the sentence without it must both mean something, have
the same tasks, and differ in the slots that were said anew. Whatever is left open stays refused.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import dataclass
from functools import cached_property

from executive.language.taken_back.beginnings import ONE, SAID_ALONE, SORTS, beginnings
from executive.language.taken_back.replaced_slots import ADDS, LOSES, SAME, change, holds
from executive.language.taken_back.said_fully import said_fully
from executive.language.taken_back.taking_back import DENIES, DISCARDS, Marker, Span, is_mark, marker_of
from executive.language.words.lattice import Lattice
from executive.language.words.word import Word
from executive.meaning import Command, command_json

MAX_CANDIDATES = 10
"""Wordings that are tried; a sentence with more is too tangled to be sure of."""

MAX_WORDS = 40

_DESCRIBES = frozenset({"color", "size", "material", "ordinal", "side", "number", "heading"})

_AFTER_NO = frozenset({"article", "where", "from", "number"})
"""How what follows a bare "no" begins, so that it is no "no sugar"."""

_ADDS = frozenset({"also", "too", "as", "well", "both", "another", "and", "or", "not"})
"""Words that add to what was said, or deny it, rather than replace it."""

_LEANS = frozenset({"it", "them", "him", "her", "there", "one"})
"""Words that stand for what was said before."""

_SIDE = frozenset({"LEFT_RIGHT"})

_INSTEAD = "instead"
Understood = Callable[[str], tuple[Command, ...] | None]


def corrected(
    lattice: Lattice, commands: AbstractSet[str], understood: Understood
) -> tuple[Command, ...] | None:
    """What a sentence with a correction means; None where that is open, or there is no correction.

    Args:
        lattice: The sentence.
        commands: Word classes that a command begins with.
        understood: What a text means, if it means one thing.
    """
    if len(lattice.pieces) > MAX_WORDS:
        return None
    marker = marker_of(lattice)
    if marker is None:
        return None
    named = said_fully(lattice, marker)
    if named is not None:
        return understood(named)
    return _Repair(lattice, marker, commands, understood).commands()


@dataclass(frozen=True, slots=True)
class _Candidate:
    """One way to read a correction: without it, with it."""

    without: str
    replaced: str
    alone: bool
    """Whether what is left out stands before other words of its clause."""
    elliptic: bool
    """Whether it leaves the noun to what it replaces: "the green one", "green"."""
    anew: str | None
    """What is said anew, if it begins with what to do."""


class _Repair:
    """One correction, with every way to read it."""

    def __init__(
        self, lattice: Lattice, marker: Marker, commands: AbstractSet[str], understood: Understood
    ) -> None:
        self._lattice, self._marker = lattice, marker
        self._commands, self._understood = commands, understood
        self._end = len(lattice.pieces)

    @cached_property
    def _breaks_off(self) -> bool:
        """Whether what was said before is no sentence yet: "grab the big, no, the small spoon"."""
        return self._understood(" ".join(self._texts(0, self._marker.span.start))) is None

    @cached_property
    def _marked_anew(self) -> str | None:
        """A command that begins with the words of the correction: "forget that, wait half a minute"."""
        for start in range(self._marker.span.end - 1, self._marker.span.start, -1):
            if is_mark(self._lattice, start):
                break
            anew = " ".join(self._texts(start, self._end))
            if any(map(self._is_verb, self._lattice.phrase(start))) and self._understood(anew) is not None:
                return anew
        return None

    def commands(self) -> tuple[Command, ...] | None:
        """The one meaning, or None."""
        if not self._replaces():
            return None
        candidates = list(dict.fromkeys(self._candidates()))
        if len(candidates) > MAX_CANDIDATES:
            return None
        fitting: dict[str, tuple[Command, ...]] = {}
        for one in candidates:
            before, after = self._understood(one.without), self._understood(one.replaced)
            if before is None or after is None:
                continue
            done = change(before, after, earlier=one.alone and not one.elliptic, whole=one.anew is not None)
            if done in (LOSES, SAME):
                return None
            anew = self._marked_anew or one.anew
            if anew is not None and not self._is_all(anew, after):
                return None  # "give Ana the bowl, no, give me the cup": nothing else holds on
            if done is not None and not (one.elliptic and self._is_open(done)):
                key = repr([command_json(command) for command in after])
                fitting[key] = after
        return next(iter(fitting.values())) if len(fitting) == 1 else None

    def _is_all(self, anew: str, after: Sequence[Command]) -> bool:
        """Whether a command that is said anew says all that is done in its place; "put it there" may not."""
        alone = self._understood(anew)
        return holds(after, alone) if alone is not None else not _LEANS.isdisjoint(anew.split())

    def _is_open(self, done: str) -> bool:
        """Whether "the red one" may be any of several things: none or several of them have a colour."""
        before = Span(0, self._marker.span.start)
        nouns = [*self._nouns(before)[0], *self._hands(before)]
        if len(nouns) < 2 or len(set(nouns)) < len(nouns):
            return len(nouns) > 1
        anew = self._describing(Span(self._marker.span.end, self._end))
        return done == ADDS or len(anew) != 1 or self._describing(before).count(anew[0]) != 1

    def _hands(self, span: Span) -> list[str]:
        """The hands of a span that are told by their side, any of which "the right one" may replace."""
        return [
            one.said
            for index in range(span.start, span.end)
            for one in self._lattice.phrase(index)
            if one.word_class == "HAND" and self._lattice.ends_with(index, _SIDE) and one.end <= span.end
        ]

    def _describing(self, span: Span) -> list[str]:
        """What sorts of words describe things within a span: a colour, a size; "one" is none."""
        places = (one for one in range(span.start, span.end) if not self._has_one(Span(one, one + 1)))
        kinds = [self._beginnings(one) & _DESCRIBES for one in places]
        return [sorted(one)[0] for one in kinds if one]

    def _replaces(self) -> bool:
        """Whether nothing that is said anew adds to what was said; "the fork, and put it there" does not."""
        first = self._marker.span.end
        for position in range(first, self._end):
            if position > first and self._separates(position):
                return True
            halved = any(one.word_class == "AND_A_HALF" for one in self._lattice.phrase(position))
            if self._lattice.pieces[position].text in _ADDS and not halved:
                return False
        return first < self._end

    def _candidates(self) -> Iterator[_Candidate]:
        first = self._marker.span.end
        begins = self._beginnings(first)
        if self._marker.meaning == DENIES:
            begins = {one for one in begins if not one.startswith("bare ")}
            begins &= begins if self._marker.marked else _AFTER_NO
        if self._marker.meaning == DISCARDS and self._may_discard_several:
            return
        for start in range(self._marker.span.start):
            shared = begins & self._beginnings(start)
            if not shared or self._is_listed(start, shared):
                continue
            for old in self._ends(start, shared):
                for new in self._lengths(old):
                    candidate = self._candidate(old, new, shared)
                    if candidate is not None:
                        yield candidate

    @property
    def _may_discard_several(self) -> bool:
        """Whether more than one command stands before "scratch that", all of which may be taken back."""
        last = self._marker.span.start
        if any(map(self._separates, range(last))):
            return True
        begun = [one for one in range(1, last) if any(map(self._is_verb, self._lattice.phrase(one)))]
        halves = ((self._texts(0, one), self._texts(one, last)) for one in begun)
        return any(all(self._understood(" ".join(half)) is not None for half in both) for both in halves)

    def _is_verb(self, word: Word) -> bool:
        return word.word_class in self._commands

    def _beginnings(self, position: int) -> set[str]:
        """As what a phrase that starts at a place can be taken."""
        if position >= self._end:
            return set()
        return beginnings(self._lattice.phrase(position), self._commands)

    def _is_listed(self, start: int, shared: set[str]) -> bool:
        """Whether it is one of several things, all of which may be taken back."""
        is_command = any(one.startswith("do ") for one in shared)
        return start > 0 and self._separates(start - 1) and not is_command and start != 1

    def _separates(self, position: int) -> bool:
        """Whether a mark or a word that joins stands there; "next" in "next to" is none."""
        words = self._lattice.phrase(position)
        longest = max((one.end for one in words), default=position)
        if any(one.word_class == "ORDINAL" for one in words):
            return False  # "the second box"
        return is_mark(self._lattice, position) or any(
            one.word_class in ("SEP", "AND", "BEFORE", "AFTER") and one.end == longest for one in words
        )

    def _ends(self, start: int, shared: set[str]) -> Iterator[Span]:
        """Spans that begin at a place, within its clause, and end before a preposition or the correction."""
        last = self._marker.span.start
        for end in range(start + 1, last + 1):
            if self._separates(end - 1):
                return
            alone = bool(shared & {*SAID_ALONE, "person"}) and end == start + 1
            alone = alone and not self._goes_on_with(end, shared)
            same_clause = not any(map(self._separates, range(end, last)))
            before_more = same_clause and bool(self._beginnings(end) & {"where", "from", "with"})
            measure = "number" in shared and same_clause and end - start == self._end - self._marker.span.end
            if end == last or alone or before_more or measure:
                yield Span(start, end)

    def _goes_on_with(self, end: int, shared: set[str]) -> bool:
        """Whether a list goes on there with more of the same: either of "Ana and Ben, I mean Maria"."""
        after = end
        while after < self._marker.span.start and self._separates(after):
            after += 1
        return end < after < self._marker.span.start and bool(self._beginnings(after) & shared)

    def _lengths(self, old: Span) -> Iterator[Span]:
        """How far what is said anew may reach: to the end, to a mark, or as many words as it replaces."""
        first = self._marker.span.end
        for end in range(first + 1, self._end + 1):
            same = end - first == old.end - old.start
            ended = end == self._end or self._separates(end)
            goes_on = same and old.end == self._marker.span.start and self._breaks_off
            if ended or goes_on:
                yield Span(first, end)

    def _candidate(self, old: Span, new: Span, shared: set[str]) -> _Candidate | None:
        """A reading in which some words stand for others; None where they are no match."""
        single = new.end - new.start == 1 == old.end - old.start
        alone = old.end < self._marker.span.start
        if alone and shared <= SAID_ALONE and new.end - new.start != old.end - old.start:
            return None
        last = new.end
        if last > new.start + 1 and self._lattice.pieces[last - 1].text == _INSTEAD:
            last -= 1
        words = self._texts(new.start, last)
        nouns, sorts = self._nouns(old)
        _, new_sorts = self._nouns(Span(new.start, last))
        ones = [
            index
            for index in range(new.start, last)
            if any(word.word_class in ONE for word in self._lattice.phrase(index))
        ]
        elliptic = bool(ones) or (single and bool(shared & SAID_ALONE))
        if ones and not sorts and not self._has_one(old):
            return None  # "the left, no, the third one": the third what?
        if ones and sorts:
            if len(ones) > 1 or len(sorts) > 1 or new_sorts:
                return None
            words[ones[0] - new.start] = nouns[0]
        elif sorts != new_sorts and not shared & {"where", "from"}:
            return None
        before = self._texts(0, old.start)
        kept = self._texts(old.end, self._marker.span.start)
        rest = self._texts(self._resumed(new.end), self._end)
        was = self._texts(old.start, old.end)
        anew = " ".join(words) if any(one.startswith("do ") for one in shared) else None
        hands = self._hands(old)
        if ones and hands and not sorts:
            words[ones[0] - new.start] = hands[0]
        without, replaced = ([*before, *one, *kept, *rest] for one in (was, words))
        return _Candidate(" ".join(without), " ".join(replaced), alone, elliptic, anew)

    def _resumed(self, position: int) -> int:
        """Where the sentence goes on: a comma before a place or a number only ends the correction."""
        following = self._beginnings(position + 1)
        is_comma = position < self._end and self._lattice.pieces[position].text in (",", "-")
        return position + 1 if is_comma and following & {"where", "from", "with", "number"} else position

    def _has_one(self, span: Span) -> bool:
        """Whether it says "one" too, or a hand, which may be called so."""
        return any(
            word.word_class in ("HAND", *ONE)
            for index in range(span.start, span.end)
            for word in self._lattice.phrase(index)
        )

    def _nouns(self, span: Span) -> tuple[list[str], list[str]]:
        """The nouns of a span, as they were said, and their sorts."""
        said, sorts = [], []
        position = span.start
        while position < span.end:
            words = [
                one
                for one in self._lattice.phrase(position)
                if one.word_class in SORTS and one.end <= span.end and one.word_class not in ONE
            ]
            longest = max(words, key=lambda one: one.end, default=None)
            if longest is None:
                position += 1
                continue
            said.append(longest.said)
            sorts.append(SORTS[longest.word_class])
            position = longest.end
        return said, sorts

    def _texts(self, start: int, end: int) -> list[str]:
        plain, pieces = self._lattice.plain, self._lattice.pieces
        return [plain[one.start : one.end] for one in pieces[start:end]]
