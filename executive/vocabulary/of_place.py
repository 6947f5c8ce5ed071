"""A vocabulary with the words of a place: what its things and its people are called."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from executive.vocabulary import Reading, Vocabulary, line_of, phrases_in
from executive.vocabulary.inflection import plural
from executive.vocabulary.place_words import PlaceWords
from executive.vocabulary.written import split_words

_THINGS = ("KIND", "KINDS", "SUBSTANCE", "PAIR", "CONTAINER", "FURNITURE", "DOOR")
"""Word classes of things: what one is called, what several are called, and those with ways of their own."""
_FURNITURE = ("FURNITURE", "FURNITURES")
"""What one piece is called, and several."""
_NAME, _OWNER = "NAME", "OWNER"
"""What a person is called, and what is theirs."""


def vocabulary_of_place(known: Vocabulary, place: PlaceWords) -> Vocabulary:
    """A vocabulary, and what is known in a place alone.

    Args:
        known: What is known everywhere.
        place: What its things and its people are called.
    """
    with_things = _with_things(known, place.things) if place.things else known
    return _with_names(with_things, place.people) if place.people else with_things


def _with_names(known: Vocabulary, names: Sequence[str]) -> Vocabulary:
    """Further names of people, as they are written: "Will", "Mary-Jane"; several words are one name.

    A word that is a name here is besides what it is elsewhere.
    """
    added: dict[str, list[str]] = {}
    phrases = {name: tuple(word for word, _, _ in split_words(name)) for name in names}
    for name, words in phrases.items():
        length, readings = known.match(words)
        if length == len(words) and any(one.word_class == _NAME for one in readings):
            continue
        for ending, word_class in (("", _NAME), ("'s", _OWNER)):
            line = line_of(" ".join(words) + ending, word_class, name)
            added.setdefault(words[0] if len(words) > 1 else words[0] + ending, []).append(line)
    beginnings = {
        first: "\n".join(filter(None, (known.beginning_with(first), *lines)))
        for first, lines in added.items()
    }
    return known.with_phrases(beginnings, (phrase for phrase in phrases.values() if len(phrase) > 1))


def _with_things(known: Vocabulary, words: Sequence[str]) -> Vocabulary:
    """Further words for kinds of things: noun phrases in lower case, each as one thing is called.

    A word that is refused elsewhere is one of them from now on; one that is known as a thing stays so.
    A phrase of several words is one thing wherever it stands: "macaroni and cheese" is no list of two.
    Furniture is meant as it is called there: where a bedside table is, a nightstand is one.
    """
    added: dict[str, list[str]] = {}
    called: dict[str, str] = {}
    for word in words:
        length, readings = known.match(word.split())
        is_thing = length == len(word.split()) and any(
            one.word_class in _THINGS and known.refusal(one, word) is None for one in readings
        )
        if length == len(word.split()):
            called |= {one.meaning: word for one in readings if _is_otherwise_called(one, word)}
        if not is_thing:
            many = word if word.endswith("s") and not word.endswith("ss") else plural(word)
            for phrase, word_class in ((word, _THINGS[0]), (many, _THINGS[1])):
                added.setdefault(phrase.partition(" ")[0], []).append(line_of(phrase, word_class, word))
    firsts = {*added, *_first_words_of(known, called)}
    beginnings = {first: _also(known, first, added.get(first, ()), called) for first in firsts}
    return known.with_phrases(beginnings, (tuple(word.split()) for word in words if " " in word))


def _first_words_of(known: Vocabulary, furniture: Mapping[str, str]) -> Iterator[str]:
    """With what the phrases for some furniture begin."""
    if furniture:
        for name in _FURNITURE:
            for meaning, phrases in known.classes[name].words.items():
                if meaning in furniture:
                    yield from (phrase.partition(" ")[0] for phrase in phrases)


def _also(known: Vocabulary, first: str, lines: Sequence[str], called: Mapping[str, str]) -> str:
    """Phrases that begin with a word, with further ones, which take the place of what is refused.

    Args:
        known: The vocabulary.
        first: The word.
        lines: The further ones.
        called: What furniture is called here, by what it is called elsewhere.
    """
    taken = {line.partition("\t")[0] for line in lines}
    stay = [
        line_of(phrase, name, called.get(meaning, meaning) if name in _FURNITURE else meaning)
        for phrase, name, meaning in phrases_in(known.beginning_with(first))
        if phrase not in taken or known.refusal(Reading(name, meaning), phrase) is None
    ]
    return "\n".join([*stay, *lines])


def _is_otherwise_called(one: Reading, word: str) -> bool:
    """Whether furniture is called otherwise by it; "counter" of a kitchen counter is but shorter."""
    return one.word_class in _FURNITURE and one.meaning not in (word, word.rpartition(" ")[2])
