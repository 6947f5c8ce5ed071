"""The words of a place, known while somebody is spoken to there: what its things and people are called."""

from __future__ import annotations

from contextvars import ContextVar
from typing import NamedTuple


class PlaceWords(NamedTuple):
    """What is known of a place by its words.

    Attributes:
        things: Kinds, names and sorts of its things, in lower case, sorted.
        people: Names of its people as they are written, sorted.
    """

    things: tuple[str, ...] = ()
    people: tuple[str, ...] = ()


NOWHERE = PlaceWords()
WORDS: ContextVar[PlaceWords] = ContextVar("words of the place", default=NOWHERE)
"""Set by ``words_of_the_place`` alone."""


def place_words() -> PlaceWords:
    """The words of the place that is spoken of; none outside of ``words_of_the_place``."""
    return WORDS.get()
