"""What comes of asking a language model: a proposal, a question to the person, or a typed failure."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from enum import Enum
from typing import Any

from executive.understanding.understanding import Understood


@dataclass(frozen=True, slots=True)
class Context:
    """What a model is told beside the sentence; all of it is data, and none of it an instruction.

    Attributes:
        seen: What is believed to be around the robot, each thing as JSON values.
        failures: What was tried for this sentence and failed, the oldest first: proposal and failure chain.
        answers: What the person was asked and answered, the oldest first.
    """

    seen: tuple[Mapping[str, Any], ...] = ()
    failures: tuple[Mapping[str, Any], ...] = ()
    answers: tuple[tuple[str, str], ...] = ()

    def answering(self, question: str, answer: str) -> Context:
        """The same, with one more answer of the person."""
        return replace(self, answers=(*self.answers, (question, answer)))

    def failing(self, proposal: str, failure: Mapping[str, Any]) -> Context:
        """The same, with one more proposal that failed."""
        tried = {"proposed": proposal, "failure": failure}
        return replace(self, failures=(*self.failures, tried))


@dataclass(frozen=True, slots=True)
class Proposed:
    """Something that may be done once the person has said so.

    Attributes:
        understood: The commands, parsed and grounded.
        document: The model's output that they come from; ``understand`` and a served robot's desk take it.
        read_back: What the person is asked: "I understood: pick up the red cup; shall I?"
        must_ask: Whether it is asked even of somebody who wants no read-back.
    """

    understood: Understood
    document: str
    read_back: str
    must_ask: bool


@dataclass(frozen=True, slots=True)
class Asked:
    """Something has to be known first; ``understand`` again, with the answer in the context.

    Attributes:
        question: What the person is asked.
        choices: What may be answered; other words may be, too.
        document: What was proposed, to be judged again with the answer; empty where the model itself asks.
    """

    question: str
    choices: tuple[str, ...] = ()
    document: str = ""


class ModelFailureKind(Enum):
    """Why nothing came of asking a model; the value is said to people."""

    UNREACHABLE = "the server cannot be reached"
    TIMEOUT = "no answer came in time"
    RATE_LIMITED = "the server takes no more requests for now"
    DENIED = "the server does not let us in"
    SERVER_ERROR = "the server answered with an error"
    OVERSIZED = "the answer is too long to be read"
    MALFORMED = "the answer is not of the form that was asked for"
    DECLINED = "the model declined"
    NOT_VALID = "what the model proposes is refused"
    REPEATED = "the model proposes again what has failed"
    CANCELLED = "nobody waits for the answer any more"


@dataclass(frozen=True, slots=True)
class ModelFailure:
    """Nothing came of asking a model; nothing moves.

    Attributes:
        kind: What sort of failure.
        reason: One line for people, the kind's words in it.
    """

    kind: ModelFailureKind
    reason: str

    @classmethod
    def of(cls, kind: ModelFailureKind, detail: str = "") -> ModelFailure:
        """A failure with what is known beyond its kind."""
        return cls(kind, f"{kind.value}: {detail}" if detail else kind.value)
