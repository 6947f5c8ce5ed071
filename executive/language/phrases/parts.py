"""What a rule of the grammar is given: the parts of a phrase, words and what they have come to mean."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from executive.language.phrases.values import Meaning, Nominal
from executive.language.text.word import Word

Parts = tuple[Any, ...]


def words(parts: Iterable[Any], *classes: str) -> list[Word]:
    """The words of some classes among the parts."""
    return [part for part in parts if isinstance(part, Word) and part.word_class in classes]


def nominal_of(parts: Parts) -> Nominal | None:
    """The noun among the parts."""
    return next((part for part in reversed(parts) if isinstance(part, Nominal)), None)


def always(value: Any) -> Meaning:
    """The meaning of words that mean the same wherever they stand."""
    return lambda _parts: value


def senses(parts: Iterable[Any], *classes: str) -> set[str]:
    """Which of the meanings that some word classes tell apart is there, without the form of a verb."""
    return {word.meaning.partition(":")[0] for word in words(parts, *classes)}
