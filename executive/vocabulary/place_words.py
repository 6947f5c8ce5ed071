"""The words of the place where something is said, known while it is said."""

from __future__ import annotations

from contextvars import ContextVar

from executive.vocabulary import NOWHERE, PlaceWords

WORDS: ContextVar[PlaceWords] = ContextVar("words of the place", default=NOWHERE)
"""Set by ``words_of_the_place`` alone."""


def place_words() -> PlaceWords:
    """The words of the place that is spoken of; none outside of ``words_of_the_place``."""
    return WORDS.get()
