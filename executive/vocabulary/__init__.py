"""The words that are understood, read from the TOML files beside this one.

A file holds tables; a table is a word class: a terminal of the grammar, or, with ``refusal``, words
that are understood but never acted on. ``words`` maps a meaning to the phrases that carry it. In a
phrase ``[x|y]`` may be left out, ``(x|y)`` is one of several.
"""

from __future__ import annotations

import importlib.resources
import itertools
import re
import tomllib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property

from executive.errors import VocabularyError

Words = tuple[str, ...]

_CHOICE = re.compile(r"\[([^\][()]*)\]|\(([^\][()]*)\)")


@dataclass(frozen=True, slots=True)
class Reading:
    """One way to read a phrase: its word class and what it means there."""

    word_class: str
    meaning: str


@dataclass(frozen=True, slots=True)
class WordClass:
    """One class of words.

    Attributes:
        name: Terminal of the grammar.
        words: Phrases by meaning, written out.
        refusal: Why none of them is acted on, as a format of ``word`` and ``meaning``; None when the
            grammar uses them.
        meanings: What ``meaning`` reads like in ``refusal``.
        misplaced: What to say, in the same form, where the grammar has no place for one of them.
    """

    name: str
    words: Mapping[str, tuple[str, ...]]
    refusal: str | None = None
    meanings: Mapping[str, str] = field(default_factory=dict)
    misplaced: str | None = None


class Vocabulary:
    """Every word class, with a look-up by phrase."""

    def __init__(self, classes: Sequence[WordClass]) -> None:
        self.classes = {word_class.name: word_class for word_class in classes}
        self._readings: dict[Words, list[Reading]] = {}
        for word_class in classes:
            for meaning, phrases in word_class.words.items():
                for phrase in phrases:
                    readings = self._readings.setdefault(tuple(phrase.split()), [])
                    reading = Reading(word_class.name, meaning)
                    if reading not in readings:
                        readings.append(reading)
        self._longest = max(map(len, self._readings), default=0)

    def match(self, words: Sequence[str]) -> tuple[int, Sequence[Reading]]:
        """Find the longest phrase at the beginning of ``words``: its length and readings, or (0, ())."""
        for length in range(min(self._longest, len(words)), 0, -1):
            readings = self._readings.get(tuple(words[:length]))
            if readings:
                return length, readings
        return 0, ()

    @cached_property
    def single_words(self) -> frozenset[str]:
        """Every word that occurs in some phrase."""
        return frozenset(itertools.chain.from_iterable(self._readings))

    def phrases(self, class_name: str) -> list[str]:
        """Every phrase of a class, sorted."""
        return sorted(itertools.chain.from_iterable(self.classes[class_name].words.values()))

    def refusal(self, reading: Reading, word: str) -> str | None:
        """Why a phrase that found no place in the grammar is not acted on.

        None when nothing special is known about its class.
        """
        word_class = self.classes[reading.word_class]
        message = word_class.refusal or word_class.misplaced
        if message is None:
            return None
        meaning = word_class.meanings.get(reading.meaning, reading.meaning)
        return message.format(word=word, meaning=meaning)


def load_vocabulary() -> Vocabulary:
    """Read the word lists that travel with the package.

    Raises:
        VocabularyError: A list is malformed.
    """
    folder = importlib.resources.files("executive.vocabulary")
    files = {item.name: item for item in folder.iterdir() if item.name.endswith(".toml")}
    classes: list[WordClass] = []
    for file_name, file in sorted(files.items()):
        for name, table in tomllib.loads(file.read_text("utf-8")).items():
            unknown = set(table) - {"words", "refusal", "meaning", "misplaced"}
            if unknown or "words" not in table:
                raise VocabularyError(f"{file_name}: {name}: needs words, and knows no {sorted(unknown)}")
            classes.append(
                WordClass(
                    name=name,
                    words={
                        meaning: tuple(itertools.chain.from_iterable(map(expand, phrases)))
                        for meaning, phrases in table["words"].items()
                    },
                    refusal=table.get("refusal"),
                    meanings=table.get("meaning", {}),
                    misplaced=table.get("misplaced"),
                )
            )
    return Vocabulary(classes)


def expand(phrase: str) -> Iterator[str]:
    """Write out ``[x|y]`` (one of them or nothing) and ``(x|y)`` (one of them)."""
    found = _CHOICE.search(phrase)
    if found is None:
        yield " ".join(phrase.split())
        return
    optional, required = found.groups()
    choices = ["", *optional.split("|")] if optional is not None else required.split("|")
    for choice in choices:
        yield from expand(phrase[: found.start()] + choice + phrase[found.end() :])
