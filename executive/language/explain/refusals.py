"""Why a sentence that nobody could read is refused: what was understood of it, and which words were not."""

from __future__ import annotations

import importlib.resources
import tomllib
from collections.abc import Iterator, Mapping, Sequence
from collections.abc import Set as AbstractSet
from functools import cache

from executive.language.chart.chart import Chart
from executive.language.explain.examples import EXAMPLES, nearest_example
from executive.language.explain.typos import is_slip, meant_by
from executive.language.text.lattice import Lattice
from executive.language.text.word import Word
from executive.meaning import Refusal
from executive.vocabulary import Vocabulary

__all__ = ["EXAMPLES", "Explainer", "printable"]

_SHOWN = 40
"""Characters of an offending word that are repeated to the user."""

_SHOWN_OF_A_PART = 80
"""Characters of what was understood, and of what was not, that are repeated to the user."""

_KNOWN_WORDS = 2
"""So many words of a sentence must be known for one that is mistyped: another language is not mended."""

_ANYWHERE = ("deciding", "taking_back", "forbidding")
"""Lists of word classes that explain a refusal wherever they stand, the best first."""


def printable(word: str, longest: int = _SHOWN) -> str:
    """A word that may be shown: bounded, with escapes for what a terminal could take for control."""
    short = word if len(word) <= longest else word[:longest] + "\u2026"
    return "".join(one if one.isprintable() else f"\\x{ord(one):02x}" for one in short)


@cache
def classes_of(name: str) -> frozenset[str]:
    """A list of word classes of ``refusals.toml``."""
    text = (
        importlib.resources.files("executive.language.explain").joinpath("refusals.toml").read_text("utf-8")
    )
    return frozenset(tomllib.loads(text)[name])


@cache
def messages() -> Mapping[str, str]:
    """What is said of word classes that the grammar uses, where a sentence breaks off at one."""
    folder = importlib.resources.files("executive.language.explain")
    found: Mapping[str, str] = tomllib.loads(folder.joinpath("refusals.toml").read_text("utf-8"))["messages"]
    return found


class Explainer:
    """Finds the words that caused a refusal."""

    def __init__(self, vocabulary: Vocabulary) -> None:
        self._vocabulary = vocabulary

    def explain(self, lattice: Lattice, chart: Chart) -> Refusal:
        """Why there is no parse."""
        if not lattice.pieces:
            shown = printable(lattice.plain)
            return Refusal(f"{shown!r} says nothing to do", shown, EXAMPLES[0])
        broken = max(chart.furthest, lattice.first_said)
        understood = chart.understood()
        for name in _ANYWHERE:
            found = next(self._refused(lattice, classes_of(name), range(len(lattice.pieces))), None)
            if found is not None:
                return self._told(found, lattice, understood)
        begun = self._begun_with_no_skill(lattice, chart)
        if begun is not None:
            return self._told(begun, lattice, understood)
        unknown = lattice.unknown()
        if unknown is not None and unknown <= broken:
            return self._unknown(lattice, chart, unknown, understood)
        if understood is not None:
            return self._only_a_part(lattice, understood)
        if unknown is not None:
            return self._unknown(lattice, chart, unknown, None)
        here = self._refused(lattice, None, (broken, broken - 1), chart)
        ended = broken >= len(lattice.pieces) or lattice.ends[broken]
        last = classes_of("at_last")
        found = next(self._refused(lattice, last, range(len(lattice.pieces))) if ended else here, None)
        if found is not None:
            return self._told(found, lattice, None)
        if ended and chart.has_beginning_of("command"):
            return self._incomplete(lattice, chart)
        shown = printable(lattice.pieces[min(broken, len(lattice.pieces) - 1)].text)
        if lattice.may_begin(broken) or not chart.has_beginning_of("command"):
            first = printable(lattice.pieces[lattice.first_said].text)
            message, shown = f"a command begins with what to do, not with {first!r}", first
        else:
            before = printable(lattice.pieces[broken - 1].text)
            message = f"{shown!r} does not fit after {before!r}"
        return Refusal(message, shown, self.nearest_example(lattice.plain))

    def forbids(self, lattice: Lattice, chart: Chart) -> bool:
        """Whether a word of a sentence is never acted on, so that nothing is asked about the rest."""
        places = range(len(lattice.pieces))
        found = (next(self._refused(lattice, classes_of(name), places), None) for name in _ANYWHERE)
        return any(one is not None for one in found) or self._begun_with_no_skill(lattice, chart) is not None

    def _refused(
        self,
        lattice: Lattice,
        only: frozenset[str] | None,
        places: Sequence[int],
        chart: Chart | None = None,
    ) -> Iterator[Word]:
        """Words that are known and never acted on, of some classes, the longest of each place first."""
        for position in places:
            words = lattice.phrase(position) if 0 <= position < len(lattice.pieces) else ()
            if chart is not None and chart.begins_command(words):
                continue
            for word in sorted(words, key=lambda one: -one.end):
                wanted = word.word_class in only if only else word.word_class not in classes_of("small_words")
                if wanted and self._message(word) is not None:
                    yield word

    def _message(self, word: Word) -> str | None:
        """What a word is refused with; None where it is none that is refused."""
        said = printable(word.said)
        used = messages().get(word.word_class)
        if used is not None:
            return used.format(word=said)
        return self._vocabulary.refusal_of(word.word_class, word.meaning, said)

    def _told(self, word: Word, lattice: Lattice, understood: tuple[int, int] | None) -> Refusal:
        """Refuse a word, and say what was understood beside it."""
        message = self._message(word) or ""
        part = self._part(lattice, understood)
        beside = understood is not None and not understood[0] <= word.start < understood[1]
        if part and beside:
            message = f"I understood {part!r}; {message}"
        return Refusal(message, printable(word.said), None)

    @staticmethod
    def _part(lattice: Lattice, understood: tuple[int, int] | None) -> str:
        return "" if understood is None else printable(lattice.text(*understood), _SHOWN_OF_A_PART)

    def _only_a_part(self, lattice: Lattice, understood: tuple[int, int]) -> Refusal:
        """Refuse what stands beside a command, and show the command."""
        start, end = understood
        while end < len(lattice.pieces) and lattice.pieces[end].is_mark:
            end += 1
        behind, before = lattice.text(end, len(lattice.pieces)), lattice.text(0, start)
        rest = printable(behind or before, _SHOWN_OF_A_PART)
        part = self._part(lattice, understood)
        if not rest:
            return self._together(lattice)
        message = f"I understood {part!r}; I did not understand {rest!r}. Say only the command"
        return Refusal(message, rest, None)

    def _begun_with_no_skill(self, lattice: Lattice, chart: Chart) -> Word | None:
        """What a clause begins with that is no skill and can be read as no command: "clean the cup"."""
        for start in range(min(max(chart.furthest, lattice.first_said) + 1, len(lattice.pieces))):
            joined = start > 0 and (lattice.pieces[start - 1].is_mark or lattice.ends_with(start, _JOINS))
            words = lattice.phrase(start) if joined or lattice.may_begin(start) else ()
            done = next(self._refused(lattice, classes_of("of_no_skill"), (start,)), None) if words else None
            if done is not None and not chart.begins_command(one for one in words if one.end >= done.end):
                return done
        return None

    def _together(self, lattice: Lattice) -> Refusal:
        message = "the words are known, but together they are no task of this robot; say it in shorter steps"
        last = printable(lattice.pieces[-1].text)
        return Refusal(message, last, self.nearest_example(lattice.plain))

    def _incomplete(self, lattice: Lattice, chart: Chart) -> Refusal:
        if chart.unfit:
            return self._together(lattice)
        last = next((one.text for one in reversed(lattice.pieces) if not one.is_mark), lattice.plain)
        message = f"after {printable(last)!r} something is missing"
        return Refusal(message, printable(last), self.nearest_example(lattice.plain))

    def _unknown(
        self, lattice: Lattice, chart: Chart, position: int, understood: tuple[int, int] | None
    ) -> Refusal:
        """Refuse an unknown word, with the known one that may have been meant."""
        text = lattice.pieces[position].text
        shown = printable(text)
        message, nearest = f"the word {shown!r} is not known", self.nearest_example(lattice.plain)
        part = self._part(lattice, understood)
        if part:
            message = f"I understood {part!r}; {message}"
        expected = chart.expected if position == chart.furthest else None
        near = [one for one in meant_by(text, self._vocabulary.single_words) if self._fits(one, expected)]
        if near and len(lattice.unknown_pieces()) * _KNOWN_WORDS <= len(lattice.pieces):
            message = f"{message}; did you mean {near[0]!r}?"
        return Refusal(message, shown, nearest)

    def _fits(self, word: str, expected: AbstractSet[str] | None) -> bool:
        """Whether a word may stand where some word classes are expected."""
        found = {reading.word_class for _, reading in self._vocabulary.matches([word], 0)}
        return expected is None or not found.isdisjoint(expected)

    def is_mistyped(self, word: str) -> bool:
        """Whether what looks like a name is rather a known word, mistyped."""
        near = meant_by(word, self._vocabulary.single_words)
        return any(not self._is_name(one) or is_slip(word, one) for one in near)

    def _is_name(self, word: str) -> bool:
        return {reading.word_class for _, reading in self._vocabulary.matches([word], 0)} <= _NAMES

    def nearest_example(self, text: str) -> str | None:
        """A valid wording of what a text says to do."""
        return nearest_example(text, self._vocabulary)


_JOINS = frozenset({"SEP", "AND"})
_NAMES = frozenset({"NAME", "OWNER"})
