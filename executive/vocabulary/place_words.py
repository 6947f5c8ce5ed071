"""The words of a place: what its things are called, known while somebody is spoken to there."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar

_WORDS: ContextVar[tuple[str, ...]] = ContextVar("words of the place", default=())

_LONGEST = 8
"""Words of a name; a longer one is nothing that somebody says."""


@contextmanager
def words_of_the_place(labels: Iterable[str]) -> Iterator[None]:
    """Let what is said within be understood by some words for things, too.

    Args:
        labels: Kinds, names and sorts, in any case.
    """
    words = {" ".join(label.casefold().replace("-", " ").split()) for label in labels}
    token = _WORDS.set(tuple(sorted(word for word in words if 0 < len(word.split()) <= _LONGEST)))
    try:
        yield
    finally:
        _WORDS.reset(token)


def place_words() -> tuple[str, ...]:
    """The words of the place that is spoken of, sorted; none outside of ``words_of_the_place``."""
    return _WORDS.get()
