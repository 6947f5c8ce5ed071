"""What a Python program asks of a robot: each request gets a ticket, and they run in their order."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from typing import Any

from executive.embedding.ticket import Ticket
from executive.session.session import Session
from executive.trust import USUAL_TRUST, OnQuestion, Trust
from executive.understanding.conversation import Conversation
from executive.understanding.statement import Statement
from executive.vocabulary.in_a_place import words_of_the_place


class Requests:
    """Takes requests for one session, and remembers what its sentences were about.

    Args:
        session: Carries them out.
    """

    def __init__(self, session: Session) -> None:
        self._session = session
        self._conversation = Conversation()
        self._last: Ticket | None = None

    def submit(
        self,
        request: str | Sequence[Mapping[str, Any] | str] | Mapping[str, Any],
        *,
        trust: Trust = USUAL_TRUST,
        on_question: OnQuestion = "ask",
        timeout_s: float | None = None,
    ) -> Ticket:
        """Take a request; it begins when somebody waits for the ticket.

        Args:
            request: A sentence, a model's JSON text, or the steps of one as Python values.
            trust: How far a model's steps are trusted.
            on_question: What becomes of questions.
            timeout_s: Simulated time that each task may take; None is the usual.
        """
        text = request if isinstance(request, str) else json.dumps(request)
        toolbox = self._session.toolbox
        with words_of_the_place(toolbox.detector.labels, toolbox.people, toolbox.detector.fronts):
            statement = Statement.of(self._conversation.understand(text, trust))
        self._last = Ticket(self._session, statement, self._last, on_question, timeout_s)
        return self._last
