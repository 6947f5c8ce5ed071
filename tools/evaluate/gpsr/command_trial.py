"""A command, drawn for an arena, as the trial of a suite."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tools.evaluate.gpsr.arena import arena, speaker_in
from tools.evaluate.gpsr.field_commands import ANY_ARENA, Drawn, FieldCommand, FieldWords
from tools.evaluate.skills.suite import Trial

_NOT_JUDGED = ("follow", "guide")
"""Who is led has to walk along: the suites of these two have people who do."""


@dataclass(frozen=True, slots=True)
class CommandTrial(Trial):
    """A trial whose end an oracle knows.

    Attributes:
        does: The steps that were asked for: each an action, and what it names.
        words: What is where.
    """

    does: tuple[tuple[str, str], ...] = ()
    words: FieldWords = ANY_ARENA

    @property
    def person(self) -> str:
        """Whom the command names first; empty where it names nobody."""
        told = [(self.sentence.find(name), name) for name in self.words.names if name in self.sentence]
        return min(told, default=(0, ""))[1]

    @property
    def speaker(self) -> str:
        """Who gives the command: the person nearest to the robot at the beginning."""
        return speaker_in(self.scene).name


def command_trial(rng: np.random.Generator) -> CommandTrial:
    """An arena, and a command that can be carried out in it."""
    drawn = arena(rng)
    command = _command(Drawn(int(rng.integers(2**31)), drawn.words), bool(rng.random() < 0.6))
    return CommandTrial(drawn.scene, (), sentence=command.says, does=command.does, words=drawn.words)


def _command(drawn: Drawn, of_things: bool) -> FieldCommand:
    while True:
        (command,) = drawn.objects(1) if of_things else drawn.people(1)
        if not any(action in _NOT_JUDGED for action, _ in command.does):
            return command
