"""Contrasts, which name what is not meant beside what is: "the red cup, not the blue one".

A contrast denies nothing of the command. What is left without it must mean one thing, and what it names must
be something else than anything that is left (``set_apart``): "the cup, not the red one" says less than "the
cup", and stays refused, like every denied command. Where it can be cut out in two ways that differ, it stays
refused too.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from executive.language.phrases import Item, Items, Where
from executive.language.taken_back.beginnings import HEADINGS, MEASURES, beginnings
from executive.language.taken_back.set_apart import Apart
from executive.language.taken_back.taking_back import Span
from executive.language.words.lattice import Lattice
from executive.language.words.word import Word
from executive.meaning import Command, command_json
from trees.tasks import SayTask

CONTRAST = "CONTRAST"

NOT, INSTEAD, FORGET = "not", "instead", "forget"
"""Meanings in the vocabulary: "not", "instead of", and "forget", which names what is said no more of."""

MAX_WORDS = 40
MAX_EXCLUDED = 8
"""Words that may name what is not meant, so that no text takes long."""

_NEGATION = "NEGATION"
_BUT, _INSTEAD = "but", "instead"
_JOINS = frozenset({"SEP", "AND", "BEFORE", "AFTER", "AFTER_DOING"})
_WEAK = frozenset({",", ":", "-"})
"""Marks after which what is said may still belong to what stands before them."""

_PASSED = frozenset({"FILLER", "OPENING", "WISH", "ADDRESSED"})
_PLACING = frozenset({"where", "from", "with", "person", "number"})
_UNITS = frozenset({"TIME", "LENGTH", "ANGLE", "LINEAR_SPEED", "ANGULAR_SPEED", "FOR", "BY"})
_SMALL = frozenset({"DET", "HAND", "SIDE", "ONE", "ON", "AT", "TO", "WITH", "USE", "IN"})
_ALONE = (
    frozenset({"LEFT_RIGHT", "TURN_SIDE"}),
    frozenset({"FORWARD", "BACKWARD"}),
    frozenset({"NUM", "AMOUNT", "TENS"}),
)
"""Classes of words that may be all that is not meant: "turn left, not right"; "five seconds, not ten"."""


@dataclass(frozen=True, slots=True)
class Reader:
    """What a contrast asks of the parser.

    Attributes:
        understood: What a text means, if it means one thing.
        meanings: What a text means as a rule of the grammar.
        sort_of: "room" or "place" of the name of a place, "" of other names.
        commands: Word classes that a command begins with.
    """

    understood: Callable[[str], tuple[Command, ...] | None]
    meanings: Callable[[str, str], Sequence[Any]]
    sort_of: Callable[[str], str]
    commands: AbstractSet[str]


@dataclass(frozen=True, slots=True)
class _Cut:
    """One way to cut a contrast out: what it names, and what is left."""

    excluded: Span
    left: str
    whole: bool
    """Whether nothing follows but other commands."""
    doubtful: bool
    """Whether what follows may be said of what is not meant: "the cup, not the bowl on the table"."""


def contrasted(lattice: Lattice, reader: Reader) -> tuple[Command, ...] | None:
    """What a sentence with a contrast means; None where that is open, or there is no contrast."""
    word = only_contrast(lattice)
    if word is None or len(lattice.pieces) > MAX_WORDS or any(piece.quoted for piece in lattice.pieces):
        return None
    return _Contrast(lattice, word, reader).commands()


def only_contrast(lattice: Lattice) -> Word | None:
    """The contrast of a sentence in which nothing else denies."""
    found: Word | None = None
    position, size = 0, len(lattice.pieces)
    while position < size:
        denying = [one for one in lattice.phrase(position) if one.word_class in (CONTRAST, _NEGATION)]
        longest = max(denying, key=lambda one: (one.end, one.word_class == CONTRAST), default=None)
        if longest is None:
            position += 1
        elif longest.word_class == CONTRAST and found is None:
            found, position = longest, longest.end
        elif found is not None and (longest.said == _BUT or (longest.said, longest.end) == (_INSTEAD, size)):
            position = longest.end  # "not the cup but the bowl"; "not the cup, take the bowl instead"
        else:
            return None
    return found


class _Contrast:
    """One contrast, with every way to cut it out."""

    def __init__(self, lattice: Lattice, word: Word, reader: Reader) -> None:
        self._lattice, self._word, self._reader = lattice, word, reader
        self._end = len(lattice.pieces)
        if lattice.pieces[-1].text == _INSTEAD:
            self._end -= 1

    def commands(self) -> tuple[Command, ...] | None:
        """The one meaning, or None."""
        found: dict[str, tuple[Command, ...]] = {}
        for cut in self._cuts():
            if not self._names_something(cut.excluded, whole=cut.whole):
                continue
            commands = self._reader.understood(cut.left)
            if commands is None:
                continue
            speaks = any(isinstance(one, SayTask) for one in commands)
            if speaks or cut.doubtful or not self._is_apart(cut.excluded, commands):
                return None
            found[repr([command_json(one) for one in commands])] = commands
        return next(iter(found.values())) if len(found) == 1 else None

    # ---- where what is not meant may end, and what is left then

    def _cuts(self) -> Iterator[_Cut]:
        first = self._word.end
        for end in range(first + 1, min(self._end, first + MAX_EXCLUDED) + 1):
            rest = end
            while rest < self._end and (self._joins(rest) or self._is_but(rest)):
                rest = max((one.end for one in self._lattice.phrase(rest)), default=rest + 1)
            left = None if self._lattice.pieces[end - 1].is_mark else self._left(end, rest)
            if left is not None:
                whole = rest >= self._end or self._begins_anew(rest)
                doubtful = not whole and rest == end and self._commands_before and not self._breaks_off
                yield _Cut(Span(first, end), " ".join(left), whole, doubtful)

    def _left(self, end: int, rest: int) -> list[str] | None:
        """What is left if what is not meant ends at a place, before conjunctions; None if it cannot."""
        before = self._texts(0, self._word.start)
        said = before[: self._stripped(self._word.start)]
        following = self._texts(rest, self._end)
        if rest >= self._end:
            return said if self._commands_before and self._word.meaning != FORGET else None
        if any(map(self._is_but, range(end, rest))):
            return said + following if self._word.meaning == NOT else None
        if self._begins_anew(rest):
            if not self._commands_before or self._is_apart_from_before:
                return before + following
            goes_on = rest > end and self._word.meaning != FORGET
            return said + self._texts(end, self._end) if goes_on else None
        if self._word.meaning == FORGET or not all(map(self._is_comma, range(end, rest))):
            return None  # "not the bowl and the spoon": is the spoon meant?
        if not self._commands_before:
            return said + following  # "not the bowl, the cup: bring me the cup"
        placing = beginnings(self._lattice.phrase(rest), self._reader.commands) & _PLACING
        if rest == end:
            placing -= {"number"}  # "the right one"
        return said + following if placing or self._breaks_off else None

    @cached_property
    def _breaks_off(self) -> bool:
        """Whether what stands before the contrast is no sentence yet: "give Ana, not Ben, the cup"."""
        said = self._texts(0, self._stripped(self._word.start))
        return self._reader.understood(" ".join(said)) is None

    @cached_property
    def _commands_before(self) -> bool:
        """Whether some command begins before the contrast."""
        return any(map(self._is_command, range(self._word.start)))

    @cached_property
    def _is_apart_from_before(self) -> bool:
        """Whether more than a comma ends what stands before the contrast: "open it and, instead of ..."."""
        position = self._word.start - 1
        while position >= 0 and self._is_comma(position):
            position -= 1
        return position >= 0 and self._ends_join(position)

    def _is_command(self, position: int) -> bool:
        classes = {one.word_class for one in self._lattice.phrase(position)}
        return bool(classes & self._reader.commands - MEASURES - HEADINGS)

    def _begins_anew(self, position: int) -> bool:
        """Whether a command begins at a place, or a courtesy before one."""
        if position >= self._end:
            return False
        passed = [one.end for one in self._lattice.phrase(position) if one.word_class in _PASSED]
        return self._is_command(position) or any(map(self._begins_anew, passed))

    def _joins(self, position: int) -> bool:
        """Whether a mark or a conjunction stands at a place."""
        words = self._lattice.phrase(position)
        longest = max((one.end for one in words), default=position)
        joins = any(one.word_class in _JOINS and one.end == longest for one in words)
        return self._lattice.pieces[position].is_mark or joins

    def _ends_join(self, position: int) -> bool:
        """Whether a mark or a conjunction ends at a place."""
        words = (one for start in range(position + 1) for one in self._lattice.phrase(start))
        ends = any(one.word_class in _JOINS and one.end == position + 1 for one in words)
        return self._lattice.pieces[position].is_mark or ends

    def _is_comma(self, position: int) -> bool:
        return self._lattice.pieces[position].text in _WEAK

    def _is_but(self, position: int) -> bool:
        """Whether "but" stands there, and not "but first", which orders."""
        orders = any(one.word_class == "BUT_FIRST" for one in self._lattice.phrase(position))
        return self._lattice.pieces[position].text == _BUT and not orders

    def _stripped(self, end: int) -> int:
        """Where what stands before a place ends without its marks."""
        while end > 0 and self._lattice.pieces[end - 1].is_mark:
            end -= 1
        return end

    def _texts(self, start: int, end: int) -> list[str]:
        plain, pieces = self._lattice.plain, self._lattice.pieces
        return [plain[one.start : one.end] for one in pieces[start:end]]

    # ---- whether it is something else than what is meant

    def _text(self, span: Span) -> str:
        return " ".join(self._texts(span.start, span.end))

    def _names_something(self, span: Span, *, whole: bool) -> bool:
        named = self._named(span)
        if len(named) > 1 and self._commands_before and not self._is_apart_from_before:
            return False  # "take the cup, not the bowl and the spoon": is the spoon meant?
        return bool(named) or self._is_turned(span) or (whole and self._done(span) is not None)

    def _named(self, span: Span) -> list[Item | Where]:
        """The things, people and places that some words may name."""
        text = self._text(span)
        items = [one for one in self._reader.meanings("items", text) if isinstance(one, Items)]
        named: list[Item | Where] = list(dict.fromkeys(item for one in items for item in one.each))
        named += [one for one in self._reader.meanings("where", text) if isinstance(one, Where)]
        for noun in (self._noun_before if text.endswith("'s") else None, "one"):
            if noun and not named:  # "Ana's cup, not Ben's"; "the red, not the blue, cup"
                wordings = self._reader.meanings("item", f"{text} {noun}")
                named += [one for one in wordings if isinstance(one, Item)]
        return named

    @cached_property
    def _noun_before(self) -> str | None:
        """The last thing that is named before the contrast."""
        words = [one for start in range(self._word.start) for one in self._lattice.phrase(start)]
        return next((one.said for one in reversed(words) if one.word_class == "KIND"), None)

    def _done(self, span: Span) -> tuple[Command, ...] | None:
        """What is not to be done: "instead of walking to the kitchen"."""
        return self._reader.understood(self._text(span)) if self._word.meaning == INSTEAD else None

    def _is_apart(self, span: Span, commands: Sequence[Command]) -> bool:
        apart = Apart([command_json(one) for one in commands], self._reader.sort_of)
        named = self._named(span)
        if self._word.meaning == FORGET:
            return bool(named) and all(apart.is_unrelated(one) or apart.stands_beside(one) for one in named)
        if self._is_turned(span):
            return True
        if named:
            return all(map(apart.stands_beside, named))
        return apart.differs_from([command_json(one) for one in self._done(span) or ()])

    def _is_turned(self, span: Span) -> bool:
        """Whether it says no more than the other side, way or number: "turn left, not right"."""
        before = [one for start in range(self._word.start) for one in self._lattice.phrase(start)]
        repeated = {word for one in before for word in one.said.split()}
        for classes in _ALONE:
            allowed = classes | _SMALL | (_UNITS if "NUM" in classes else frozenset())
            anew = self._meanings(range(span.start, span.end), classes)
            old = self._meanings(range(self._word.start), classes)
            old = old or self._meanings(range(span.end, self._end), classes)  # "not left but right"
            if len(anew) != 1 or len(old) != 1 or anew == old:
                continue
            return all(
                self._lattice.pieces[position].text in repeated
                or any(one.word_class in allowed for one in self._lattice.phrase(position))
                for position in range(span.start, span.end)
            )
        return False

    def _meanings(self, places: range, classes: AbstractSet[str]) -> set[str]:
        """What words of some classes mean that begin at some places."""
        words = (one for start in places for one in self._lattice.phrase(start))
        return {one.meaning for one in words if one.word_class in classes}
