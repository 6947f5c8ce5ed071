"""What a line means, found out by who is in front, with its questions and the person's answers."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from executive.chat.aside import Aside
from executive.chat.front import AskBack, Front, GivenUp, Meaning, Meant, NotMeant
from executive.dialogue.clarification import Chosen, OpenQuestion, Withdrawn, understood_answer
from executive.doors.served_robot import TaskStatus

_YES_OR_NO = ("yes", "no")


@dataclass(frozen=True, slots=True)
class GaveUp:
    """Nothing is begun; ``reason`` is why nothing was understood, empty where the person withdrew."""

    reason: str = ""


class Understanding:
    """Has lines understood, one at a time, and their meaning confirmed.

    Args:
        front: Who understands.
        aside: Where that is done.
        ask: Puts a question to the person.
        take: Takes what a line means, once that is settled; None where nothing is to be done.
    """

    def __init__(
        self,
        front: Front,
        aside: Aside,
        ask: Callable[[OpenQuestion], None],
        take: Callable[[Meant | GaveUp | None], None],
    ) -> None:
        self._front, self._aside, self._ask, self._take = front, aside, ask, take
        self._line = ""
        self._about: list[tuple[str, str]] = []
        self._meant: Meant | None = None
        self._thought: object | None = None

    def begin(self, line: str) -> None:
        """Understand a line."""
        self._line, self._about = line, []
        self._understand()

    def anew(self, failed: TaskStatus) -> None:
        """Ask for something else after what was proposed has failed."""
        self._think(lambda given_up: self._front.propose_anew(failed, given_up))

    def answer(self, question: OpenQuestion, line: str) -> None:
        """Take the answer to what was asked."""
        if self._meant is None:
            self._about.append((question.text, line))
            self._understand()
            return
        match understood_answer(line, question.choices):
            case Chosen(0):
                meant, self._meant = self._meant, None
                self._take(meant)
            case Chosen() | Withdrawn():
                self.give_up()
                self._take(GaveUp())
            case unclear:
                self._ask(OpenQuestion(question.text, question.choices, unclear.message))

    def give_up(self) -> None:
        """Wait for nothing any more."""
        self._thought = self._meant = None

    def _understand(self) -> None:
        line, about = self._line, tuple(self._about)
        self._think(lambda given_up: self._front.understand(line, about, given_up))

    def _think(self, call: Callable[[GivenUp], Meaning | None]) -> None:
        thought = self._thought = object()

        def given_up() -> bool:
            return self._thought is not thought

        def understood(meaning: Meaning | None) -> None:
            if not given_up():
                self._thought = None
                self._settle(meaning)

        self._aside.do(lambda: call(given_up), understood, lambda reason: understood(NotMeant(reason)))

    def _settle(self, meaning: Meaning | None) -> None:
        match meaning:
            case Meant(read_back=read_back) if read_back:
                self._meant = meaning
                self._ask(OpenQuestion(read_back, _YES_OR_NO))
            case AskBack(text, choices):
                self._ask(OpenQuestion(text, choices))
            case NotMeant(reason):
                self._take(GaveUp(reason))
            case _:
                self._take(meaning)
