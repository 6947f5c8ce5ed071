"""How a phrase begins: what may stand for what when something is said anew."""

from __future__ import annotations

from collections.abc import Sequence
from collections.abc import Set as AbstractSet

from executive.language.words.word import Word

_NUMBERS = frozenset({"NUM", "AMOUNT", "TENS", "COUPLE", "HALF", "QUARTER"})
_SIDES = frozenset({"LEFT_RIGHT", "TURN_SIDE"})
_WHERE = frozenset(
    {"ON", "ONTO", "IN", "INTO", "TO", "TO_ALSO", "NEXT_TO", "RELATION", "NEAREST_TO", "AT", "WAVE_TO"}
)
_BEGINNINGS = {
    "DET": "article",
    "NAME": "person",
    "ME": "person",
    "COLOR": "color",
    "SIZE": "size",
    "COMPARED": "size",
    "MATERIAL": "material",
    "ORDINAL": "ordinal",
    "FORWARD": "heading",
    "BACKWARD": "heading",
    "FROM": "from",
    "WITH": "with",
    "USE": "with",
    **dict.fromkeys(_NUMBERS, "number"),
    **dict.fromkeys(_SIDES, "side"),
    **dict.fromkeys(_WHERE, "where"),
}
_THINGS = frozenset({"KIND", "KINDS", "SUBSTANCE", "PAIR", "THING", "THINGS"})
SORTS = {
    **dict.fromkeys(_THINGS, "thing"),
    **dict.fromkeys(("FURNITURE", "CONTAINER", "DOOR", "ROOM"), "place"),
    **dict.fromkeys(("PERSON", "NAME", "ME"), "person"),
}
ONE = frozenset({"ONE", "ONES"})
SAID_ALONE = frozenset({"number", "side", "color", "size", "material", "ordinal", "heading"})
"""Beginnings of one word that may stand for one word anywhere before: "three", "right"."""

MEASURES = frozenset({"FOR", "BY", "NUM", "AMOUNT", "TENS", "ARTICLE", "HALF", "QUARTER", "COUPLE"})
HEADINGS = frozenset({"FORWARD", "BACKWARD", "TURN_SIDE", "AT_SPEED", "IS_IT", "IF_THERE"})
"""Word classes that a command without a verb begins with, and that go on with another one as well."""


def beginnings(words: Sequence[Word], commands: AbstractSet[str]) -> set[str]:
    """As what a phrase can be taken that begins with one of some words.

    Args:
        words: The readings of its beginning.
        commands: Word classes that a command begins with.
    """
    found = set()
    for word in words:
        if word.word_class in _BEGINNINGS:
            found.add(_BEGINNINGS[word.word_class])
        elif word.word_class in SORTS:
            found.add(f"bare {SORTS[word.word_class]}")
        if word.word_class in commands:
            found.add(f"do {word.meaning.partition(':')[0]}")
    return found
