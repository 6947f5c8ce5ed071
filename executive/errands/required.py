"""What the records of skills say of the commands of an errand."""

from __future__ import annotations

from typing import TypeGuard

from executive.meaning import Command
from trees.registry import skill_of
from trees.skill import Before
from trees.tasks import Bringing


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
