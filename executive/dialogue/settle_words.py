"""What is unclear in the words of a statement is asked before anything moves, whoever is there to answer."""

from __future__ import annotations

from collections.abc import Callable, Generator, Sequence
from dataclasses import replace

from executive.dialogue.attendant import Attendant
from executive.dialogue.clarification import OpenQuestion, clarified
from executive.meaning import Command, Parsed, Refusal, StopCommand
from executive.session.driver import Driver, driven
from executive.session.events import EventSink, InputTaken, QuestionAsked
from executive.trust import OnQuestion
from executive.understanding.statement import Statement
from trees.build import NoSkillError, has_skill
from trees.failures import Failure
from trees.tasks import Task

Settling = Generator[OpenQuestion, str | None, Statement | Failure]
"""A question where one is open; takes its answer, or None when there is none."""


def goes_on() -> Failure | None:
    """Nothing ends it."""
    return None


def settling(
    statement: Statement,
    on_question: OnQuestion,
    sink: EventSink,
    now_s: Callable[[], float] = lambda: 0.0,
    interruption: Callable[[], Failure | None] = goes_on,
) -> Settling:
    """Ask what is unclear in the words themselves, and refuse what is no skill; nothing moves yet.

    Args:
        statement: What was said; a question that it expects is not asked.
        on_question: What becomes of questions.
        sink: Told of what is asked and answered.
        now_s: Simulated time; left out where none has passed.
        interruption: Asked after each wait what ends it all: a cancel, a stop, or None.

    Returns:
        The statement with what the answers mean; with its question still where nobody answered; what ended
        it while an answer was waited for.
    """
    if statement.parsed.question is not None and statement.expect != "question":
        asked = yield from _asked(statement, on_question, sink, now_s, interruption)
        if isinstance(asked, Failure):
            return asked
        statement = asked
    lacking = without_skill(statement.parsed.commands)
    if lacking is not None:
        refusal = Refusal(str(NoSkillError(lacking)))
        statement = replace(statement, parsed=Parsed(statement.parsed.text, refusal=refusal))
    return statement


def settled(
    statement: Statement,
    attendant: Attendant,
    on_question: OnQuestion,
    sink: EventSink,
    now_s: Callable[[], float] = lambda: 0.0,
    interruption: Callable[[], Failure | None] = goes_on,
) -> Statement | Failure:
    """The same as ``settling``, with somebody who answers at once or not at all."""
    steps = settling(statement, on_question, sink, now_s, interruption)
    return driven(steps, attendant.answer)


def _asked(
    statement: Statement,
    on_question: OnQuestion,
    sink: EventSink,
    now_s: Callable[[], float],
    interruption: Callable[[], Failure | None],
) -> Settling:
    confirmed = statement.if_confirmed
    asking = Driver(clarified(statement.parsed, None if confirmed is None else {"yes": confirmed.parsed}))
    while asking.advance() and (question := asking.question) is not None:
        sink(QuestionAsked(now_s(), statement.parsed.text, question.text, question.choices))
        if on_question == "ask":
            answer = yield question
            if (ended := interruption()) is not None:
                return ended
        else:
            answer = question.choices[0] if on_question == "first" and question.choices else None
        sink(InputTaken(now_s(), "answer", answer or ""))
        asking.answer(answer)
    parsed = asking.result
    if confirmed is not None and parsed is confirmed.parsed:
        return statement.meaning(confirmed)
    return replace(statement, parsed=parsed)


def without_skill(commands: Sequence[Command]) -> Task | None:
    """The first command that nothing here can carry out, or None."""
    for command in commands:
        if not isinstance(command, StopCommand) and not has_skill(command):
            return command
    return None
