"""After which words at the end of a sentence somebody is addressed: "come to me robot", "the cup, love"."""

from __future__ import annotations

from collections.abc import Sequence
from collections.abc import Set as AbstractSet

from executive.language.text.piece import Piece

_ROBOTS = frozenset({"robot", "machine"})
"""Meanings of words that may be the second half of a thing: "the kitchen robot", "the toy tin man"."""

BESIDE = "beside"
"""Meaning of words that may name somebody: "bring it my friend"."""

_PEOPLE = frozenset({"NAME", "PERSON", "PEOPLE", "ANIMAL", "ANIMALS", "HIM", "EVERYBODY", "US"})
"""Word classes beside which they go on with a list or say who is meant: "Ana, my friend"."""

_SPEAKS = frozenset({"SAY", "TELL"})
"""Word classes behind which an address may be one of the words to say: "say hello, my friend"."""

_ENDS_SENTENCE = frozenset({".", "!", "?"})

_WHOLE = frozenset(
    {
        *("ME", "US", "IT", "THEM", "HIM", "HERE", "THERE", "BACK", "TOO", "FILLER", "BRIEFLY"),
        *("COME", "COME_BACK", "GO_BACK", "GO_HOME", "GO_SOMEWHERE", "STOP", "WAIT", "WAVE"),
        *("TIME", "LENGTH", "ANGLE", "MOMENT"),
    }
)
_NOUNS = frozenset({"KIND", "KINDS", "SUBSTANCE", "PAIR", "FURNITURE", "CONTAINER", "DOOR", "ROOM"})
_DESCRIBING = frozenset({"COLOR", "MATERIAL", "SIZE", "COMPARED", "ORDINAL", "LEFT_RIGHT", "NEAREST"})


def is_whole(before: AbstractSet[str], meaning: str) -> bool:
    """Whether what ends right before a word of address leaves no thing open that it could be.

    Args:
        before: Word classes that end there.
        meaning: Of the word of address.
    """
    whole = _WHOLE if meaning in _ROBOTS else _WHOLE | _NOUNS
    return not before.isdisjoint(whole) and before.isdisjoint(_DESCRIBING)


def is_beside(
    start: int,
    end: int,
    pieces: Sequence[Piece],
    begins: Sequence[AbstractSet[str]],
    ended: Sequence[AbstractSet[str]],
    *,
    sentence_ends: bool,
) -> bool:
    """Whether somebody is addressed who may be meant elsewhere: "come here, my friend", not "Ana, my friend".

    Args:
        start: Where the words of address begin.
        end: Where they end.
        pieces: Of the text.
        begins: Word classes that begin at each place.
        ended: Word classes that end at each place.
        sentence_ends: Whether nothing but courtesies and marks follow.
    """
    if pieces[start - 1].text != "," or not ended[start - 1].isdisjoint(_PEOPLE):
        return False
    last = sentence_ends or pieces[end].text in _ENDS_SENTENCE
    return last and all(classes.isdisjoint(_SPEAKS) for classes in begins[:start])
