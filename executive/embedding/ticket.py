"""A request on its way, for programs that embed the executive: watch it, answer it, cancel it, await it.

    ticket = Requests(session).submit("pick up the cup")
    ticket.subscribe(print)
    ticket.on_question(lambda question: "the red one")
    results = ticket.result()            # or: results = await ticket

Nothing passes by itself: a session in lockstep goes on while somebody waits for a ticket, in the thread that
waits. Tickets of one session run in the order in which they were submitted; one that was cancelled before its
turn ends when its turn comes, without a question and without a motion.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Generator
from typing import TYPE_CHECKING, Any

from executive.dialogue.clarification import OpenQuestion
from executive.dialogue.settle_words import settling
from executive.errands.errand import Errand, Steps
from executive.scripts.script_run import not_begun, not_understood
from executive.session.cancellation import Cancellation
from executive.session.driver import Driver
from executive.session.events import Event
from executive.session.task_result import TaskResult
from executive.trust import OnQuestion
from executive.understanding.statement import Statement
from trees.failures import Failure

if TYPE_CHECKING:
    from executive.session.session import Session

Answerer = Callable[[OpenQuestion], str | None]


class Ticket:
    """One request and what becomes of it; made by ``Requests.submit``.

    Attributes:
        statement: What was understood; once it is under way, with what its answers mean.
    """

    def __init__(
        self,
        session: Session,
        statement: Statement,
        before: Ticket | None,
        on_question: OnQuestion,
        timeout_s: float | None,
    ) -> None:
        self.statement = statement
        self._session, self._before = session, before
        self._on_question, self._timeout_s = on_question, timeout_s
        self._answerer: Answerer | None = None
        self._subscribers: list[Callable[[Event], None]] = []
        self._cancellation = Cancellation()
        self._driver = Driver(self._begin())

    @property
    def done(self) -> bool:
        """Whether it has ended."""
        return self._driver.done

    @property
    def question(self) -> OpenQuestion | None:
        """The question that holds it, or None."""
        return self._driver.question

    def subscribe(self, hear: Callable[[Event], None]) -> None:
        """Have every event told that is told while it is under way."""
        self._subscribers.append(hear)

    def on_question(self, answer: Answerer) -> None:
        """Have questions answered by a function; None from it leaves the question open."""
        self._answerer = answer

    def answer(self, text: str | None) -> None:
        """Answer the open question; None leaves it unanswered, and ends the task.

        Raises:
            RuntimeError: No question is open.
        """
        self._driver.answer(text)
        self._session.wake()

    def cancel(self, reason: str = "cancelled") -> None:
        """Halt it, or never begin it; safe from another thread or a signal handler."""
        self._cancellation.ask(reason)
        self._session.wake()

    def advance(self) -> bool:
        """Go on by one tick; False while a question is open, and after the end.

        A question that is open when the ticket is cancelled, or the emergency stop engaged, is one no more.
        """
        if self.done:
            return False
        if self._before is not None and not self._before.done:
            return self._before.advance()
        self._before = None
        if self.question is not None:
            if not self._session.interrupted:
                return False
            self.answer(None)
        if not self._step():
            return False
        if self.question is not None and self._answerer is not None:
            self.answer(self._answerer(self.question))
        return True

    def result(self) -> tuple[TaskResult, ...]:
        """Go on to the end, and return the results of the tasks that were begun, in order.

        A question that is open when nothing can go on any more stays unanswered.
        """
        while not self.done:
            if not self.advance() and not self.done:
                self._leave_open()
        return self._driver.result

    def __await__(self) -> Generator[Any, None, tuple[TaskResult, ...]]:
        """Go on to the end, letting the event loop run between two ticks; sleeps until there is an answer."""
        return self._awaited().__await__()

    async def _awaited(self) -> tuple[TaskResult, ...]:
        loop, woken = asyncio.get_running_loop(), asyncio.Event()

        def wake() -> None:
            loop.call_soon_threadsafe(woken.set)

        with self._session.woken_by(wake):
            while not self.done:
                woken.clear()
                if self.advance():
                    await asyncio.sleep(0)
                elif not self.done:
                    await woken.wait()
        return self._driver.result

    def _step(self) -> bool:
        """Let those who subscribed hear one step; whoever sleeps is told of the end."""
        try:
            with self._session.events.heard_by(self._hear):
                return self._driver.advance()
        finally:
            if self._driver.done:
                self._session.wake()

    def _leave_open(self) -> None:
        ticket: Ticket | None = self
        while ticket is not None:
            if ticket.question is not None:
                ticket.answer(None)
            ticket = ticket._before

    def _hear(self, event: Event) -> None:
        for hear in self._subscribers:
            hear(event)

    def _begin(self) -> Steps:
        with self._session.request(self._cancellation):
            return (yield from self._request())

    def _request(self) -> Steps:
        """The statement's questions first, if it has any; then its commands."""
        session = self._session
        statement: Statement | Failure | None = self._cancellation.taken(session.now_s, session.tell)
        if statement is None:
            statement = yield from settling(
                self.statement, self._on_question, session.tell, lambda: session.now_s, session.interruption
            )
        if isinstance(statement, Failure):
            return (not_begun(self.statement, statement),)
        self.statement = statement
        if not statement.parsed.commands:
            return (not_understood(statement, session.now_s, session.tell),)
        errand = Errand(
            session,
            statement.parsed.commands,
            timeout_s=self._timeout_s,
            on_question=self._on_question,
            provenance=statement.provenance,
        )
        return (yield from errand.steps())
