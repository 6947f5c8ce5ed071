"""From text to pieces: words, numbers, marks, quotations.

Everything is bounded: the length of the text, the number of its pieces, the characters in it.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator

from executive.language.text.word import Piece
from executive.vocabulary.inflection import forms
from executive.vocabulary.written import split_words

MAX_LENGTH = 500
"""Characters of one sentence: several times the longest that anybody says to a robot."""

MAX_PIECES = 90

_SPACES = "\t\n\r\u2028\u2029"
_INVISIBLE = frozenset({"Cc", "Cf", "Cs", "Co", "Cn", "Zl", "Zp"})
"""Unicode's categories of what steers, is not assigned, or ends a line unseen."""

_PLAIN = str.maketrans(
    {
        **dict.fromkeys("\u2018\u2019\u02bc\u00b4", "'"),
        **dict.fromkeys("\u201c\u201d\u201e\u00ab\u00bb", '"'),
        **dict.fromkeys("\u2013\u2014\u2022", "-"),
    }
)
_BRIDGE_LIKE = re.compile(r"(?<!\w)(?:move|turn)_\w+", re.IGNORECASE)
_QUOTATION = re.compile(r"\"([^\"]*)\"|(?<![\w'])'([^']*(?:'\w[^']*)*)'(?![\w'])")
_LINE_END = re.compile(r"(?<=[^\s.,;:!?-])[ \t\r]*\n\s*(?=[A-Z0-9])")
"""The end of a line without a mark, before one that begins as a sentence does."""

_AFTER_A_NUMBER = re.compile("(?<=[0-9])(?=[\u00bc-\u00be\u2150-\u215e])")
"""Where a sign for a fraction follows a number: "1½" is no eleven halves."""

_NO_ZERO = re.compile(r"(?<![\w.,\"'])\.(?=\d)")
"""Before the point of ".5"."""

_NOT = re.compile(r"(?<!\S)!(?=\w)")
"""A mark that denies what follows, as people write who program."""


class MalformedTextError(Exception):
    """A text that is no sentence at all; the message says why, ``word`` what caused it."""

    def __init__(self, message: str, word: str | None = None) -> None:
        self.message, self.word = message, word
        super().__init__(message)


def invisible_in(text: str, allowed: str = "") -> str | None:
    """The first character that nobody can see, and that may steer a terminal: "U+009B"; None without."""
    for character in text:
        if unicodedata.category(character) in _INVISIBLE and character not in allowed:
            return f"U+{ord(character):04X}"
    return None


def normalise(text: str) -> str:
    """Replace compatibility characters, trim white space; upper case stays.

    Raises:
        MalformedTextError: It is empty or too long, or holds characters that nobody can see.
    """
    if len(text) > MAX_LENGTH:
        raise MalformedTextError(f"the sentence has {len(text)} characters, at most {MAX_LENGTH} are read")
    code = invisible_in(text, _SPACES)
    if code is not None:
        raise MalformedTextError(f"the sentence holds the invisible character {code}", code)
    text = _LINE_END.sub(". ", text.strip())
    plain = " ".join(unicodedata.normalize("NFKC", _AFTER_A_NUMBER.sub(" ", text)).translate(_PLAIN).split())
    if not ({'"', "'"} & set(plain)):
        plain = _NO_ZERO.sub("0.", plain)
    if len(plain) > 1 and plain[0] == plain[-1] and plain[0] in "\"'" and plain.count(plain[0]) == 2:
        plain = plain[1:-1].strip()
    if _NOT.search(_QUOTATION.sub(" ", plain)):
        raise MalformedTextError("'!' before a word may deny it; say only what to do", "!")
    for word in _BRIDGE_LIKE.findall(_QUOTATION.sub(" ", plain)):
        if word.lower() not in forms("bridge"):
            told = f"{word!r} is no word of the bridge; those are {', '.join(forms('bridge'))}"
            raise MalformedTextError(told, word)
    if not plain:
        raise MalformedTextError("the sentence is empty")
    if len(plain) > MAX_LENGTH:
        raise MalformedTextError(f"the sentence has more than {MAX_LENGTH} characters")
    return plain


def pieces_of(plain: str) -> list[Piece]:
    """Split a normalised text; marks at its end are dropped.

    Raises:
        MalformedTextError: It has too many pieces.
    """
    pieces = list(_pieces(plain))
    while pieces and pieces[-1].is_mark:
        pieces.pop()
    if len(pieces) > MAX_PIECES:
        raise MalformedTextError(f"the sentence has {len(pieces)} words, at most {MAX_PIECES} are read")
    return pieces


def _pieces(plain: str) -> Iterator[Piece]:
    position = 0
    for quotation in _QUOTATION.finditer(plain):
        yield from _words(plain, position, quotation.start())
        yield Piece(quotation.group()[1:-1], quotation.start(), quotation.end(), quoted=True)
        position = quotation.end()
    yield from _words(plain, position, len(plain))


def _words(plain: str, start: int, end: int) -> Iterator[Piece]:
    for text, first, last in split_words(plain[start:end]):
        yield Piece(forms("typed").get(text, text), start + first, start + last)
