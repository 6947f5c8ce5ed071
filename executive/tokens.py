"""From text to words with their word classes.

Everything is bounded: the length of the text, and the characters that may occur in it.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Sequence
from dataclasses import dataclass

from executive.vocabulary import Reading, Vocabulary

MAX_LENGTH = 500
"""Characters of one sentence: several times the longest that anybody says to a robot."""

MAX_WORDS = 80

UNKNOWN = "UNKNOWN"
"""Word class of what is in no list."""

_WORD = re.compile(r"[\w]+(?:['\-][\w]+)*|[^\w\s]")
_PAUSE = frozenset(".,;:!?")
_QUOTES = str.maketrans({"\u2018": "'", "\u2019": "'", "\u02bc": "'", "\u00b4": "'", "`": "'"})


@dataclass(frozen=True, slots=True)
class Word:
    """One word or phrase of the vocabulary, or an unknown word.

    Attributes:
        text: As it was said, lower-case.
        readings: What it may be; a single one of class UNKNOWN when it is in no list.
        start, end: Its place in the normalised text.
    """

    text: str
    readings: tuple[Reading, ...]
    start: int
    end: int


class MalformedTextError(Exception):
    """A text that is no sentence at all; the message says why, ``word`` what caused it."""

    def __init__(self, message: str, word: str | None = None) -> None:
        self.message, self.word = message, word
        super().__init__(message)


def normalise(text: str) -> str:
    """Lower-case, compatibility characters replaced, white space trimmed.

    Raises:
        MalformedTextError: It is empty or too long, or holds characters that nobody can see.
    """
    if len(text) > MAX_LENGTH:
        raise MalformedTextError(f"the sentence has {len(text)} characters, at most {MAX_LENGTH} are read")
    for character in text:
        if unicodedata.category(character) in ("Cc", "Cf", "Cs", "Co", "Cn") and character not in "\t\n\r":
            code = f"U+{ord(character):04X}"
            raise MalformedTextError(f"the sentence holds the invisible character {code}", code)
    plain = " ".join(unicodedata.normalize("NFKC", text).translate(_QUOTES).lower().split())
    if not plain:
        raise MalformedTextError("the sentence is empty")
    if len(plain) > MAX_LENGTH:
        raise MalformedTextError(f"the sentence has more than {MAX_LENGTH} characters")
    return plain


def words_of(plain: str, vocabulary: Vocabulary) -> list[Word]:
    """Split a normalised text into the longest known phrases; fillers go, pauses become separators.

    Raises:
        MalformedTextError: It has too many words.
    """
    pieces = [(match.group(), match.start(), match.end()) for match in _WORD.finditer(plain)]
    pieces = [part for piece in pieces for part in _split_hyphens(piece, vocabulary)]
    if len(pieces) > MAX_WORDS:
        raise MalformedTextError(f"the sentence has {len(pieces)} words, at most {MAX_WORDS} are read")
    words: list[Word] = []
    position = 0
    while position < len(pieces):
        text, start, end = pieces[position]
        length, readings = vocabulary.match([piece[0] for piece in pieces[position:]])
        if length:
            end = pieces[position + length - 1][2]
            words.append(Word(plain[start:end], tuple(readings), start, end))
        elif text in _PAUSE:
            words.append(Word(text, (Reading("SEP", "pause"),), start, end))
        elif text[0].isdigit():
            words.append(Word(text, (Reading("NUMBER", "number"),), start, end))
        else:
            words.append(Word(text, (Reading(UNKNOWN, text),), start, end))
        position += max(length, 1)
    return _without_pauses(words)


def _split_hyphens(piece: tuple[str, int, int], vocabulary: Vocabulary) -> list[tuple[str, int, int]]:
    text, start, _ = piece
    if "-" not in text or vocabulary.match([text])[0] or len(text) == 1:
        return [piece]
    return [(part.group(), start + part.start(), start + part.end()) for part in re.finditer(r"[^-]+", text)]


def _without_pauses(words: Sequence[Word]) -> list[Word]:
    """Drop fillers, and pauses where a spoken separator or nothing is next to them."""
    kept: list[Word] = []
    for word in words:
        if any(reading.word_class == "FILLER" for reading in word.readings):
            continue
        is_pause = _is_pause(word)
        after_courtesy = bool(kept) and all(item.word_class == "OPENING" for item in kept[-1].readings[:1])
        if is_pause and (not kept or _separates(kept[-1]) or after_courtesy):
            continue
        if _separates(word) and kept and _is_pause(kept[-1]):
            kept.pop()
        kept.append(word)
    while kept and _is_pause(kept[-1]):
        kept.pop()
    return kept


def _is_pause(word: Word) -> bool:
    return word.readings[0].meaning == "pause"


def _separates(word: Word) -> bool:
    return any(reading.word_class == "SEP" for reading in word.readings)
