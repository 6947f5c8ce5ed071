"""The words of a place, known while somebody is spoken to there: what its things and people are called."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from typing import NamedTuple

from executive.vocabulary.written import split_words


class PlaceWords(NamedTuple):
    """What is known of a place by its words.

    Attributes:
        things: Kinds, names and sorts of its things, in lower case, sorted.
        people: Names of its people as they are written, sorted.
    """

    things: tuple[str, ...] = ()
    people: tuple[str, ...] = ()


NOWHERE = PlaceWords()
_WORDS: ContextVar[PlaceWords] = ContextVar("words of the place", default=NOWHERE)

_LONGEST = 8
"""Words of a name; a longer one is nothing that somebody says."""


@contextmanager
def words_of_the_place(labels: Iterable[str] | None, people: Iterable[str] = ()) -> Iterator[None]:
    """Let what is said within be understood by some words for things, and some names, too.

    Args:
        labels: Kinds, names and sorts, in any case; None: those that are known anyhow.
        people: What people are called.
    """
    known = place_words()
    things = known.things
    if labels is not None:
        words = {" ".join(label.casefold().replace("-", " ").split()) for label in labels}
        things = tuple(sorted(word for word in words if 0 < len(word.split()) <= _LONGEST))
    names = {" ".join(name.split()) for name in people}
    said = tuple(sorted(name for name in names if 0 < len(list(split_words(name))) <= _LONGEST))
    token = _WORDS.set(PlaceWords(things, said))
    try:
        yield
    finally:
        _WORDS.reset(token)


def place_words() -> PlaceWords:
    """The words of the place that is spoken of; none outside of ``words_of_the_place``."""
    return _WORDS.get()
