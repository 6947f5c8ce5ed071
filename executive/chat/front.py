"""What stands between a person's words and the robot: somebody who may understand more than its parser does.

A language model is one. Whatever it proposes is read back to the person before anything is begun.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Protocol

from executive.doors.served_robot import TaskStatus

GivenUp = Callable[[], bool]
"""Whether nobody waits for an answer any more."""


@dataclass(frozen=True, slots=True)
class Meant:
    """What a person's words are taken to mean.

    Attributes:
        order: A sentence, or a model's steps, as the robot takes it.
        read_back: What was understood, to be confirmed before anything is begun; empty where the words are
            the person's own.
    """

    order: str
    read_back: str = ""


@dataclass(frozen=True, slots=True)
class AskBack:
    """What has to be known before; an answer is understood together with what was said before."""

    text: str
    choices: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class NotMeant:
    """Nothing was understood, and nothing moves; the reason is for people."""

    reason: str


Meaning = Meant | AskBack | NotMeant


class Front(Protocol):
    """Understands what a person says; may take its time, and is asked beside the conversation."""

    def understand(self, text: str, answers: Sequence[tuple[str, str]], given_up: GivenUp) -> Meaning:
        """Understand a line.

        Args:
            text: What was typed.
            answers: Its own questions about it so far, each with what was answered, the oldest first.
            given_up: Asked again and again while it takes its time.
        """
        ...

    def propose_anew(self, failed: TaskStatus, given_up: GivenUp) -> Meaning | None:
        """Propose something else after the last proposal has failed; None where there is nothing to propose.

        Args:
            failed: What became of it.
            given_up: As above.
        """
        ...
