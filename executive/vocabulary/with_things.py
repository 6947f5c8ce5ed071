"""The vocabulary of a place: what the things that are there are called."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from collections.abc import Set as AbstractSet

from executive.vocabulary import Reading, Vocabulary, cut, line
from executive.vocabulary.inflection import plural
from executive.vocabulary.label_phrases import head_of, label_phrases

_FURNITURE = ("FURNITURE", "FURNITURES", "CONTAINER", "CONTAINERS")
"""What one piece is called, and several, also where it has an inside."""
_THINGS = ("KIND", "KINDS", "SUBSTANCE", "PAIR", "DOOR", *_FURNITURE)
"""Word classes of things: what one is called, what several are called, and those with ways of their own."""
_OPENS = ("CONTAINER", "CONTAINERS")
"""The same of what can be opened."""
_SEVERAL = {"FURNITURE": "FURNITURES", "CONTAINER": "CONTAINERS", "KIND": "KINDS"}
"""The class of what several are called, by that of one."""


def with_things(
    vocabulary: Vocabulary, words: Sequence[str], opening: AbstractSet[str] = frozenset()
) -> Vocabulary:
    """A vocabulary with further words for kinds of things.

    A word that is refused here is one of them from now on; one that is known as a thing stays what it is.
    A phrase of several words is one thing wherever it stands: "macaroni and cheese" is no list of two.
    Furniture is meant as it is called there: where a bedside table is, a nightstand is one, and where a
    wine rack is and no shelf, the rack is no shelf. A thing may be called by its colours in any order, by
    what it is packed in, and by its last word.

    Args:
        vocabulary: What is known everywhere.
        words: Noun phrases in lower case, each as one thing is called.
        opening: Those of the words that mean what can be opened, whatever they mean elsewhere.
    """
    added: dict[str, list[str]] = {}
    instead: set[str] = set()
    called: dict[str, str] = {}
    for word in words:
        length, readings = vocabulary.match(word.split())
        classes = _OPENS if word in opening else _THINGS
        known = length == len(word.split()) and any(
            one.word_class in classes and vocabulary.refusal(one, word) is None for one in readings
        )
        if length == len(word.split()):
            called |= {one.meaning: word for one in readings if _is_otherwise_called(one, word)}
        if not known:
            many = word if word.endswith("s") and not word.endswith("ss") else plural(word)
            instead.update((word, many) if word in opening else ())
            for phrase, word_class in zip((word, many), classes, strict=False):
                added.setdefault(phrase.partition(" ")[0], []).append(line(phrase, word_class, word))
    for phrase, word_class, meaning in _said_of(vocabulary, words, opening | set(map(head_of, opening))):
        added.setdefault(phrase.partition(" ")[0], []).append(line(phrase, word_class, meaning))
        instead.add(phrase)
    firsts = {*added, *_first_words_of(vocabulary, called)}
    beginnings = {first: _also(vocabulary, first, added.get(first, ()), called, instead) for first in firsts}
    whole = (tuple(word.split()) for word in (*words, *instead) if " " in word)
    return vocabulary.with_beginnings(beginnings, whole)


def _said_of(
    vocabulary: Vocabulary, labels: Sequence[str], opening: AbstractSet[str | None]
) -> Iterator[tuple[str, str, str]]:
    """How else the things of a place are called there: phrase, word class and meaning."""
    colors = {phrase for phrases in vocabulary.classes["COLOR"].words.values() for phrase in phrases}
    taken = set(labels)
    for label in labels:
        for phrase in label_phrases(label, colors):
            if phrase not in taken:
                taken.add(phrase)
                yield phrase, (_OPENS if label in opening else _THINGS)[0], label
    kinds = {head_of(label) or label for label in labels}
    for head in sorted(filter(None, map(head_of, labels))):
        _, readings = vocabulary.match([head])
        known = [one for one in readings if one.word_class in _THINGS and not vocabulary.refusal(one, head)]
        if head in taken or head in colors or (known and not _is_furniture_else(known, head, kinds)):
            continue
        taken.add(head)
        word_class = known[0].word_class if known else (_OPENS if head in opening else _THINGS)[0]
        yield head, word_class, head
        if word_class in _SEVERAL and plural(head) not in taken:
            yield plural(head), _SEVERAL[word_class], head


def _first_words_of(vocabulary: Vocabulary, furniture: Mapping[str, str]) -> Iterator[str]:
    """With what the phrases for some furniture begin."""
    if furniture:
        for name in _FURNITURE:
            for meaning, phrases in vocabulary.classes[name].words.items():
                if meaning in furniture:
                    yield from (phrase.partition(" ")[0] for phrase in phrases)


def _also(
    vocabulary: Vocabulary,
    first: str,
    lines: Sequence[str],
    called: Mapping[str, str],
    instead: AbstractSet[str],
) -> str:
    """Phrases that begin with a word, with further ones, which take the place of what is refused.

    Args:
        vocabulary: What is known everywhere.
        first: The word.
        lines: The further ones.
        called: What furniture is called here, by what it is called elsewhere.
        instead: Phrases of which the further ones say what thing they mean, and nothing else does.
    """
    taken = {line.partition("\t")[0] for line in lines}
    stay = [
        line(phrase, name, called.get(meaning, meaning) if name in _FURNITURE else meaning)
        for phrase, name, meaning in cut(vocabulary.beginning_with(first))
        if phrase not in taken
        or (
            vocabulary.refusal(Reading(name, meaning), phrase) is None
            and not (phrase in instead and name in _THINGS)
        )
    ]
    return "\n".join([*stay, *lines])


def _is_furniture_else(readings: Sequence[Reading], head: str, kinds: AbstractSet[str]) -> bool:
    """Whether a word is elsewhere said of furniture of which there is none here: "rack" of a shelf."""
    return all(one.word_class in _FURNITURE and one.meaning not in (head, *kinds) for one in readings)


def _is_otherwise_called(one: Reading, word: str) -> bool:
    """Whether furniture is called otherwise by it; "counter" of a kitchen counter is but shorter."""
    return one.word_class in _FURNITURE and one.meaning not in (word, word.rpartition(" ")[2])
