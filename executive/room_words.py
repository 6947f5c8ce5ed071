"""Rooms that somebody speaks of, and that are not on the map."""

from __future__ import annotations

from collections.abc import Collection, Sequence

from executive.canonical_words import vocabulary
from executive.meaning import Command

_SLOTS = ("to", "on", "source")


def missing_room(commands: Sequence[Command], rooms: Collection[str]) -> tuple[Command, str] | None:
    """The first command that speaks of a room which is not on the map, with that word; None without one.

    Args:
        commands: What was said.
        rooms: Names of the rooms on the map.
    """
    for command in commands:
        for slot in _SLOTS:
            said = getattr(command, slot, None)
            if isinstance(said, str) and said not in rooms and _is_room(said):
                return command, said
    return None


def _is_room(word: str) -> bool:
    """Whether it is the name of nothing but a room."""
    words = word.lower().split()
    length, readings = vocabulary().match(words)
    return length == len(words) > 0 and bool(readings) and all(one.word_class == "ROOM" for one in readings)
