"""A person, a model and the robot: what is proposed is read back and answered, and after a failure once more.

Nothing moves while a model is asked, nor before the person has said yes to what came of it.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import TYPE_CHECKING, Any

from executive.dialogue.clarification import (
    MAX_TRIES,
    Chosen,
    OpenQuestion,
    Unclear,
    Withdrawn,
    understood_answer,
)
from executive.dialogue.settle_words import Settling, goes_on
from executive.front.front_model import FrontModel, Waiting
from executive.front.proposal import Asked, Context, ModelFailure, Proposed
from executive.front.recorded import MODEL_INPUT, written_answer
from executive.front.things_around import things_around
from executive.meaning import Parsed, Question, Refusal
from executive.session.driver import driven
from executive.session.events import EventSink, InputTaken, QuestionAsked, TaskRefused
from executive.session.task_result import TaskResult
from executive.understanding.statement import Statement
from executive.understanding.understanding import Understood
from trees.failures import Failure

if TYPE_CHECKING:
    from executive.session.session import Session

Seen = Callable[[], Sequence[Mapping[str, Any]]]
"""What is believed to be around the robot now, each thing as JSON values."""
_YES_NO = ("yes", "no")


def nothing_seen() -> Sequence[Mapping[str, Any]]:
    """Nothing: there is no robot yet."""
    return ()


def at_the_start() -> float:
    """No simulated time has passed."""
    return 0.0


@dataclass(slots=True)
class _Tried:
    """What a sentence has come to so far: what was proposed last, and what is known of it."""

    document: str
    context: Context
    again: int = 0


class FrontTalk:
    """Settles the sentences of one run with a model.

    Args:
        front: The model.
        answer: Puts a question to the person; None where nobody answers.
        sink: Told of what is asked and answered, and of what came of no new proposal.
        waiting: Called again and again while the model's answer is waited for.
        seen: What is around the robot.
        now_s: Simulated time.
        interruption: What ends it all: a cancel, a stop, or None.
    """

    def __init__(
        self,
        front: FrontModel,
        answer: Callable[[OpenQuestion], str | None],
        sink: EventSink,
        waiting: Waiting,
        seen: Seen = nothing_seen,
        now_s: Callable[[], float] = at_the_start,
        interruption: Callable[[], Failure | None] = goes_on,
    ) -> None:
        self._front, self._answer, self._sink, self._waiting = front, answer, sink, waiting
        self._seen, self._now_s, self._interruption = seen, now_s, interruption
        self._tried: dict[str, _Tried] = {}

    def meet(self, session: Session) -> None:
        """There is a robot from now on: what it believes is told, and its time is that of the events."""
        self._seen = partial(things_around, session.toolbox)
        self._now_s = lambda: session.now_s
        self._interruption = session.interruption

    def takes(self, statement: Statement) -> bool:
        """Whether a statement is one for the model; not what is expected to be refused or asked."""
        understood = Understood(statement.parsed)
        return statement.expect in ("done", "failed") and self._front.takes(statement.parsed.text, understood)

    def settled(self, statement: Statement) -> Statement | Failure:
        """The statement with what the person has said yes to; refused, or with its question, otherwise."""
        return driven(self._steps(statement, Context(seen=tuple(self._seen()))), self._answer)

    def again(self, statement: Statement, results: Sequence[TaskResult]) -> Statement | None:
        """What is to be done after a proposal of the model has failed; None where nothing is.

        Args:
            statement: What has failed.
            results: How its tasks ended.
        """
        last, tried = results[-1], self._tried.get(statement.parsed.text)
        if tried is None or last.outcome != "failed" or last.failure is None:
            return None
        if tried.again >= self._front.settings.attempts or self._interruption() is not None:
            return None
        tried.again += 1
        context = replace(tried.context, seen=tuple(self._seen()))
        context = context.failing(tried.document, last.failure.to_json())
        found = driven(self._steps(statement, context), self._answer)
        if isinstance(found, Failure) or found.parsed.question is not None:
            return None
        if found.parsed.refusal is not None:
            self._sink(TaskRefused(self._now_s(), found.parsed.text, str(found.parsed.refusal), None))
            return None
        self._tried[statement.parsed.text].again = tried.again
        return found

    def _steps(self, statement: Statement, context: Context) -> Settling:
        text = statement.parsed.text
        for _ in range(MAX_TRIES):
            answer = self._front.ask(text, context, self._waiting)
            self._sink(InputTaken(self._now_s(), MODEL_INPUT, written_answer(answer)))
            answered = self._front.judged(answer, text, context)
            if (ended := self._interruption()) is not None:
                return ended
            if isinstance(answered, ModelFailure):
                return _refused(statement, answered.reason)
            found = answered
            confirmed = isinstance(found, Proposed) and not (self._front.reads_back or found.must_ask)
            reply = None if confirmed else (yield from self._asked(text, found))
            if not confirmed and (ended := self._interruption()) is not None:
                return ended
            if not confirmed and reply is None:
                break
            meant = Chosen(0) if reply is None else understood_answer(reply, _choices(found))
            match meant, found:
                case Chosen(0), Proposed(understood, document):
                    self._tried[text] = _Tried(document, context)
                    return _meaning(statement, understood)
                case ((Chosen() | Withdrawn()), _):
                    return _refused(replace(statement, parsed=Parsed(text)), "withdrawn by the answer")
                case Unclear(), _:
                    context = context.answering(_words(found), reply or "")
        return statement.meaning(Understood(as_parsed(Parsed(text), found, reads_back=True)))

    def _asked(self, text: str, found: Proposed | Asked) -> Generator[OpenQuestion, str | None, str | None]:
        self._sink(QuestionAsked(self._now_s(), text, _words(found), _choices(found)))
        answer = yield OpenQuestion(_words(found), _choices(found))
        self._sink(InputTaken(self._now_s(), "answer", answer or ""))
        return answer


def as_parsed(parsed: Parsed, found: Proposed | Asked | ModelFailure, reads_back: bool) -> Parsed:
    """What is known of a sentence before anybody has answered: tasks, a question or a refusal.

    Args:
        parsed: What the parser makes of it.
        found: What the model makes of it.
        reads_back: Whether everything is read back.
    """
    if isinstance(found, ModelFailure):
        return _refused(Statement(parsed), found.reason).parsed
    if isinstance(found, Proposed) and not (reads_back or found.must_ask):
        return replace(found.understood.parsed, text=parsed.text)
    return Parsed(parsed.text, question=Question(_words(found), _choices(found)))


def _words(found: Proposed | Asked) -> str:
    return found.read_back if isinstance(found, Proposed) else found.question


def _choices(found: Proposed | Asked) -> tuple[str, ...]:
    return _YES_NO if isinstance(found, Proposed) else found.choices


def _meaning(statement: Statement, understood: Understood) -> Statement:
    """The statement with what was meant; it is still called as it was said."""
    return statement.meaning(
        replace(understood, parsed=replace(understood.parsed, text=statement.parsed.text))
    )


def _refused(statement: Statement, reason: str) -> Statement:
    """Refused, with what the parser has said as well, where it did not understand the sentence."""
    own = statement.parsed.refusal
    refusal = Refusal(reason) if own is None else replace(own, message=f"{own.message}; {reason}")
    return statement.meaning(Understood(Parsed(statement.parsed.text, refusal=refusal)))
