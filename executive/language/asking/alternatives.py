"""Alternatives that a sentence leaves open, asked with a sentence for each: "the red or the blue mug".

What stands behind "or" is put in the place of what stands before it, wherever that may begin. With either of
them there must be a sentence that means something, and the two may differ in one slot only, unless both are
commands of their own. What fits in several ways has more than two choices; nothing is ever chosen here.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import dataclass
from typing import TypeVar

from executive.language.asking.parted import MAX_SPAN, Gap, Parted
from executive.language.taken_back.beginnings import HEADINGS, MEASURES, ONE, SORTS, beginnings
from executive.language.taken_back.replaced_slots import only_slots_that_differ
from executive.language.words.lattice import Lattice
from executive.meaning import Command, Question, command_json

MAX_WORDS = 40
MAX_CHOICES = 6
MAX_TRIED = 40
"""Wordings that are read; what needs more is too tangled to be sure of."""

_UNITS = frozenset({"TIME", "LENGTH", "ANGLE", "HAND"})

_DO, _DOES, _UNIT = "do ", "does", "unit"
_OF_A_NOUN = frozenset(
    {"bare thing", "bare place", "bare person", "color", "size", "material", "ordinal", _UNIT}
)
"""How what belongs to both alternatives begins, such as the noun in "the red or the blue mug"."""

T = TypeVar("T")
Understood = Callable[[str], tuple[Command, ...] | None]
Asked = Callable[[str], str | None]


def alternatives(
    lattice: Lattice, commands: AbstractSet[str], understood: Understood, asked: Asked
) -> Question | None:
    """The question which of some alternatives is meant; None where there are none that can be told apart.

    Args:
        lattice: The sentence.
        commands: Word classes that a command begins with.
        understood: What a text means, if it means one thing.
        asked: What a text leaves open, if it leaves something open.
    """
    if len(lattice.pieces) > MAX_WORDS:
        return None
    said = Parted(lattice)
    named = _Alternatives(said, commands - MEASURES - HEADINGS, _bounded(understood))
    rows = list(said.rows())
    found = (named.question(row) for row in rows)
    question = next((one for one in found if one is not None), None)
    if question is None:
        asked = _bounded(asked)
        found = (named.question_of_open_ones(row, asked) for row in rows)
        question = next((one for one in found if one is not None), None)
    return question


def _bounded(read: Callable[[str], T | None]) -> Callable[[str], T | None]:
    """The same reader, which reads no text twice, and not too many."""
    known: dict[str, T | None] = {}

    def bounded(text: str) -> T | None:
        if text not in known and len(known) < MAX_TRIED:
            known[text] = read(text)
        return known.get(text)

    return bounded


@dataclass(frozen=True, slots=True)
class _Sentence:
    """The sentence with one of the alternatives, which begins or ends at a place."""

    place: int
    text: str
    commands: tuple[Command, ...]


class _Alternatives:
    """The sentences that a row of alternatives may stand for; places count the words that are parted."""

    def __init__(self, said: Parted, commands: AbstractSet[str], understood: Understood) -> None:
        self._said, self._commands, self._understood = said, commands, understood
        self._size = said.size

    # ---- the sentences with one alternative each

    def question(self, row: Sequence[Gap]) -> Question | None:
        """The question that a row of alternatives leaves open."""
        begun = list(self._begun(row))
        ended = list(self._ended(row)) if begun else []
        pairs = [pair for last in begun for pair in self._nearest(ended, last, row)]
        choices: dict[str, str] = {}
        for first, last in pairs:
            between = self._between(row, first, last)
            if between is None:
                continue
            for one in (first, *between, last):
                choices.setdefault(_meaning(one), one.text)
        if len(choices) < 2:
            return None
        begins = min(last.place for _, last in pairs)
        named = self._said.text([(begins, self._shown_end(max(first.place for first, _ in pairs)))])
        shown = tuple(choices.values()) if len(choices) <= MAX_CHOICES else ()
        return Question(f"{named}: which one is meant?", shown)

    def _nearest(
        self, ended: Sequence[_Sentence], last: _Sentence, row: Sequence[Gap]
    ) -> list[tuple[_Sentence, _Sentence]]:
        """What the last alternative may stand beside, which is said in as many words."""
        fitting = [one for one in ended if self._fits(one, last, row)]
        apart = {one.place: abs(len(one.text.split()) - len(last.text.split())) for one in fitting}
        return [(one, last) for one in fitting if apart[one.place] == min(apart.values())]

    def question_of_open_ones(self, row: Sequence[Gap], asked: Asked) -> Question | None:
        """The question where an alternative leaves something open itself: "put it here or there"."""
        before, behind = row[0].start, row[-1].end
        first = self._said.text([(0, before)])
        message = asked(first)
        if message is None and self._understood(first) is None:
            return None
        for start in self._starts(row):
            for text in self._wordings(start, (behind, self._size), before):
                named = self._said.text([(start, self._shown_end(self._size))])
                if message is not None and asked(text) == message:
                    return Question(f"{named}: which one is meant, and {message}")
                if self._does(start) and self._does(behind) and self._may_be_done(text, first, asked):
                    return Question(f"{named}: which one is meant?")
        return None

    def _may_be_done(self, text: str, first: str, asked: Asked) -> bool:
        """Whether a command means something, or leaves something open, alone or after another one."""
        return any(
            self._understood(one) is not None or asked(one) is not None
            for one in (text, f"{first}, then {text}")
        )

    def _starts(self, row: Sequence[Gap]) -> Iterator[int]:
        """Where the first alternative may begin, the nearest place first."""
        before, begins = row[0].start, self._begins(row[-1].end)
        for start in range(before - 1, max(-1, before - 1 - MAX_SPAN), -1):
            if begins & self._begins(start):
                yield start

    def _shown_end(self, end: int) -> int:
        """Where what is shown of the alternatives ends: with their noun, without a courtesy."""
        while end < self._size and self._begins(end) & _OF_A_NOUN:
            words = self._said.phrase(end)
            end = min(self._size, end + max(one.end - one.start for one in words))
        while end > 1 and self._said.is_closing(end - 1):
            end -= 1
        return end

    def _begun(self, row: Sequence[Gap]) -> Iterator[_Sentence]:
        """The sentence with the last alternative, in the place of the first from where that may begin."""
        before, behind = row[0].start, row[-1].end
        found: dict[str, _Sentence] = {}
        for start in sorted(self._starts(row), key=lambda one: not self._is_repeated(one, behind)):
            texts = self._wordings(start, (behind, self._size), before)
            one = next((each for text in texts if (each := self._meant(start, text))), None)
            if one is not None:
                found.setdefault(_meaning(one), one)
        yield from found.values()

    def _is_repeated(self, start: int, behind: int) -> bool:
        """Whether both alternatives begin with one word: "to the left or to the right"."""
        return self._said.piece(start).text == self._said.piece(behind).text

    def _ended(self, row: Sequence[Gap]) -> Iterator[_Sentence]:
        """The sentence with the first alternative, which goes on behind the last wherever that may end."""
        before, behind = row[0].start, row[-1].end
        for end in dict.fromkeys((*range(behind + 1, min(self._size, behind + MAX_SPAN)), self._size)):
            found = self._meant(end, self._said.text([(0, before), (end, self._size)]))
            if found is not None:
                yield found

    def _meant(self, place: int, text: str) -> _Sentence | None:
        """A sentence, if it means one thing."""
        commands = self._understood(text)
        return None if commands is None else _Sentence(place, text, commands)

    def _between(self, row: Sequence[Gap], first: _Sentence, last: _Sentence) -> list[_Sentence] | None:
        """The sentences with the alternatives between the first and the last; None if one means nothing."""
        found = []
        for gap, following in itertools.pairwise(row):
            text = self._said.text([(0, last.place), (gap.end, following.start), (first.place, self._size)])
            commands = self._understood(text)
            if commands is None:
                return None
            found.append(_Sentence(gap.end, text, commands))
        return found

    def _wordings(self, start: int, said: tuple[int, int], before: int) -> Iterator[str]:
        """The sentence with what is said last, and with the noun or unit that it leaves to the first."""
        noun = self._noun_before(before)
        first, end = said
        last = self._said.phrase(end - 1)
        is_one = any(word.word_class in ONE for word in last)
        if is_one and noun is not None:
            yield self._said.text([(0, start), (first, end - 1), noun])
        yield self._said.text([(0, start), said])
        if not is_one and noun is not None:
            yield self._said.text([(0, start), said, noun])

    def _noun_before(self, place: int) -> tuple[int, int] | None:
        """Where the noun or the unit stands that ends before a place."""
        last = self._said.position(place - 1) + 1
        for start in range(max(0, place - 4), place):
            for word in self._said.phrase(start):
                if word.end == last and (word.word_class in SORTS or word.word_class in _UNITS):
                    return start, place
        return None

    # ---- whether two of them are alternatives

    def _fits(self, first: _Sentence, last: _Sentence, row: Sequence[Gap]) -> bool:
        if self._does(last.place) and self._does(row[-1].end):
            return _meaning(first) != _meaning(last)
        differing = only_slots_that_differ(first.commands, last.commands)
        if differing is None:
            return False
        changed, only_before, only_behind = differing
        if len(changed) == 1 and not only_before and not only_behind:
            return True
        if first.place != self._size or only_behind:
            return False
        if not only_before:  # "the cup to Ana or the bowl to Tom"
            return len(first.text.split()) == len(last.text.split()) and bool(changed)
        return changed == {"object"}

    def _does(self, place: int) -> bool:
        """Whether what begins at a place may be a command."""
        return _DOES in self._begins(place)

    def _begins(self, place: int) -> set[str]:
        """As what a phrase that starts at a place can be taken; any command may stand for any other."""
        found = beginnings(self._said.phrase(place), self._commands)
        units = any(one.word_class in _UNITS for one in self._said.phrase(place))
        return {_DOES if one.startswith(_DO) else one for one in found} | ({_UNIT} if units else set())


def _meaning(one: _Sentence) -> str:
    return repr([command_json(each) for each in one.commands])
