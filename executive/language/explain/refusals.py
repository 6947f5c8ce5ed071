"""Why a sentence that nobody could read is refused: what was understood of it, and which words were not."""

from __future__ import annotations

import importlib.resources
import tomllib
from collections.abc import Iterable, Iterator, Mapping, Sequence
from collections.abc import Set as AbstractSet
from functools import cache
from typing import Any

from executive.language.chart.chart import Chart
from executive.language.explain.typos import is_slip, meant_by
from executive.language.text.lattice import Lattice
from executive.language.text.word import Word
from executive.meaning import Refusal
from executive.vocabulary import Reading, Vocabulary
from executive.vocabulary.written import split_words

_SHOWN, _SHOWN_OF_A_PART = 40, 80
"""Characters of an offending word that are repeated to the user, and of what was understood or was not."""

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
    return tuple(explanations()["examples"])


class Explainer:
    """Finds the words that caused a refusal."""

    def __init__(self, vocabulary: Vocabulary) -> None:
        self._vocabulary = vocabulary

    def explain(self, lattice: Lattice, chart: Chart) -> Refusal:
        """Why there is no parse."""
        size = len(lattice.pieces)
        if not size:
            shown = printable(lattice.plain)
            return Refusal(f"{shown!r} says nothing to do", shown, examples()[0])
        broken = max(chart.furthest, lattice.first_said)
        understood = chart.understood()
        part = "" if understood is None else printable(lattice.text(*understood), _SHOWN_OF_A_PART)
        part = f"I understood {part!r}; " if part else ""
        forbidden = next(self._forbidden(lattice, chart), None)
        if forbidden is not None:
            inside = understood is not None and understood[0] <= forbidden.start < understood[1]
            return self._told(forbidden, "" if inside else part)
        unknown = next(iter(lattice.unknown()), None)
        if unknown is not None and (understood is None or unknown <= broken):
            mended = self._mended(
                lattice, unknown, chart.expected_at(unknown) if unknown == chart.furthest else None
            )
            return self._at(lattice, unknown, f"{part}the word ", f" is not known{mended}")
        if understood is not None:
            rest = printable(_beside(lattice, *understood), _SHOWN_OF_A_PART)
            if not rest:
                return Refusal(_TOGETHER, None, self.nearest_example(lattice.plain))
            return Refusal(f"{part}I did not understand {rest!r}. Say only the command", rest, None)
        ended = broken >= size or lattice.ends[broken]
        places = range(size) if ended else (broken, broken - 1)
        found = next(self._refused(lattice, explanations()["behind"] if ended else None, places), None)
        if found is not None:
            return self._told(found, "")
        if lattice.may_begin(broken):
            return self._at(lattice, lattice.first_said, "a command begins with what to do, not with ")
        if ended and chart.unfit:
            return Refusal(_TOGETHER, None, self.nearest_example(lattice.plain))
        if ended:
            last = max((at for at in range(size) if not lattice.pieces[at].is_mark), default=0)
            return self._at(lattice, last, "after ", " something is missing")
        before = printable(lattice.pieces[broken - 1].text)
        return self._at(lattice, broken, "", f" does not fit after {before!r}")

    def _at(self, lattice: Lattice, position: int, before: str, behind: str = "") -> Refusal:
        """Refuse a piece, and offer what looks like the sentence."""
        shown = printable(lattice.pieces[position].text)
        return Refusal(f"{before}{shown!r}{behind}", shown, self.nearest_example(lattice.plain))

    def _told(self, word: Word, part: str) -> Refusal:
        """Refuse a word behind what was understood beside it."""
        return Refusal(f"{part}{self._message(word)}", printable(word.said), None)

    def forbids(self, lattice: Lattice, chart: Chart) -> bool:
        """Whether a word of a sentence is never acted on, so that nothing is asked about the rest."""
        return next(self._forbidden(lattice, chart), None) is not None

    def _forbidden(self, lattice: Lattice, chart: Chart) -> Iterator[Word]:
        """Words that explain a refusal wherever they stand, and then those that begin a clause."""
        size = len(lattice.pieces)
        for classes in explanations()["anywhere"]:
            yield from self._refused(lattice, classes, range(size))
        for start in range(min(max(chart.furthest, lattice.first_said) + 1, size)):
            if begins_clause(lattice, start):
                verbs = [one.end for one in lattice.phrases[start] if one.word_class in chart.verbs]
                for done in self._refused(lattice, explanations()["beginning"], (start,)):
                    if done.end > max(verbs, default=0):
                        yield done

    def _refused(self, lattice: Lattice, only: Sequence[str] | None, places: Iterable[int]) -> Iterator[Word]:
        """Words that are known and never acted on, of some classes, the longest of each place first."""
        for position in places:
            words = lattice.phrases[position] if 0 <= position < len(lattice.pieces) else ()
            for word in sorted(words, key=lambda one: -one.end):
                if (only is None or word.word_class in only) and self._message(word) is not None:
                    yield word

    def _message(self, word: Word) -> str | None:
        """What a word is refused with; None where it is none that is refused."""
        said = printable(word.said)
        used: str | None = explanations()["messages"].get(word.word_class)
        if used is not None:
            return used.format(word=said)
        return self._vocabulary.refusal(Reading(word.word_class, word.meaning), said)

    def _mended(self, lattice: Lattice, position: int, expected: AbstractSet[str] | None) -> str:
        """The known word that an unknown one may have been meant to be, as a question."""
        near = [
            one
            for one in meant_by(lattice.pieces[position].text, self._vocabulary.single_words)
            if expected is None or not self._begun([one]).isdisjoint(expected)
        ]
        foreign = len(lattice.unknown()) * _KNOWN_WORDS > len(lattice.pieces)
        return f"; did you mean {near[0]!r}?" if near and not foreign else ""

    def is_mistyped(self, word: str) -> bool:
        """Whether what looks like a name is rather a known word, mistyped."""
        near = meant_by(word, self._vocabulary.single_words)
        return any(not self._begun([one]) <= _NAMES or is_slip(word, one) for one in near)

    def nearest_example(self, text: str) -> str | None:
        """The valid wording of an action that a text names which looks most like it, if there is one."""
        said = _words_of(text)[:_LONGEST]
        verbs = [
            self._begun(said[at:])
            for at in range(len(said))
            if at == 0 or self._begun([said[at - 1]]).isdisjoint(_BEFORE_A_NOUN)  # "the watch" is no verb
        ]
        begun: set[str] = set().union(*verbs)
        fitting = [one for one in examples() if not begun.isdisjoint(self._begun(_words_of(one)))]
        words = {word.rstrip("s") for word in said}
        return max(fitting, key=lambda one: len(words & set(_words_of(one))) / len(one.split()), default=None)

    def _begun(self, said: Sequence[str]) -> set[str]:
        """The word classes of all phrases that some words begin with."""
        return {reading.word_class for _, reading in self._vocabulary.matches(said, 0)}


def _beside(lattice: Lattice, start: int, end: int) -> str:
    """What stands behind a part of a sentence, or else before it."""
    while end < len(lattice.pieces) and lattice.pieces[end].is_mark:
        end += 1
    behind = "" if lattice.ends[end] else lattice.text(end, len(lattice.pieces))
    return behind or lattice.text(0, start)


def begins_clause(lattice: Lattice, start: int) -> bool:
    """Whether only courtesies, a conjunction or a mark stand before a place."""
    joined = start > 0 and (lattice.pieces[start - 1].is_mark or lattice.ends_with(start, _JOINS))
    return joined or lattice.may_begin(start)


def _words_of(text: str) -> list[str]:
    return [word for word, _, _ in split_words(text)]
