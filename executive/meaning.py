"""What a text was understood as: commands, a question, or a refusal; frozen values with a JSON form."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Any, Literal

from trees.tasks import GoHomeTask, ObjectDescription, ObjectOf, PickTask, Relation, Task

ECHO_LENGTH = 200
"""Longer input is shortened where it is repeated to the user."""


@dataclass(frozen=True, slots=True)
class StopCommand:
    """Cancel what is under way and hold; no behavior tree is needed for it."""

    text: str

    action = "stop"


Command = Task | StopCommand


@dataclass(frozen=True, slots=True)
class Question:
    """What must be known before anything moves.

    Attributes:
        text: What is asked.
        choices: What may be answered, each a sentence; empty when any sentence may answer.
        completes: What stands before and behind an answer that is a part of the sentence; None where it is
            none, so that something that was said before may answer too.
    """

    text: str
    choices: tuple[str, ...] = ()
    completes: tuple[str, str] | None = None


@dataclass(frozen=True, slots=True)
class Refusal:
    """Why nothing is done.

    Attributes:
        message: One sentence for people.
        word: The words that caused it, or None.
        nearest: A valid wording near to what was said, or None.
    """

    message: str
    word: str | None = None
    nearest: str | None = None

    def __str__(self) -> str:
        return self.message + (f"; try {self.nearest!r}" if self.nearest else "")


@dataclass(frozen=True, slots=True)
class Parsed:
    """What a text was understood as; exactly one of commands, question and refusal is there.

    ``manners`` are words such as "gently" that ask for nothing that is not done anyway; whoever said them
    is told so.
    """

    text: str
    commands: tuple[Command, ...] = ()
    question: Question | None = None
    refusal: Refusal | None = None
    manners: tuple[str, ...] = ()

    @property
    def outcome(self) -> Literal["tasks", "question", "refused"]:
        """Which of the three it is."""
        if self.refusal is not None:
            return "refused"
        return "question" if self.question is not None else "tasks"

    def to_json(self) -> dict[str, Any]:
        """As the command-line contract writes the answer of ``parse``."""
        question, refusal = self.question, self.refusal
        return {
            "text": shortened(self.text),
            "outcome": self.outcome,
            "tasks": [command_json(command) for command in self.commands],
            "question": question and {"text": question.text, "choices": list(question.choices)},
            "refusal": refusal
            and {"message": refusal.message, "word": refusal.word, "nearest": refusal.nearest},
        }


_SLOT_NAMES = {"source": "from", "words": "text"}
"""Slots whose name in JSON is not that of the task's field."""


def command_json(command: Command) -> dict[str, Any]:
    """One command's slots, without absent and false ones, a count of one, and what is too long to tell."""
    slots: dict[str, Any] = {"action": command.action}
    for field in fields(command):
        value = getattr(command, field.name)
        if (
            field.name == "text"
            or not field.repr
            or value is None
            or value is False
            or (field.name == "count" and value == 1)
        ):
            continue
        slots[_SLOT_NAMES.get(field.name, field.name)] = _slot(value)
    return slots


def _slot(value: Any) -> Any:
    match value:
        case ObjectOf():
            return {"ref": value.task}
        case Relation():
            return {"is": value.kind, "to": _slot(value.to)}
        case ObjectDescription():
            present = {field.name: getattr(value, field.name) for field in fields(value)}
            return {key: _slot(item) for key, item in present.items() if item not in (None, ())}
        case tuple():
            return [_slot(item) for item in value]
        case _:
            return value


def wording(command: Command) -> str:
    """The plainest sentence that means this command."""
    match command:
        case PickTask():
            parts = ["pick up the", str(command.object)]
            if command.source:
                parts += ["from the", str(command.source)]
            if command.hand:
                parts += ["with the", command.hand, "hand"]
            return " ".join(parts)
        case GoHomeTask():
            return "go home"
        case StopCommand():
            return "stop"
        case _:
            return command.text


def shortened(text: str) -> str:
    """The text, or its beginning when it is too long to repeat."""
    return text if len(text) <= ECHO_LENGTH else text[:ECHO_LENGTH] + "…"
