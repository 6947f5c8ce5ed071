"""Known words that an unknown one may have been meant to be: mistyped, not merely alike."""

from __future__ import annotations

import difflib
import string
from collections.abc import Iterator
from collections.abc import Set as AbstractSet

SHORTEST, LONGEST = 3, 24
"""Letters of a word that is looked at; one of three may only lack a letter, else it is another word."""


def meant_by(word: str, known: AbstractSet[str]) -> list[str]:
    """Known words that differ by one letter, or by two neighbours in each other's place, nearest first.

    Args:
        word: An unknown word in small letters.
        known: Every known word.
    """
    if not SHORTEST <= len(word) <= LONGEST or not word.isalpha() or word in known:
        return []
    found = {
        one for one in _one_edit_away(word) if one in known and (len(one) > SHORTEST or len(word) > SHORTEST)
    }
    alike = {one: difflib.SequenceMatcher(None, word, one).ratio() for one in found}
    return sorted(found, key=lambda one: (sorted(one) != sorted(word), -alike[one], one))


def is_slip(word: str, known: str) -> bool:
    """Whether letters changed places, or one is missing or too many: "Jhon", "Annna", but not "Theodora"."""
    return sorted(word) == sorted(known) or len(word) != len(known)


def _one_edit_away(word: str) -> Iterator[str]:
    """What a word is with one letter less, more or otherwise, or with two neighbours changed."""
    letters = f"{string.ascii_lowercase}_"  # "move_forward" is a known word
    for at in range(len(word) + 1):
        left, right = word[:at], word[at:]
        yield from (f"{left}{letter}{right}" for letter in letters)
        if right:
            yield left + right[1:]
            yield from (f"{left}{letter}{right[1:]}" for letter in letters)
        if len(right) > 1:
            yield f"{left}{right[1]}{right[0]}{right[2:]}"
