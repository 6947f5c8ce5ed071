"""Statements whose words are settled, one after the other: carry out, judge by what was expected."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

from executive.dialogue.attendant import Attendant
from executive.dialogue.settle_words import goes_on
from executive.errands.errand import Errand
from executive.exit_codes import ExitCode
from executive.meaning import Command
from executive.reports.feedback import result_line, result_line_of_all
from executive.scripts.script_order import first_unexpected, in_order, unexpected_code
from executive.session.driver import driven
from executive.session.events import EventSink, QuestionAsked, TaskRefused
from executive.session.session import Session
from executive.session.task_result import TaskResult
from executive.trust import OnQuestion
from executive.understanding.statement import Statement
from trees.failures import Failure

Said = tuple[Statement, list[TaskResult]]
"""A statement with the results of its tasks."""

Again = Callable[[Statement, Sequence[TaskResult]], Statement | None]
"""What is to be done instead of a statement that has failed, or None."""


def may_start(statement: Statement) -> bool:
    """Tell whether a statement's words are as expected."""
    outcome = statement.parsed.outcome
    return outcome == "tasks" or outcome == statement.expect


def settle_all(
    statements: Iterable[Statement],
    settle: Callable[[Statement], Statement | Failure],
    sink: EventSink,
    now_s: Callable[[], float] = lambda: 0.0,
    interruption: Callable[[], Failure | None] = goes_on,
) -> tuple[list[Statement], list[Said]]:
    """Settle what is unclear in the words of every statement, before the first one is carried out.

    Args:
        statements: What was said; may be understood one by one, as they are taken.
        settle: Settles the words of one; a failure ends it all.
        sink: Told of what is refused.
        now_s: Simulated time; left out where none has passed.
        interruption: Asked after each statement what ends it all: a cancel, a stop, or None.

    Returns:
        The statements that may be carried out, and nothing; or none, and what it all comes to instead.
    """
    ready: list[Statement] = []
    for said in statements:
        one = settle(said)
        if not isinstance(one, Failure):
            ready.append(one)
        ended = one if isinstance(one, Failure) else interruption()
        if ended is not None:
            return [], [(said, [not_begun(said, ended)])]
    spoiled = _unstarted(ready, sink, now_s())
    return ([], spoiled) if spoiled else (ready, [])


def _unstarted(statements: Sequence[Statement], sink: EventSink, now_s: float) -> list[Said]:
    """What a script comes to that does not begin: one is not as expected, or there is nothing to do.

    Returns:
        The first statement that is in the way, or all of them; nothing where the script may begin.
    """
    spoiled = [one for one in statements if not may_start(one)]
    if not spoiled and any(one.parsed.commands for one in statements):
        return []
    return [(one, [not_understood(one, now_s, sink)]) for one in spoiled[:1] or statements]


def run_statements(
    statements: Sequence[Statement],
    session: Session,
    attendant: Attendant,
    on_question: OnQuestion,
    sink: EventSink,
    again: Again | None = None,
) -> list[Said]:
    """Carry statements out, until one does not end as expected and does not say to go on.

    Args:
        statements: What was said, settled.
        session: Carries out single tasks.
        attendant: Who answers questions and may cancel.
        on_question: What becomes of questions.
        sink: Told of what is asked.
        again: Gives another meaning of what has failed, where somebody knows one.
    """

    def carry_out(statement: Statement) -> Sequence[TaskResult]:
        results = list(once(statement))
        while again is not None and (other := again(statement, results)) is not None:
            results += once(other)
        return results

    def once(statement: Statement) -> Sequence[TaskResult]:
        if not statement.parsed.commands:
            return [not_understood(statement, session.now_s, sink)]
        errand = Errand(
            session,
            statement.parsed.commands,
            timeout_s=statement.timeout_s,
            on_question="fail" if statement.expect == "question" else on_question,
            provenance=statement.provenance,
        )
        return driven(errand.steps(), attendant.answer, lambda: attendant.attend(session))

    with session.request():
        return in_order(statements, carry_out)


def not_understood(statement: Statement, now_s: float, sink: EventSink) -> TaskResult:
    """The result of a statement that was not turned into tasks."""
    parsed = statement.parsed
    text = parsed.to_json()["text"]
    if parsed.refusal is not None:
        sink(TaskRefused(now_s, text, str(parsed.refusal), parsed.refusal.word))
        return TaskResult(text, "none", "refused")
    if parsed.question is not None and statement.expect == "question":
        sink(QuestionAsked(now_s, text, parsed.question.text, parsed.question.choices))
    return TaskResult(text, "none", "question")


def not_begun(statement: Statement, ended: Failure) -> TaskResult:
    """The result of a statement that was cancelled, or stopped, before anything of it had moved."""
    return TaskResult(statement.parsed.to_json()["text"], "none", "cancelled", failure=ended)


def verdict(statements: Sequence[Statement], results: Sequence[Said]) -> tuple[str, str, ExitCode]:
    """The line for people, the outcome, and the exit code of the first unexpected result."""
    unexpected = first_unexpected(results)
    if unexpected is not None:
        statement, last = unexpected
        line = _line(statement, last)
        if statement.expect != "done":
            line = f"expected {statement.expect}, got {line}"
        return line, "failed" if last.outcome == "done" else last.outcome, unexpected_code(last)
    statement, said = results[-1]
    line = _line(statement, said[-1]) if len(said) == 1 else result_line_of_all(said)
    if len(statements) > 1:
        line = f"script done: {len(results)} statements as expected; last {line}"
    elif statement.expect != "done":
        line = f"as expected: {line}"
    left_out = [f"{step.text!r} ({step.reason})" for one, _ in results for step in one.skipped]
    if left_out:
        line += f"; left out: {', '.join(left_out)}"
    manners = dict.fromkeys(word for one, _ in results for word in one.parsed.manners)
    if manners:
        line += f"; {' and '.join(map(repr, manners))} changed nothing: every motion keeps the same limits"
    return line, "done", ExitCode.DONE


def _line(statement: Statement, result: TaskResult) -> str:
    if result.outcome == "refused" and statement.parsed.refusal is not None:
        return f"refused: {statement.parsed.refusal}"
    if result.outcome == "question" and statement.parsed.question is not None:
        return f"question: {statement.parsed.question.text}"
    return result_line(result)


def failed_command(results: Sequence[Said]) -> Command | None:
    """The command of the last task that was tried and failed, or None where the last one did not."""
    if not results or not results[-1][1] or results[-1][1][-1].outcome != "failed":
        return None
    statement, told = results[-1]
    return next((one for one in statement.parsed.commands if one.text == told[-1].text), None)
