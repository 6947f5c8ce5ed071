"""The words that are understood, with a look-up by phrase."""

from __future__ import annotations

import importlib.resources
import itertools
from collections import ChainMap
from collections.abc import Iterable, Iterator, Mapping, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

from executive.vocabulary.inflection import plural
from executive.vocabulary.label_phrases import head_of, label_phrases
from executive.vocabulary.word_lists import WordClass, read_classes
from robots.kept import kept
from robots.outside import VOCABULARY, outside_files

__all__ = ["Reading", "Vocabulary", "WordClass", "Words", "load_vocabulary"]

Words = tuple[str, ...]

_THINGS = ("KIND", "KINDS", "SUBSTANCE", "PAIR", "CONTAINER", "FURNITURE", "DOOR")
"""Word classes of things: what one is called, what several are called, and those with ways of their own."""
_FURNITURE = ("FURNITURE", "FURNITURES")
"""What one piece is called, and several."""


@dataclass(frozen=True, slots=True)
class Reading:
    """One way to read a phrase: its word class and what it means there."""

    word_class: str
    meaning: str


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

    def with_things(self, words: Sequence[str]) -> Vocabulary:
        """The same vocabulary, and further words for kinds of things.

        A word that is refused here is one of them from now on; one that is known as a thing stays what it is.
        A phrase of several words is one thing wherever it stands: "macaroni and cheese" is no list of two.
        Furniture is meant as it is called there: where a bedside table is, a nightstand is one, and where a
        wine rack is and no shelf, the rack is no shelf. A thing may be called by its colours in any order, by
        what it is packed in, and by its last word.

        Args:
            words: Noun phrases in lower case, each as one thing is called.
        """
        added: dict[str, list[str]] = {}
        instead: set[str] = set()
        called: dict[str, str] = {}
        for word in words:
            length, readings = self.match(word.split())
            known = length == len(word.split()) and any(
                one.word_class in _THINGS and self.refusal(one, word) is None for one in readings
            )
            if length == len(word.split()):
                called |= {one.meaning: word for one in readings if _is_otherwise_called(one, word)}
            if not known:
                many = word if word.endswith("s") and not word.endswith("ss") else plural(word)
                for phrase, word_class in ((word, _THINGS[0]), (many, _THINGS[1])):
                    added.setdefault(phrase.partition(" ")[0], []).append(_line(phrase, word_class, word))
        for phrase, word_class, meaning in self._said_of(words):
            added.setdefault(phrase.partition(" ")[0], []).append(_line(phrase, word_class, meaning))
            instead.add(phrase)
        firsts = {*added, *self._first_words_of(called)}
        beginnings = {first: self._also(first, added.get(first, ()), called, instead) for first in firsts}
        whole = (tuple(word.split()) for word in (*words, *instead) if " " in word)
        return Vocabulary(list(self._heads.values()), ChainMap(beginnings, dict(self._beginnings)), whole)

    def _said_of(self, labels: Sequence[str]) -> Iterator[tuple[str, str, str]]:
        """How else the things of a place are called there: phrase, word class and meaning."""
        colors = {phrase for phrases in self.classes["COLOR"].words.values() for phrase in phrases}
        taken = set(labels)
        for label in labels:
            for phrase in label_phrases(label, colors):
                if phrase not in taken:
                    taken.add(phrase)
                    yield phrase, _THINGS[0], label
        kinds = {head_of(label) or label for label in labels}
        for head in sorted(filter(None, map(head_of, labels))):
            _, readings = self.match([head])
            known = [one for one in readings if one.word_class in _THINGS and not self.refusal(one, head)]
            if head in taken or head in colors or (known and not _is_furniture_else(known, head, kinds)):
                continue
            taken.add(head)
            yield head, known[0].word_class if known else _THINGS[0], head

    def _first_words_of(self, furniture: Mapping[str, str]) -> Iterator[str]:
        """With what the phrases for some furniture begin."""
        if furniture:
            for name in _FURNITURE:
                for meaning, phrases in self.classes[name].words.items():
                    if meaning in furniture:
                        yield from (phrase.partition(" ")[0] for phrase in phrases)

    def _also(
        self, first: str, lines: Sequence[str], called: Mapping[str, str], instead: AbstractSet[str]
    ) -> str:
        """Phrases that begin with a word, with further ones, which take the place of what is refused.

        Args:
            first: The word.
            lines: The further ones.
            called: What furniture is called here, by what it is called elsewhere.
            instead: Phrases of which the further ones say what thing they mean, and nothing else does.
        """
        taken = {line.partition("\t")[0] for line in lines}
        stay = [
            _line(phrase, name, called.get(meaning, meaning) if name in _FURNITURE else meaning)
            for phrase, name, meaning in _cut(self._beginnings.get(first, ""))
            if phrase not in taken
            or (
                self.refusal(Reading(name, meaning), phrase) is None
                and not (phrase in instead and name in _THINGS)
            )
        ]
        return "\n".join([*stay, *lines])

    @cached_property
    def classes(self) -> Mapping[str, WordClass]:
        """The word classes by name."""
        words: dict[str, dict[str, list[str]]] = {name: {} for name in self._heads}
        for phrase, word_class, meaning in itertools.chain.from_iterable(
            map(_cut, self._beginnings.values())
        ):
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
        for phrase, word_class, meaning in _cut(self._beginnings.get(word, "")):
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


def _is_furniture_else(readings: Sequence[Reading], head: str, kinds: AbstractSet[str]) -> bool:
    """Whether a word is elsewhere said of furniture of which there is none here: "rack" of a shelf."""
    return all(one.word_class in _FURNITURE and one.meaning not in (head, *kinds) for one in readings)


def _is_otherwise_called(one: Reading, word: str) -> bool:
    """Whether furniture is called otherwise by it; "counter" of a kitchen counter is but shorter."""
    return one.word_class in _FURNITURE and one.meaning not in (word, word.rpartition(" ")[2])


def _line(phrase: str, word_class: str, meaning: str) -> str:
    return f"{phrase}\t{word_class}\t{meaning if meaning != phrase else ''}"


def _cut(lines: str) -> Iterator[tuple[str, str, str]]:
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
                line = _line(phrase, one.name, meaning)
                beginnings.setdefault(phrase.partition(" ")[0], {})[line] = None
    return heads, {first: "\n".join(lines) for first, lines in beginnings.items()}
