"""Known words that an unknown one may have been meant to be: mistyped, not merely alike."""

from __future__ import annotations

import difflib
import string
from collections.abc import Iterable, Sequence

from executive.vocabulary import Vocabulary

_LONGEST = 24
_TRIED = 8
"""Corrections that are tried."""

_SHORT = 4
"""Letters of a word in which one wrong letter already makes another word: "bath", "bat"."""

_TINY = 2
_LONG = 6
"""Letters from which a word may differ by two: "refridgerater"."""

_ALIKE = 0.8
"""More than that it has in common then: "thickest" is not "thinnest"."""

_LETTERS = f"{string.ascii_lowercase}_"
"""What a known word may be made of; "move_forward" is one."""


class Typos:
    """Finds known words that differ by a letter or two."""

    def __init__(self, vocabulary: Vocabulary) -> None:
        self._vocabulary = vocabulary
        self._beginning: dict[str, list[str]] = {}

    def corrections(self, word: str) -> list[str]:
        """Known words that differ by a letter, or in its place, nearest first; short ones begin alike.

        What is known as a part of a phrase has two letters in the wrong order at most ("form"), or lacks one
        where it is short: "blu".
        """
        known = self._vocabulary.single_words
        if not _TINY < len(word) <= _LONGEST or not word.isalpha():
            return []
        if word in known:
            lacking = _one_more(word) if len(word) < _SHORT else set()
            return _ranked(word, (one for one in _swapped(word) | lacking if one in known))
        return _ranked(word, (one for one in _one_edit_away(word) if one in known and _is_likely(word, one)))

    def near(self, word: str) -> list[str]:
        """The same, or, for a long word without any, known words that differ by two letters."""
        found = self.corrections(word) if len(word) > _TINY else self._small(word)
        unknown = word.isalpha() and word not in self._vocabulary.single_words
        if found or not _LONG <= len(word) <= _LONGEST or not unknown:
            return found
        letters = set(word)
        alike = (
            one
            for one in self._beginning_like(word)
            if abs(len(one) - len(word)) <= 1 and len(letters ^ set(one)) <= 2 * 2
        )
        return _ranked(
            word, (one for one in alike if _is_within_two(word, one) and _ratio(word, one) > _ALIKE)
        )

    def _small(self, word: str) -> list[str]:
        """Known words of which one letter is missing in a word of two, or that has them the wrong way."""
        if len(word) != _TINY or not word.isalpha():
            return []
        known = self._vocabulary.single_words
        return _ranked(word, (one for one in {word[::-1]} | _one_more(word) if one in known))

    def _beginning_like(self, word: str) -> Sequence[str]:
        """Known words with the same first letter."""
        if not self._beginning:
            for one in self._vocabulary.single_words:
                if len(one) >= _LONG - 1:
                    self._beginning.setdefault(one[0], []).append(one)
        return self._beginning.get(word[0], ())


def _ratio(word: str, known: str) -> float:
    """How much two words have in common, up to 1."""
    return difflib.SequenceMatcher(None, word, known).ratio()


def _ranked(word: str, found: Iterable[str]) -> list[str]:
    """Known words, nearest first: letters that changed places, or one that is missing of two, come first."""
    letters = sorted(word)
    return sorted(
        found,
        key=lambda one: (
            sorted(one) != letters,
            not _is_doubled(one, word),
            -_ratio(word, one),
            one,
        ),
    )[:_TRIED]


def _one_more(word: str) -> set[str]:
    """What a word is with one more letter behind its first."""
    places = range(1, len(word) + 1)
    return {f"{word[:place]}{letter}{word[place:]}" for place in places for letter in _LETTERS}


def _swapped(word: str) -> set[str]:
    """What a word is with two neighbours in each other's place."""
    pairs = (
        (word[:index], word[index], word[index + 1], word[index + 2 :]) for index in range(len(word) - 1)
    )
    return {f"{left}{after}{before}{right}" for left, before, after, right in pairs} - {word}


def _one_edit_away(word: str) -> set[str]:
    """What a word is with one letter less, more or otherwise, or with one or two in another place."""
    cuts = [(word[:index], word[index:]) for index in range(len(word) + 1)]
    less = {left + right[1:] for left, right in cuts if right}
    more = {f"{left}{letter}{right}" for left, right in cuts for letter in _LETTERS}
    wrong = {f"{left}{letter}{right[1:]}" for left, right in cuts if right for letter in _LETTERS}
    moved = {
        rest[:index] + right[0] + rest[index:]
        for left, right in cuts
        if right
        for rest in [left + right[1:]]
        for index in range(len(rest) + 1)
    }
    return (less | more | wrong | moved) - {word}


def _is_within_two(word: str, known: str) -> bool:
    """Whether two words differ by two letters at most; two neighbours that changed places are one."""
    rows = [list(range(len(known) + 1))]
    for index, letter in enumerate(word, 1):
        last, row = rows[-1], [index]
        for place, other in enumerate(known, 1):
            cost = min(last[place] + 1, row[-1] + 1, last[place - 1] + (letter != other))
            swapped = index > 1 and place > 1 and (letter, other) == (known[place - 2], word[index - 2])
            row.append(min(cost, rows[-2][place - 2] + 1) if swapped else cost)
        if min(row) > 2:
            return False
        rows.append(row)
    return rows[-1][-1] <= 2


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
    missing = len(known) == len(word) + 1 and word[0] == known[0]
    wrong = len(known) == len(word) and word[0] == known[0] and _differing(word, known) == 1
    more = len(word) == len(known) + 1 > _SHORT and (word[0], word[-1]) == (known[0], known[-1])
    return _is_doubled(word, known) or missing or wrong or more


def _is_doubled(longer: str, shorter: str) -> bool:
    """Whether one letter of a word stands twice in another."""
    return len(longer) == len(shorter) + 1 and any(
        longer[index] == longer[index + 1] and longer[:index] + longer[index + 1 :] == shorter
        for index in range(len(longer) - 1)
    )


def _differing(one: str, other: str) -> int:
    return sum(first != second for first, second in zip(one, other, strict=True))
