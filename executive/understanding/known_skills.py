"""Whether there is a skill for what was understood."""

from __future__ import annotations

from collections.abc import Sequence

from executive.meaning import Command, StopCommand
from trees.build import has_skill
from trees.tasks import Task


def without_skill(commands: Sequence[Command]) -> Task | None:
    """The first command that nothing here can carry out, or None."""
    for command in commands:
        if not isinstance(command, StopCommand) and not has_skill(command):
            return command
    return None
