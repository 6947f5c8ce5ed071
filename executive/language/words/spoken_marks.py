"""Marks that are dictated: "bring the banana to Ana period"."""

from __future__ import annotations

from executive.vocabulary import Vocabulary
from executive.vocabulary.written import split_words

_SPOKEN = "SPOKEN_MARK"
_ENDS = (".", "!", "?")
_COPULAS = ("is", "are", "was", "were", "am")
"""Verbs before which an article belongs to something else: "the soup is ready period"."""
_FEWEST_WORDS = 3
"""Words before a mark that ends what is dictated: "say period" says it."""
_NAMED = frozenset({"KIND", "SUBSTANCE", "PAIR", "FURNITURE", "CONTAINER", "DOOR", "ROOM", "OWNER"})
"""Word classes of which the mark may be the second half: "it is lunch period"."""
_DETERMINE = frozenset({"DET", "ORDINAL", "OWNING", "OWNER", "AMOUNT", "THIS"})
_NOT_FAR = 3
"""So many words may stand between an article and its noun: "a very long dry period"."""


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


def without_last_mark(text: str, vocabulary: Vocabulary) -> tuple[str, bool] | None:
    """The text without a dictated mark that ends it, and whether that is sure to be no word of its own.

    "Dinner is ready period" ends with a mark; "it is the second period" and "it is lunch period" may not.
    None where no mark is spoken there.
    """
    said = list(split_words(text))
    words = [word for word, _, _ in said]
    while words and words[-1] in _ENDS:
        words.pop()
    lengths = (len(words) - index for index in range(_FEWEST_WORDS, len(words)))
    length = next((one for one in lengths if _is_mark(words, len(words) - one, one, vocabulary)), 0)
    if not length:
        return None
    last = len(words) - length
    before = words[max(last - _NOT_FAR - 1, 0) : last]
    said_of_it = max((index + 1 for index, word in enumerate(before) if word in _COPULAS), default=0)
    determined = any(
        not _classes_at(before, index, vocabulary).isdisjoint(_DETERMINE)
        for index in range(said_of_it, len(before))
    )
    classes = _classes_at(words, last - 1, vocabulary)
    is_sure = bool(classes) and classes.isdisjoint(_NAMED) and not determined
    return text[: said[last][1]].rstrip(), is_sure


def _is_mark(words: list[str], start: int, length: int, vocabulary: Vocabulary) -> bool:
    found = vocabulary.matches(words, start)
    return any(size == length and reading.word_class == _SPOKEN for size, reading in found)


def _classes_at(words: list[str], index: int, vocabulary: Vocabulary) -> set[str]:
    """What a single word may be."""
    return {reading.word_class for size, reading in vocabulary.matches(words, index) if size == 1}
