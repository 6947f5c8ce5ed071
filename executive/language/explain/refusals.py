"""Why a sentence that nobody could read is refused: what was understood of it, and which words were not."""

from __future__ import annotations

import importlib.resources
import tomllib
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cache
from typing import Any

from executive.language.chart.chart import Chart
from executive.language.explain.typos import is_slip, meant_by
from executive.language.text.lattice import Lattice
from executive.language.text.word import Word
from executive.meaning import Refusal
from executive.vocabulary import Vocabulary
from executive.vocabulary.written import split_words

_SHOWN = 40
"""Characters of an offending word that are repeated to the user."""

_SHOWN_OF_A_PART = 80
"""Characters of what was understood, and of what was not, that are repeated to the user."""

_KNOWN_WORDS = 2
"""So many words of a sentence must be known for one that is mistyped: another language is not mended."""

_LONGEST = 60
"""Words of which an example is looked for, so that no text takes long."""

_TOGETHER = "the words are known, but together they are no task of this robot; say it in shorter steps"
_JOINS = frozenset({"SEP", "AND"})
_NAMES = frozenset({"NAME", "OWNER"})
_BEFORE_A_NOUN = frozenset({"DET", "ARTICLE", "OF"})


def printable(word: str, longest: int = _SHOWN) -> str:
    """A word that may be shown: bounded, with escapes for what a terminal could take for control."""
    short = word if len(word) <= longest else word[:longest] + "\u2026"
    return "".join(one if one.isprintable() else f"\\x{ord(one):02x}" for one in short)


@cache
def explanations() -> Mapping[str, Any]:
    """What ``explanations.toml`` says; see there."""
    folder = importlib.resources.files("executive.language.explain")
    return tomllib.loads(folder.joinpath("explanations.toml").read_text("utf-8"))


def examples() -> Sequence[str]:
    """Valid wordings, one or two of each action."""
    said: Sequence[str] = explanations()["examples"]
    return said


class Explainer:
    """Finds the words that caused a refusal."""

    def __init__(self, vocabulary: Vocabulary) -> None:
        self._vocabulary = vocabulary

    def explain(self, lattice: Lattice, chart: Chart) -> Refusal:
        """Why there is no parse."""
        size = len(lattice.pieces)
        if not size:
            return Refusal(f"{printable(lattice.plain)!r} says nothing to do", lattice.plain, examples()[0])
        broken = max(chart.furthest, lattice.first_said)
        understood = chart.understood()
        forbidden = next(self._forbidden(lattice, chart), None)
        if forbidden is not None:
            return self._told(forbidden, lattice, understood)
        unknown = lattice.unknown()
        if unknown is not None and (understood is None or unknown <= broken):
            return self._unknown(lattice, chart, unknown, understood)
        if understood is not None:
            return self._only_a_part(lattice, *understood)
        ended = broken >= size or lattice.ends[broken]
        behind = self._refused(lattice, explanations()["behind"], range(size))
        here = self._refused(lattice, None, (broken, broken - 1), chart)
        found = next(behind if ended else here, None)
        if found is not None:
            return self._told(found, lattice, None)
        if lattice.may_begin(broken):
            return self._at(lattice, lattice.first_said, "a command begins with what to do, not with {!r}")
        if ended and chart.unfit:
            return self._at(lattice, size - 1, _TOGETHER)
        if ended:
            last = max((at for at in range(size) if not lattice.pieces[at].is_mark), default=0)
            return self._at(lattice, last, "after {!r} something is missing")
        before = printable(lattice.pieces[broken - 1].text)
        return self._at(lattice, broken, f"{{!r}} does not fit after {before!r}")

    def _at(self, lattice: Lattice, position: int, message: str) -> Refusal:
        """Refuse a piece, and offer what looks like the sentence."""
        shown = printable(lattice.pieces[position].text)
        return Refusal(message.format(shown), shown, self.nearest_example(lattice.plain))

    def forbids(self, lattice: Lattice, chart: Chart) -> bool:
        """Whether a word of a sentence is never acted on, so that nothing is asked about the rest."""
        return next(self._forbidden(lattice, chart), None) is not None

    def _forbidden(self, lattice: Lattice, chart: Chart) -> Iterator[Word]:
        """Words that explain a refusal wherever they stand, and then those that begin a clause."""
        size = len(lattice.pieces)
        for classes in explanations()["anywhere"]:
            yield from self._refused(lattice, classes, range(size))
        for start in range(min(max(chart.furthest, lattice.first_said) + 1, size)):
            joined = start > 0 and (lattice.pieces[start - 1].is_mark or lattice.ends_with(start, _JOINS))
            if joined or lattice.may_begin(start):
                for done in self._refused(lattice, explanations()["beginning"], (start,)):
                    if not chart.begins_command(one for one in lattice.phrase(start) if one.end >= done.end):
                        yield done

    def _refused(
        self, lattice: Lattice, only: Sequence[str] | None, places: Iterable[int], chart: Chart | None = None
    ) -> Iterator[Word]:
        """Words that are known and never acted on, of some classes, the longest of each place first."""
        for position in places:
            words = lattice.phrase(position) if 0 <= position < len(lattice.pieces) else ()
            if chart is not None and chart.begins_command(words):
                continue
            for word in sorted(words, key=lambda one: -one.end):
                wanted = (
                    word.word_class in only if only else word.word_class not in explanations()["small_words"]
                )
                if wanted and self._message(word) is not None:
                    yield word

    def _message(self, word: Word) -> str | None:
        """What a word is refused with; None where it is none that is refused."""
        said = printable(word.said)
        used: str | None = explanations()["messages"].get(word.word_class)
        return (
            used.format(word=said)
            if used
            else self._vocabulary.refusal_of(word.word_class, word.meaning, said)
        )

    def _told(self, word: Word, lattice: Lattice, understood: tuple[int, int] | None) -> Refusal:
        """Refuse a word, and say what was understood beside it."""
        beside = understood is not None and not understood[0] <= word.start < understood[1]
        part = self._part(lattice, understood) if beside else ""
        return Refusal(f"{part}{self._message(word)}", printable(word.said), None)

    @staticmethod
    def _part(lattice: Lattice, understood: tuple[int, int] | None) -> str:
        """How a message begins that says what was understood."""
        text = "" if understood is None else printable(lattice.text(*understood), _SHOWN_OF_A_PART)
        return f"I understood {text!r}; " if text else ""

    def _only_a_part(self, lattice: Lattice, start: int, end: int) -> Refusal:
        """Refuse what stands beside a command, and show the command."""
        part = self._part(lattice, (start, end))
        while end < len(lattice.pieces) and lattice.pieces[end].is_mark:
            end += 1
        behind, before = lattice.text(end, len(lattice.pieces)), lattice.text(0, start)
        rest = printable(behind or before, _SHOWN_OF_A_PART)
        if not rest:
            return self._at(lattice, end - 1, _TOGETHER)
        return Refusal(f"{part}I did not understand {rest!r}. Say only the command", rest, None)

    def _unknown(
        self, lattice: Lattice, chart: Chart, position: int, understood: tuple[int, int] | None
    ) -> Refusal:
        """Refuse an unknown word, with the known one that may have been meant."""
        text = lattice.pieces[position].text
        message = f"{self._part(lattice, understood)}the word {{!r}} is not known"
        expected = chart.expected if position == chart.furthest else None
        near = [
            one
            for one in meant_by(text, self._vocabulary.single_words)
            if expected is None or not self._begun([one]).isdisjoint(expected)
        ]
        if near and len(lattice.unknown_pieces()) * _KNOWN_WORDS <= len(lattice.pieces):
            message = f"{message}; did you mean {near[0]!r}?"
        return self._at(lattice, position, message)

    def is_mistyped(self, word: str) -> bool:
        """Whether what looks like a name is rather a known word, mistyped."""
        near = meant_by(word, self._vocabulary.single_words)
        return any(not self._begun([one]) <= _NAMES or is_slip(word, one) for one in near)

    def nearest_example(self, text: str) -> str | None:
        """The valid wording of an action that a text names which looks most like it, if there is one."""
        said = _words_of(text)[:_LONGEST]
        begun = {
            name for at in range(len(said)) if not self._is_noun(said, at) for name in self._begun(said[at:])
        }
        fitting = [one for one in examples() if not begun.isdisjoint(self._begun(_words_of(one)))]
        words = {word.rstrip("s") for word in said}
        return max(fitting, key=lambda one: len(words & set(_words_of(one))) / len(one.split()), default=None)

    def _begun(self, said: Sequence[str]) -> set[str]:
        """The word classes of the longest phrase that some words begin with."""
        return {reading.word_class for reading in self._vocabulary.match(said)[1]}

    def _is_noun(self, said: Sequence[str], at: int) -> bool:
        """Whether a word that may be a verb is none, for an article stands before it: "the watch"."""
        return at > 0 and not self._begun(said[at - 1 : at]).isdisjoint(_BEFORE_A_NOUN)


def _words_of(text: str) -> list[str]:
    return [word for word, _, _ in split_words(text)]
