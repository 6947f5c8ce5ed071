"""References between commands: which there are, and filling them in."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import fields, replace
from typing import Any

from executive.meaning import Command
from trees.tasks import ObjectDescription, ObjectOf, Relation, Thing

PREVIOUS = ObjectOf(-1)
"""The object that the last statement moved."""


def references(value: Any) -> frozenset[int]:
    """Indices of the tasks that a command, or a part of one, refers to."""
    if isinstance(value, ObjectOf):
        return frozenset({value.task})
    if not _has_parts(value):
        return frozenset()
    return frozenset().union(*(references(getattr(value, field.name)) for field in fields(value)))


def with_references(command: Command, thing_for: Callable[[int], Thing]) -> Command:
    """The same command with every reference replaced by what ``thing_for`` says for its index."""
    filled: Command = _filled(command, thing_for)
    return filled


def _filled(value: Any, thing_for: Callable[[int], Thing]) -> Any:
    if isinstance(value, ObjectOf):
        return thing_for(value.task)
    if not _has_parts(value):
        return value
    parts = {field.name: getattr(value, field.name) for field in fields(value)}
    return replace(value, **{name: _filled(part, thing_for) for name, part in parts.items()})


def _has_parts(value: Any) -> bool:
    return isinstance(value, ObjectDescription | Relation) or hasattr(value, "action")
