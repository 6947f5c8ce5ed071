"""What the records of skills say of the commands of an errand: what each requires, and whom it is for."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any, TypeGuard

from executive.meaning import Command
from trees.registry import skill_of
from trees.skill import Before
from trees.tasks import Bringing, HandOverTask, WalkToTask


def requires(command: Command, what: Before) -> bool:
    """Whether something has to be true before a command; nothing has to before a stop."""
    skill = skill_of(command)
    return skill is not None and what in skill.before


def handles(command: Command) -> TypeGuard[Bringing]:
    """Whether a command is done to a thing with a hand, so that it has the slots of such a task."""
    return requires(command, Before.THING_AT_HAND)


def takes(command: Command) -> TypeGuard[Bringing]:
    """Whether it goes to its thing with an empty hand; other commands begin with the thing in the hand."""
    return handles(command) and not requires(command, Before.THING_HELD)


def goes_away(command: Command) -> bool:
    """Whether the robot may be elsewhere after a command."""
    skill = skill_of(command)
    return skill is not None and skill.goes_away


def whom(command: Command) -> str | None:
    """Where a command goes or whom it is for, as one word; None where that is described, or is nobody."""
    to = getattr(command, "to", None)
    if to is None and (requires(command, Before.AT_GOAL) or requires(command, Before.PERSON_KNOWN)):
        to = getattr(command, "person", None)
    return to if isinstance(to, str) else None


def _for_person(command: Command, name: str) -> Command:
    """The same for somebody by name, if whom it is for is its person."""
    changes: dict[str, Any] = {"person": name}
    return replace(command, **changes) if getattr(command, "person", None) == whom(command) else command


def with_names(command: Command, who: Mapping[str, str]) -> Command:
    """The same command with the names of those who were found by a word: "me"."""
    word = whom(command)
    if word is None or word not in who:
        return command
    if isinstance(command, HandOverTask | WalkToTask):
        return replace(command, to=who[word])
    return _for_person(command, who[word])
