"""The words that are understood, with a look-up by phrase."""

from __future__ import annotations

import importlib.resources
import itertools
from collections import ChainMap
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any, NamedTuple

from executive.vocabulary.word_lists import WordClass, read_classes
from robots.kept import kept
from robots.outside import VOCABULARY, outside_files

__all__ = ["NOWHERE", "PlaceWords", "Reading", "Vocabulary", "WordClass", "Words", "load_vocabulary"]

Words = tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Reading:
    """One way to read a phrase: its word class and what it means there."""

    word_class: str
    meaning: str


class PlaceWords(NamedTuple):
    """What is known of a place by its words.

    Attributes:
        things, opening: Kinds, names and sorts of its things, in lower case, sorted; those that open.
        people: Names of its people as they are written, sorted.
    """

    things: tuple[str, ...] = ()
    people: tuple[str, ...] = ()
    opening: frozenset[str] = frozenset()


NOWHERE = PlaceWords()
_Beginning = tuple[tuple[int, ...], Mapping[Words, Sequence[Reading]]]


class Vocabulary:
    """Every word class, with a look-up by phrase.

    Args:
        heads: The word classes without phrases: name, refusal, readings of its meanings, whether derived.
        beginnings: For each first word of a phrase the phrases that begin with it, one a line: phrase, word
            class and meaning, with tabs between; no meaning where it is the phrase itself. The lines are
            cut up when the word is met: a process that parses one sentence meets few of them.
        whole: Phrases of several words that are one thing wherever they stand.
    """

    def __init__(
        self, heads: Sequence[Sequence[Any]], beginnings: Mapping[str, str], whole: Iterable[Words] = ()
    ) -> None:
        self._heads = {head[0]: head for head in heads}
        self._beginnings, self._whole = beginnings, frozenset(whole)
        self._readings: dict[str, _Beginning] = {}

    @classmethod
    def of(cls, classes: Sequence[WordClass]) -> Vocabulary:
        """The vocabulary of some word classes."""
        return cls(*_prepared(classes))

    def beginning_with(self, word: str) -> str:
        """The phrases that begin with a word, one a line, as they were given."""
        return self._beginnings.get(word, "")

    def with_beginnings(self, beginnings: Mapping[str, str], whole: Iterable[Words]) -> Vocabulary:
        """The same vocabulary with other phrases for some first words; see the class's arguments."""
        both = ChainMap(dict(beginnings), dict(self._beginnings))
        return Vocabulary(list(self._heads.values()), both, (*self._whole, *whole))

    def with_phrases(self, added: Mapping[str, Sequence[str]], whole: Iterable[Words]) -> Vocabulary:
        """The same vocabulary with further phrases by their first words; see the class's arguments."""
        beginnings = {
            first: "\n".join(filter(None, (self._beginnings.get(first), *lines)))
            for first, lines in added.items()
        }
        return self.with_beginnings(beginnings, whole)

    @cached_property
    def classes(self) -> Mapping[str, WordClass]:
        """The word classes by name."""
        words: dict[str, dict[str, list[str]]] = {name: {} for name in self._heads}
        for phrase, word_class, meaning in itertools.chain.from_iterable(map(cut, self._beginnings.values())):
            words[word_class].setdefault(meaning, []).append(phrase)
        return {
            name: WordClass(
                name, {one: tuple(sorted(phrases)) for one, phrases in sorted(words[name].items())},
                refusal, meanings, derived=derived,
            )
            for name, refusal, meanings, derived in self._heads.values()
        }  # fmt: skip

    def matches(self, words: Sequence[str], start: int) -> Iterator[tuple[int, Reading]]:
        """Every phrase that begins at ``start``: its length, and one reading of it."""
        lengths, readings = self._beginning_with(words[start])
        if self._whole:
            left = words[start:]
            whole = (n for n in lengths if n <= len(left) and tuple(left[:n]) in self._whole)
            lengths = (longest,) if (longest := max(whole, default=0)) else lengths
        for length in lengths:
            if start + length <= len(words):
                for reading in readings.get(tuple(words[start : start + length]), ()):
                    yield length, reading

    def _beginning_with(self, word: str) -> _Beginning:
        """The lengths of all phrases that begin with a word, and the readings of each."""
        found = self._readings.get(word)
        if found is not None:
            return found
        readings: dict[Words, list[Reading]] = {}
        for phrase, word_class, meaning in cut(self._beginnings.get(word, "")):
            readings.setdefault(tuple(phrase.split(" ")), []).append(Reading(word_class, meaning))
        found = tuple(dict.fromkeys(map(len, readings))), readings
        if readings:  # an unknown word is not kept: there is no end of them
            self._readings[word] = found
        return found

    def match(self, words: Sequence[str]) -> tuple[int, Sequence[Reading]]:
        """The longest phrase at the beginning of ``words``: its length and readings, or (0, ())."""
        found = list(self.matches(words, 0)) if words else []
        longest = max((length for length, _ in found), default=0)
        return longest, tuple(reading for length, reading in found if length == longest)

    @cached_property
    def single_words(self) -> frozenset[str]:
        """Every word that occurs in some phrase."""
        lines = itertools.chain.from_iterable(lines.split("\n") for lines in self._beginnings.values())
        return frozenset(word for line in lines for word in line.partition("\t")[0].split(" "))

    def refusal(self, reading: Reading, word: str) -> str | None:
        """Why a phrase in one of its readings is not acted on; None when the grammar uses its class."""
        _, refusal, meanings, _ = self._heads.get(reading.word_class, ("", None, {}, False))
        meaning = meanings.get(reading.meaning, reading.meaning)
        return None if refusal is None else refusal.format(word=word, meaning=meaning)


def line(phrase: str, word_class: str, meaning: str) -> str:
    """A phrase with its class and meaning, as a vocabulary keeps it."""
    return f"{phrase}\t{word_class}\t{meaning if meaning != phrase else ''}"


def cut(lines: str) -> Iterator[tuple[str, str, str]]:
    """The phrases of some lines, each with its word class and its meaning."""
    for line in lines.split("\n") if lines else ():
        phrase, word_class, meaning = line.split("\t")
        yield phrase, word_class, meaning or phrase


def load_vocabulary(user_files: Sequence[Path] = (), cache: Path | None = None) -> Vocabulary:
    """Read the word lists that travel with the package, those of other packages, and a user's own.

    Args:
        user_files: TOML files of the same form; their words are added to the classes of these names.
        cache: A folder where the classes are kept, written out, from one process to the next. None keeps
            nothing.

    Raises:
        VocabularyError: A list is malformed.
    """
    if cache is None:
        return Vocabulary.of(read_classes(user_files))
    rules = importlib.resources.files("executive.vocabulary").iterdir()
    made_by = [file for file in sorted(rules, key=str) if file.name.endswith((".py", ".toml"))]
    try:
        sources = [*(file.read_bytes() for file in (*made_by, *user_files)), b"brought"]
        for name, file in outside_files(VOCABULARY).items():
            sources.append(f"{name} ".encode() + file.read_bytes())
    except OSError:
        return Vocabulary.of(read_classes(user_files))
    return Vocabulary(*kept(cache, "vocabulary", sources, lambda: _prepared(read_classes(user_files))))


def _prepared(classes: Sequence[WordClass]) -> tuple[list[Sequence[Any]], dict[str, str]]:
    """What a vocabulary is made of, as plain JSON."""
    heads: list[Sequence[Any]] = [(one.name, one.refusal, dict(one.meanings), one.derived) for one in classes]
    beginnings: dict[str, dict[str, None]] = {}
    for one in classes:
        for meaning, phrases in one.words.items():
            for phrase in phrases:
                told = line(phrase, one.name, meaning)
                beginnings.setdefault(phrase.partition(" ")[0], {})[told] = None
    return heads, {first: "\n".join(lines) for first, lines in beginnings.items()}
