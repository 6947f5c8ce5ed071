"""Lets what is said be understood by what the things and the people of a place are called."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from collections.abc import Set as AbstractSet
from contextlib import contextmanager

from executive.vocabulary import PlaceWords
from executive.vocabulary.place_words import WORDS
from executive.vocabulary.written import split_words

_LONGEST = 8
"""Words of a name; a longer one is nothing that somebody says."""
_OPENS = ("door", "drawer")


@contextmanager
def words_of_the_place(labels: Iterable[str] | None, people: Iterable[str] = ()) -> Iterator[None]:
    """Let what is said within be understood by some words for things, and some names, too.

    Args:
        labels: Kinds, names and sorts, in any case; None: those that are known anyhow.
        people: What people are called.
    """
    known = WORDS.get()
    things = known.things
    if labels is not None:
        words = {" ".join(label.casefold().replace("-", " ").split()) for label in labels}
        things = tuple(
            sorted(word for word in words if 0 < len(word.split()) <= _LONGEST and not _is_part(word, words))
        )
    names = {" ".join(name.split()) for name in people}
    said = tuple(sorted(name for name in names if 0 < len(list(split_words(name))) <= _LONGEST))
    token = WORDS.set(PlaceWords(things, said))
    try:
        yield
    finally:
        WORDS.reset(token)


def _is_part(word: str, words: AbstractSet[str]) -> bool:
    """Whether a label tells what opens of another, "microwave door": people say that of anything."""
    of, _, part = word.rpartition(" ")
    return part in _OPENS and of in words
