"""A phrase of a sentence in one of its readings."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Word:
    """A phrase in one of its readings.

    Attributes:
        word_class: Terminal of the grammar.
        meaning: What it means there; for a number or a quotation, its text.
        start: Index of its first piece.
        end: Index after its last piece.
        said: Its text, lower-case.
    """

    word_class: str
    meaning: str
    start: int
    end: int
    said: str = ""
