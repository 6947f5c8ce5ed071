"""What was said before: a sentence may lean on it, as "put it down" does on "take the red cup"."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

from executive.meaning import Command, Parsed
from executive.references import PREVIOUS, references, with_references
from executive.trust import USUAL_TRUST, Trust
from executive.understanding.understanding import (
    Understood,
    asked_after,
    is_model_output,
    read_after,
    understand,
)
from trees.tasks import Bringing, CloseTask, ObjectDescription, ObjectOf, OpenTask, Thing

_ONE = re.compile(r"\bones?\b", re.IGNORECASE)
_REMEMBERED = 4
"""So many sentences back people still say "it"."""


class Conversation:
    """Understands one sentence after the other; what only the ones before make clear is read after them.

    A word like "it" is filled in by what described its object before: the robot looks for that, or finds it
    in its hand. "The left cup" need not be the left one any more: that is the thing that was moved last.
    """

    def __init__(self) -> None:
        self._said: list[str] = []
        self._leaning: set[str] = set()

    def understand(self, text: str, trust: Trust = USUAL_TRUST) -> Understood:
        """Understand a sentence or a model's output; any string gives an answer."""
        understood = understand(text, trust)
        if is_model_output(text):
            self._said.clear()
            return understood
        if _asks(understood.parsed) or _says_one(understood.parsed):
            commands = _filled_in(*read_after(text, self._said))
            if commands:
                understood = Understood(replace(understood.parsed, question=None, commands=commands))
                self._leaning.add(text)
            elif (question := asked_after(text, self._said)) is not None:
                understood = Understood(replace(understood.parsed, question=question, commands=()))
        if understood.parsed.commands:
            self._remember(text)
        return understood

    def _remember(self, text: str) -> None:
        self._said = [*self._said, text][-_REMEMBERED:]
        while self._said and self._said[0] in self._leaning:  # nothing is left that it leans on
            del self._said[0]


def _asks(parsed: Parsed) -> bool:
    """Whether it is not clear what is meant; where choices are told, what was said before is none of them.

    Where words are missing, none that were said before are taken for them.
    """
    question = parsed.question
    return question is not None and not question.choices and question.completes is None


def _says_one(parsed: Parsed) -> bool:
    """Whether it speaks of "the left one": of what kind, is said before or not at all."""
    return bool(parsed.commands) and _ONE.search(parsed.text) is not None


def _filled_in(earlier: Sequence[Command], leaning: Sequence[Command]) -> tuple[Command, ...]:
    """The commands without references to earlier ones; none where one means several things, or no thing."""
    count = len(earlier)
    things: dict[int, Thing | None] = {index: _thing_of(earlier, index) for index in range(count)}
    for command in leaning:
        for index in references(command):
            by_name = things.get(index) == PREVIOUS and getattr(command, "object", None) != ObjectOf(index)
            if index < count and (things[index] is None or by_name):
                return ()

    def thing_for(index: int) -> Thing:
        return things.get(index) or ObjectOf(index - count)

    return tuple(with_references(command, thing_for) for command in leaning)


def _thing_of(commands: Sequence[Command], index: int) -> Thing | None:
    """What stands for the object of a command: its description, if that still fits when it has moved.

    A drawer that is opened stays the top one.
    """
    described = _described(commands, index)
    if described is None or described == replace(described, ordinal=None, relation=None, size=None):
        return described
    if isinstance(commands[index], OpenTask | CloseTask):
        return described
    moved = [i for i, command in enumerate(commands) if isinstance(command, Bringing)]
    return PREVIOUS if moved and _described(commands, moved[-1]) == described else None


def _described(commands: Sequence[Command], index: int) -> ObjectDescription | None:
    """What described the one object of a command."""
    command = commands[index]
    thing = getattr(command, "object", None)
    if getattr(command, "count", 1) != 1:
        return None
    if isinstance(thing, ObjectOf):
        return _described(commands, thing.task)
    return thing if isinstance(thing, ObjectDescription) else None
