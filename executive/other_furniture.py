"""The other table is one and the same from the first look at it to the last."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from executive.meaning import Command
from trees.believed_thing import Surroundings
from trees.grounding import Found, exactly, ground_furniture
from trees.tasks import ObjectDescription

_SLOTS = ("on", "to")


def settled(command: Command, around: Surroundings, leaves: str | None) -> Command:
    """A command whose "other" furniture is named, if it is known by now which one that is.

    Who has walked there stands before it, and "the other one" would be the one that was left.

    Args:
        command: Any.
        around: What is believed to be around.
        leaves: What the object stood on that is moved, if there is one.
    """
    changes: dict[str, Any] = {}
    for slot in _SLOTS:
        wanted = getattr(command, slot, None)
        if isinstance(wanted, ObjectDescription) and (named := named_other(wanted, around, leaves)) != wanted:
            changes[slot] = named
    return replace(command, **changes) if changes else command


def named_other(
    wanted: ObjectDescription, around: Surroundings, leaves: str | None = None
) -> ObjectDescription:
    """A description of "other" furniture by its name, if that is known; any other description as it is."""
    if wanted.ordinal != "other":
        return wanted
    found = ground_furniture(wanted, around, leaves)
    return exactly(found.names[0]) if isinstance(found, Found) else wanted
