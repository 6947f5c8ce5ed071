"""A task's question, and the command that its answer makes."""

from __future__ import annotations

from collections.abc import Callable, Generator
from dataclasses import replace
from functools import partial
from typing import Any

from executive.dialogue.clarification import (
    MAX_TRIES,
    Chosen,
    OpenQuestion,
    Unclear,
    Withdrawn,
    understood_answer,
)
from executive.meaning import Command
from executive.session.events import InputTaken, QuestionAsked
from executive.session.session import Session
from executive.trust import OnQuestion
from trees.beliefs.grounding.grounding import exactly, ground
from trees.beliefs.grounding.questions import OTHER
from trees.beliefs.scene.believed_thing import Surroundings
from trees.failures import Failure, FailureKind
from trees.tasks import ObjectDescription


def answered_command(
    session: Session,
    command: Command,
    failure: Failure,
    on_question: OnQuestion,
    believed: Callable[[], Surroundings],
) -> Generator[OpenQuestion | None, str | None, Command | Failure | None]:
    """Put the question that a failure asks, and fill the answer in.

    Args:
        session: Told of what is asked and answered.
        command: What the question is about.
        failure: Has the choices.
        on_question: What becomes of questions.
        believed: What is around the robot when the answer comes.

    Returns:
        The command with the choice that was made; why it was withdrawn, cancelled or stopped meanwhile;
        None when nobody answered.
    """
    choices, names, asks = failure.choices, failure.choice_names, failure.root
    question = asks.message
    if len(names) == 1 and asks.open_choice is not None and asks.open_choice.one_will_do:
        return _answered(command, failure.choice_slot, names[0])
    session.tell(QuestionAsked(session.now_s, command.text, question, choices))
    if on_question == "fail" or not names:
        return None
    if on_question == "first":
        session.tell(InputTaken(session.now_s, "answer", choices[0]))
        return _answered(command, failure.choice_slot, names[0])
    tried = ""
    for _ in range(MAX_TRIES):
        text = yield OpenQuestion(question, choices, tried)
        if session.interrupted:
            text = None
        session.tell(InputTaken(session.now_s, "answer", text or ""))
        if (ended := session.interruption()) is not None:
            return ended
        if text is None:
            return None
        around = believed().only(names)
        people = [thing for thing in around.things if thing.is_person and thing.name in names]
        meant = partial(ground, around=around, among=people or None)
        match understood_answer(text, choices, meant, names):
            case Chosen(index):
                return _answered(command, failure.choice_slot, names[index])
            case Withdrawn():
                return Failure(FailureKind.CANCELED, "withdrawn by the answer")
            case Unclear(message):
                tried = message
    return None


def of_one(command: Command, name: str) -> Command:
    """The command for one named object."""
    changes: dict[str, Any] = {"object" if hasattr(command, "object") else "to": exactly(name)}
    if hasattr(command, "count"):
        changes["count"] = 1
    return replace(command, **changes)


def _answered(command: Command, slot: str, name: str) -> Command:
    """The command with the thing that was chosen in the slot that was asked about."""
    if slot == "object" and hasattr(command, slot):
        return of_one(command, name)
    meant: Any = exactly(name)
    if slot == OTHER:
        slot, to = "to", getattr(command, "to", None)
        if isinstance(to, ObjectDescription) and to.relation is not None:
            meant = replace(to, relation=replace(to.relation, to=meant))
    changes: dict[str, Any] = {slot: meant}
    return replace(command, **changes)
