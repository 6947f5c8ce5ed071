"""The other table is one and the same from the first look at it to the last."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from executive.meaning import Command
from trees.beliefs.grounding.grounding import Found, exactly, ground_furniture
from trees.beliefs.scene.believed_thing import Surroundings
from trees.tasks import ObjectDescription

_LEADS_TO = ("on", "to")
"""Slots for where something goes; what is moved there is moved to other furniture than its own."""


def with_other_furniture_named(command: Command, around: Surroundings, leaves: str | None) -> Command:
    """A command whose "other" furniture is named, if it is known by now which one that is.

    Who has walked there stands before it, and "the other one" would be the one that was left.

    Args:
        command: Any.
        around: What is believed to be around.
        leaves: What the object stood on that is moved, if there is one.
    """
    changes: dict[str, Any] = {}
    for slot in (*_LEADS_TO, "source", "object"):
        wanted = getattr(command, slot, None)
        if not isinstance(wanted, ObjectDescription):
            continue
        if slot == "object":  # "the other cup" is no furniture, but may be on some
            named = _on_named_other(wanted, around)
        else:
            named = named_other(wanted, around, leaves if slot in _LEADS_TO else None)
        if named != wanted:
            changes[slot] = named
    return replace(command, **changes) if changes else command


def named_other(
    wanted: ObjectDescription, around: Surroundings, leaves: str | None = None
) -> ObjectDescription:
    """A description of "other" furniture by its name, if that is known; so is what stands on it, or by it."""
    if wanted.ordinal != "other":
        return _on_named_other(wanted, around)
    found = ground_furniture(wanted, around, leaves)
    return exactly(found.names[0]) if isinstance(found, Found) else wanted


def _on_named_other(wanted: ObjectDescription, around: Surroundings) -> ObjectDescription:
    """A description with the "other" furniture named that it compares with."""
    relation = wanted.relation
    if relation is None or not isinstance(relation.to, ObjectDescription):
        return wanted
    return replace(wanted, relation=replace(relation, to=named_other(relation.to, around)))
