"""After which words at the end of a sentence somebody is addressed: "come to me robot", "the cup, love"."""

from __future__ import annotations

from collections.abc import Set as AbstractSet

ROBOT = "robot"
"""Meaning of words that may be the second half of a thing: "the kitchen robot"."""

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
    whole = _WHOLE if meaning == ROBOT else _WHOLE | _NOUNS
    return not before.isdisjoint(whole) and before.isdisjoint(_DESCRIBING)
