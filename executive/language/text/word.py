"""What a text is cut into, and what its phrases are read as."""

from __future__ import annotations

from dataclasses import dataclass

_MARKS = frozenset(".,;:!?")


@dataclass(frozen=True, slots=True)
class Piece:
    """One word, number, mark or quotation (without its marks), in lower case, and where in the text it is."""

    text: str
    start: int
    end: int
    quoted: bool = False

    @property
    def is_mark(self) -> bool:
        """Whether it is a punctuation mark."""
        return not self.quoted and self.text in _MARKS

    @property
    def is_number(self) -> bool:
        """Whether it is written in digits."""
        return self.text[0].isdecimal() and self.text[-1].isdecimal()


@dataclass(frozen=True, slots=True)
class Word:
    """A phrase in one of its readings: a terminal of the grammar, and what it means there.

    The meaning of a number or a quotation is its text. ``start`` and ``end`` are indices of pieces, the
    end behind the last; ``said`` is what was said, in lower case.
    """

    word_class: str
    meaning: str
    start: int
    end: int
    said: str = ""
