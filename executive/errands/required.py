"""What the records of skills say of the commands of an errand: what each requires and brings about."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any, TypeGuard

from executive.meaning import Command
from trees.registry import skill_of, task_that
from trees.skill import After, Before
from trees.tasks import Bringing, Destination


def requires(command: Command, what: Before) -> bool:
    """Whether something has to be true before a command; nothing has to before a stop."""
    skill = skill_of(command)
    return skill is not None and what in skill.before


def brings_about(command: Command, what: After) -> bool:
    """Whether something is true once a command was done."""
    skill = skill_of(command)
    return skill is not None and what in skill.after


def handles(command: Command) -> TypeGuard[Bringing]:
    """Whether a command is done to a thing with a hand, so that it has the slots of such a task."""
    return requires(command, Before.THING_AT_HAND)


def takes(command: Command) -> TypeGuard[Bringing]:
    """Whether it goes to its thing with an empty hand; other commands begin with the thing in the hand."""
    return handles(command) and not requires(command, Before.THING_HELD)


def puts_in(command: Command) -> TypeGuard[Bringing]:
    """Whether its thing goes into something that has to stand open."""
    return handles(command) and requires(command, Before.GOAL_OPEN)


def puts_on(command: Command) -> TypeGuard[Bringing]:
    """Whether its thing is put on furniture, or beside what stands there."""
    return handles(command) and requires(command, Before.AT_SURFACE)


def goes_away(command: Command) -> bool:
    """Whether the robot may be elsewhere after a command."""
    skill = skill_of(command)
    return skill is not None and (skill.goes_away or skill.strays(command))


def strays(command: Command) -> bool:
    """Whether it leads the robot away from what is at hand, to no place that anything is known of."""
    skill = skill_of(command)
    return skill is not None and skill.strays(command)


def goal(command: Command) -> Destination | None:
    """Where its thing goes, or whom it is for; None where that is nowhere and nobody."""
    skill = skill_of(command)
    found: Destination | None = None if skill is None else skill.goal(command)
    return found


def whom(command: Command) -> str | None:
    """Where a command goes or whom it is for, as one word; None where that is described, or is nobody."""
    to = getattr(command, "to", None)
    if to is None and (requires(command, Before.AT_GOAL) or requires(command, Before.PERSON_KNOWN)):
        to = getattr(command, "person", None)
    return to if isinstance(to, str) else None


def with_names(command: Command, who: Mapping[str, str]) -> Command:
    """The same command with the names of those who were found by a word: "me"."""
    word = whom(command)
    if word is None or word not in who:
        return command
    is_walked_to = brings_about(command, After.AT_GOAL) or requires(command, Before.AT_GOAL)
    slot = "to" if is_walked_to and getattr(command, "to", None) == word else "person"
    changes: dict[str, Any] = {slot: who[word]}
    return replace(command, **changes) if getattr(command, slot, None) == word else command


def walk(text: str, to: Destination) -> Command:
    """The walk to something that another command needs first."""
    command: Command = task_that(After.AT_GOAL, text, to=to)
    return command
