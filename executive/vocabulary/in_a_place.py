"""Lets what is said be understood by what the things and the people of a place are called."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import contextmanager

from executive.vocabulary import PlaceWords
from executive.vocabulary.place_words import WORDS
from executive.vocabulary.written import split_words

_LONGEST = 8
"""Words of a name; a longer one is nothing that somebody says."""


@contextmanager
def words_of_the_place(
    labels: Iterable[str] | None, people: Iterable[str] = (), fronts: Iterable[str] = ()
) -> Iterator[None]:
    """Let what is said within be understood by some words for things, and some names, too.

    Args:
        labels: Kinds, names and sorts, in any case; None: those that are known anyhow.
        people: What people are called.
        fronts: Doors and drawers by the piece that they are of: "microwave door". Such a piece can be opened.
    """
    known = WORDS.get()
    things = known.things
    if labels is not None:
        words = {" ".join(label.casefold().replace("-", " ").split()) for label in labels}
        things = tuple(sorted(word for word in words if 0 < len(word.split()) <= _LONGEST))
    names = {" ".join(name.split()) for name in people}
    said = tuple(sorted(name for name in names if 0 < len(list(split_words(name))) <= _LONGEST))
    opening = frozenset(" ".join(front.casefold().split()).rpartition(" ")[0] for front in fronts)
    token = WORDS.set(PlaceWords(things, said, opening & frozenset(things)))
    try:
        yield
    finally:
        WORDS.reset(token)
