"""What a text is cut into, and what its phrases are read as."""

from __future__ import annotations

from dataclasses import dataclass

_MARKS = frozenset(".,;:!?")


@dataclass(frozen=True, slots=True)
class Piece:
    """One word, number, mark or quotation.

    Attributes:
        text: As it was said, lower-case.
        start: Where it begins in the normalised text.
        end: Where it ends.
        quoted: Whether it is a quotation, without its marks.
    """

    text: str
    start: int
    end: int
    quoted: bool = False

    @property
    def is_mark(self) -> bool:
        """Whether it is a punctuation mark."""
        return self.text in _MARKS

    @property
    def is_number(self) -> bool:
        """Whether it is written in digits."""
        return self.text[0].isdecimal() and self.text[-1].isdecimal()


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
