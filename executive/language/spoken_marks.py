"""Marks that are dictated: "bring the banana to Ana period"."""

from __future__ import annotations

from executive.vocabulary import Vocabulary
from executive.vocabulary.written import split_words

_SPOKEN = "SPOKEN_MARK"


def with_spoken_marks(text: str, vocabulary: Vocabulary) -> str | None:
    """The text with its dictated marks written; None where it has none. What stands first is a word."""
    said = list(split_words(text))
    words = [word for word, _, _ in said]
    written, end, index = "", 0, 1
    while index < len(said):
        marks = (one for one in vocabulary.matches(words, index) if one[1].word_class == _SPOKEN)
        length, mark = next(((length, reading.meaning) for length, reading in marks), (1, ""))
        if mark:
            written += text[end : said[index][1]].rstrip() + mark
            end = said[index + length - 1][2]
        index += length
    return written + text[end:] if end else None
