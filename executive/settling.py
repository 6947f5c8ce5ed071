"""What is unclear in the words of a statement is asked before anything moves, whoever is there to answer."""

from __future__ import annotations

from collections.abc import Callable, Generator
from dataclasses import replace

from executive.attendant import Attendant
from executive.clarification import OpenQuestion, clarified
from executive.errand import without_skill
from executive.events import EventSink, InputTaken, QuestionAsked
from executive.meaning import Parsed, Refusal
from executive.statement import Statement
from executive.trust import OnQuestion
from trees.build import NoSkillError

Settling = Generator[OpenQuestion, str | None, Statement]
"""A question where one is open; takes its answer, or None when there is none."""


def settling(
    statement: Statement, on_question: OnQuestion, sink: EventSink, now_s: Callable[[], float] = lambda: 0.0
) -> Settling:
    """Ask what is unclear in the words themselves, and refuse what is no skill; nothing moves yet.

    Args:
        statement: What was said; a question that it expects is not asked.
        on_question: What becomes of questions.
        sink: Told of what is asked and answered.
        now_s: Simulated time; left out where none has passed.

    Returns:
        The statement with what the answers mean; with its question still where nobody answered.
    """
    if statement.parsed.question is not None and statement.expect != "question":
        statement = yield from _asked(statement, on_question, sink, now_s)
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
) -> Statement:
    """The same as ``settling``, with somebody who answers at once or not at all."""
    steps = settling(statement, on_question, sink, now_s)
    answer: str | None = None
    while True:
        try:
            question = steps.send(answer)
        except StopIteration as end:
            result: Statement = end.value
            return result
        answer = attendant.answer(question)


def _asked(
    statement: Statement, on_question: OnQuestion, sink: EventSink, now_s: Callable[[], float]
) -> Settling:
    confirmed = statement.if_confirmed
    steps = clarified(statement.parsed, None if confirmed is None else {"yes": confirmed.parsed})
    answer: str | None = None
    while True:
        try:
            question = steps.send(answer)
        except StopIteration as end:
            parsed: Parsed = end.value
            break
        sink(QuestionAsked(now_s(), statement.parsed.text, question.text, question.choices))
        if on_question == "ask":
            answer = yield question
        else:
            answer = question.choices[0] if on_question == "first" and question.choices else None
        sink(InputTaken(now_s(), "answer", answer or ""))
    if confirmed is not None and parsed is confirmed.parsed:
        return statement.meaning(confirmed)
    return replace(statement, parsed=parsed)
