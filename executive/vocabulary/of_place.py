"""The vocabulary of a place: what its things and its people are called; a mere sentence needs none of it."""

from __future__ import annotations

from collections.abc import Sequence

from executive.vocabulary import PlaceWords, Vocabulary, line
from executive.vocabulary.with_things import with_things
from executive.vocabulary.written import split_words

_NAMES = ("NAME", "OWNER")
"""What a person is called, and what is theirs."""


def of_place(vocabulary: Vocabulary, place: PlaceWords) -> Vocabulary:
    """A vocabulary, and what the things and the people of a place are called.

    Args:
        vocabulary: What is known everywhere.
        place: The words of the place.
    """
    known = with_things(vocabulary, place.things, place.opening) if place.things else vocabulary
    return with_names(known, place.people) if place.people else known


def with_names(vocabulary: Vocabulary, names: Sequence[str]) -> Vocabulary:
    """A vocabulary with further names of people; a word that is one is what it was besides.

    Args:
        vocabulary: What is known already.
        names: As they are written: "Will", "Mary-Jane"; several words are one name.
    """
    added: dict[str, list[str]] = {}
    phrases = {name: tuple(word for word, _, _ in split_words(name)) for name in names}
    for name, words in phrases.items():
        length, readings = vocabulary.match(words)
        if length == len(words) and any(one.word_class == _NAMES[0] for one in readings):
            continue
        for ending, word_class in zip(("", "'s"), _NAMES, strict=True):
            first = words[0] if len(words) > 1 else words[0] + ending
            added.setdefault(first, []).append(line(" ".join(words) + ending, word_class, name))
    return vocabulary.with_phrases(added, (phrase for phrase in phrases.values() if len(phrase) > 1))
