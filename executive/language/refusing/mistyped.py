"""Which sentence was meant by one with mistyped words: "grap the red bxo" is "grab the red box".

Nothing is done of it; it is only offered. Every unknown word must have a known one near it, and all of them
together must make a sentence, or one that is asked about; another language is not mended.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from executive.language.refusing.typos import Typos, is_slip
from executive.language.words.piece import Piece

MAX_UNKNOWN = 8
"""Unknown words, each counted once."""

MAX_WORDS = 40
MAX_TRIED = 12
MAX_TRIED_LONG = 6
"""Sentences that are tried, fewer of a long one, so that no text takes long."""

_LONG = 15
_EACH = 5
"""Known words that are tried for each of several unknown ones."""


@dataclass(frozen=True, slots=True)
class Mended:
    """What may have been meant.

    Attributes:
        word: What the first unknown word may have been meant to be.
        sentence: The whole sentence with known words.
        is_valid: Whether it makes tasks.
    """

    word: str
    sentence: str
    is_valid: bool


class Mender:
    """Finds the sentence that was meant.

    Args:
        typos: Known words near an unknown one.
        is_fit: Whether a known word may be meant by an unknown one.
        is_valid: Whether a sentence makes tasks.
        is_asked: Whether a sentence is understood but for something that is asked.
    """

    def __init__(
        self,
        typos: Typos,
        is_fit: Callable[[str, str], bool],
        is_valid: Callable[[str], bool],
        is_asked: Callable[[str], bool],
    ) -> None:
        self._typos, self._is_fit = typos, is_fit
        self._is_valid, self._is_asked = is_valid, is_asked

    def mended(self, plain: str, pieces: Sequence[Piece], unknown: Sequence[Piece]) -> Mended | None:
        """What a sentence with unknown words was meant to be, if that can be told.

        Args:
            plain: The sentence.
            pieces: All of its pieces.
            unknown: Those that are not known.
        """
        texts = dict.fromkeys(piece.text for piece in unknown)
        if len(texts) > MAX_UNKNOWN or len(pieces) > MAX_WORDS:
            return None
        near = {text: self._near(text)[: _EACH if len(texts) > 1 else None] for text in texts}
        if not all(near.values()):
            return None
        most = MAX_TRIED_LONG if len(pieces) > _LONG else MAX_TRIED
        meant = (dict(zip(near, words, strict=True)) for words in _likeliest_first(list(near.values())))
        for words in itertools.islice(meant, most):
            sentence = _with(words, plain, unknown)
            if self._is_valid(sentence):
                return Mended(words[unknown[0].text], sentence, is_valid=True)
        first = {text: words[0] for text, words in near.items()}
        sentence = _with(first, plain, unknown)
        slipped = len(near) > 1 or all(is_slip(text, word) for text, word in first.items())
        if not slipped or not self._is_asked(sentence):
            return None
        return Mended(first[unknown[0].text], sentence, is_valid=False)

    def _near(self, text: str) -> list[str]:
        return [one for one in self._typos.near(text) if self._is_fit(text, one)]


def _likeliest_first(choices: Sequence[Sequence[str]]) -> Iterator[tuple[str, ...]]:
    """One of each, those first that are nearest on the whole."""
    sizes = [len(one) for one in choices]
    for total in range(sum(sizes) - len(sizes) + 1):
        for places in _places(sizes, total):
            yield tuple(one[place] for one, place in zip(choices, places, strict=True))


def _places(sizes: Sequence[int], total: int) -> Iterator[tuple[int, ...]]:
    """One place below each size, so that they add up to a total."""
    if not sizes:
        yield from [()] if total == 0 else ()
        return
    for first in range(min(sizes[0] - 1, total) + 1):
        for others in _places(sizes[1:], total - first):
            yield (first, *others)


def _with(words: Mapping[str, str], plain: str, unknown: Sequence[Piece]) -> str:
    """A sentence with known words in the place of unknown ones."""
    for piece in reversed(unknown):
        plain = plain[: piece.start] + words[piece.text] + plain[piece.end :]
    return plain
