"""The one place that drives a generator of steps: a session's task, an errand, questions about words.

Whatever is carried out here is written as a generator: it yields None after each tick and a question where
one is open, takes the question's answer (None when there is none), and returns its result.
"""

from __future__ import annotations

from collections.abc import Callable, Generator
from typing import Generic, TypeVar, cast

Q = TypeVar("Q")
R = TypeVar("R")


class Driver(Generic[Q, R]):
    """Lets steps go on, one after the other, for somebody who does other things in between.

    Args:
        steps: What is carried out; whoever makes a driver for it leaves the driving to that.

    Attributes:
        question: The question that holds the steps, or None.
        done: Whether they have ended, with a result or with an exception.
    """

    def __init__(self, steps: Generator[Q | None, str | None, R]) -> None:
        self._steps = steps
        self._answer: str | None = None
        self._result: R | None = None
        self._defect: BaseException | None = None
        self.question: Q | None = None
        self.done = False

    @property
    def result(self) -> R:
        """What the steps have returned.

        Raises:
            RuntimeError: They have not ended yet.
            BaseException: What they raised, where they ended so.
        """
        if not self.done:
            raise RuntimeError("there is no result before the end")
        if self._defect is not None:
            raise self._defect
        return cast(R, self._result)

    def answer(self, text: str | None) -> None:
        """Answer the open question; None leaves it unanswered.

        Raises:
            RuntimeError: No question is open.
        """
        if self.question is None:
            raise RuntimeError("no question is open")
        self._answer, self.question = text, None

    def advance(self) -> bool:
        """Go on by one step; False when they have ended, or wait for an answer.

        Raises:
            BaseException: What the step raises; the steps have ended then.
        """
        if self.done or self.question is not None:
            return False
        answer, self._answer = self._answer, None
        try:
            self.question = self._steps.send(answer)
        except StopIteration as end:
            self.done, self._result = True, end.value
        except BaseException as defect:
            self.done, self._defect = True, defect
            raise
        return not self.done


def _nobody(_question: object) -> str | None:
    return None


def _nothing() -> None:
    pass


def driven(
    steps: Generator[Q | None, str | None, R],
    answer: Callable[[Q], str | None] = _nobody,
    between: Callable[[], object] = _nothing,
) -> R:
    """Let steps go on to their end, and return what they return.

    Args:
        steps: What is carried out.
        answer: Answers a question, or leaves it open with None; nobody does when left out.
        between: Called after each step that was no question.
    """
    driver: Driver[Q, R] = Driver(steps)
    while driver.advance():
        if driver.question is None:
            between()
        else:
            driver.answer(answer(driver.question))
    return driver.result
