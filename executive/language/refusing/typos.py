"""Known words that an unknown one may have been meant to be: mistyped, not merely alike."""

from __future__ import annotations

import difflib
from collections.abc import Iterator, Mapping

from executive.vocabulary import Vocabulary

_LONGEST = 24
_TRIED = 8
"""Corrections that are tried."""

_SHORT = 4
"""Letters of a word in which one wrong letter already makes another word: "bath", "bat"."""


class Typos:
    """Finds known words that differ by a letter or two."""

    def __init__(self, vocabulary: Vocabulary) -> None:
        self._vocabulary = vocabulary
        self._left: dict[int, dict[str, list[str]]] = {}

    def corrections(self, word: str) -> Iterator[str]:
        """Known words that differ by a letter or two, nearest first; short ones by one, and begin alike."""
        if not 2 < len(word) <= _LONGEST or not word.isalpha():
            return
        near = [self._deletions(length) for length in range(len(word) - 1, len(word) + 2)]
        found = {one for key in _without_one(word) for left in near for one in left.get(key, ())}
        letters = sorted(word)
        ranked = sorted(
            (one for one in found if _is_likely(word, one)),
            key=lambda one: (
                -difflib.SequenceMatcher(None, word, one).ratio(),
                sorted(one) != letters,  # two letters that changed places
                one,
            ),
        )
        yield from ranked[:_TRIED]

    def _deletions(self, length: int) -> Mapping[str, list[str]]:
        """Known words of a length by what is left of them without one letter."""
        left = self._left.get(length)
        if left is None:
            left = self._left[length] = {}
            for word in self._vocabulary.single_words:
                if len(word) == length:
                    for key in _without_one(word):
                        left.setdefault(key, []).append(word)
        return left


def is_slip(word: str, known: str) -> bool:
    """Whether only the fingers can have made one word of another: "Annna", "Jhon", "Mchael".

    Letters that changed places, one that was typed twice, or one that is missing inside.
    """
    if sorted(word) == sorted(known):
        return True
    longer, shorter = (word, known) if len(word) > len(known) else (known, word)
    if len(longer) != len(shorter) + 1:
        return False
    left_out = [index for index in range(len(longer)) if longer[:index] + longer[index + 1 :] == shorter]
    if longer == word:
        return any(word[max(0, index - 1)] == word[index] and index for index in left_out)
    inside = any(0 < index < len(longer) - 1 for index in left_out)
    return inside and len(word) > _SHORT and longer[0] == shorter[0] and longer[-1] == shorter[-1]


def _is_likely(word: str, known: str) -> bool:
    """Whether a known word was mistyped, rather than another one that is not known: "oma" is not "mia"."""
    swapped = sorted(word) == sorted(known)
    if min(len(word), len(known)) > _SHORT or swapped:
        return True
    doubled = len(word) == len(known) + 1 and any(
        word[index] == word[index + 1] and word[:index] + word[index + 1 :] == known
        for index in range(len(word) - 1)
    )
    missing = len(known) == len(word) + 1 and word[0] == known[0]
    wrong = len(known) == len(word) and word[0] == known[0] and _differing(word, known) == 1
    return doubled or missing or wrong


def _differing(one: str, other: str) -> int:
    return sum(first != second for first, second in zip(one, other, strict=True))


def _without_one(word: str) -> set[str]:
    return {word, *(word[:index] + word[index + 1 :] for index in range(len(word)))}
