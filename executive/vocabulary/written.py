"""Words and phrases as they are written: a text cut into words, a phrase with choices written out."""

from __future__ import annotations

import re
from collections.abc import Iterator

from executive.vocabulary.inflection import forms

_CHOICE = re.compile(r"\[([^\][()]*)\]|\(([^\][()]*)\)")
_WORD = re.compile(
    r"&&|\|\||\d+(?:st|nd|rd|th)\b|(?<!\d,)\d+,\d{1,2}(?![\d,])|\d+(?:\.\d+)?|[^\W\d_]+(?:\d+\b)?(?:'[^\W\d_]+)*(?:_[^\W\d_]+)*|[^\w\s]|\w"
)
MOST_VARIANTS = 100_000
"""Phrases that one phrase with choices may stand for."""


def split_words(text: str) -> Iterator[tuple[str, int, int]]:
    """The words, numbers and marks of a text, lower-case, each with its place."""
    for match in _WORD.finditer(text):
        whole, start = match.group(), match.start()
        lowered = whole.lower()
        if "_" in whole and lowered not in forms("bridge"):
            for part in re.finditer(r"[^_]+", whole):
                yield part.group().lower(), start + part.start(), start + part.end()
        elif whole in "-\u2013" and _inside_a_word(text, start):
            continue
        elif lowered[0].isdecimal():
            yield lowered.replace(",", "."), start, match.end()
        else:
            yield lowered, start, match.end()


def _inside_a_word(text: str, position: int) -> bool:
    before, after = text[position - 1 : position], text[position + 1 : position + 2]
    return before.isalpha() and after.isalpha()


def expand(phrase: str) -> Iterator[str]:
    """Write out ``[x|y]`` (one of them or nothing) and ``(x|y)`` (one of them)."""
    found = _CHOICE.search(phrase)
    if found is None:
        yield " ".join(word for word, _, _ in split_words(phrase))
        return
    optional, required = found.groups()
    choices = ["", *optional.split("|")] if optional is not None else required.split("|")
    for choice in choices:
        yield from expand(phrase[: found.start()] + choice + phrase[found.end() :])


def variants(phrase: str) -> float:
    """How many phrases ``expand`` writes out at least; infinite when no number holds it."""
    count = 1.0
    for optional, required in _CHOICE.findall(phrase):
        count *= required.count("|") + 1 if required else optional.count("|") + 2
    return count
