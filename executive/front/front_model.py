"""The language model in front: from free speech to a proposal that is parsed, grounded and read back.

It speaks to no person, moves nothing and opens no connection: whoever has it puts its questions, and what
asks the server is given to it.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from typing import Any, Protocol

from executive.front.grounding import ungrounded
from executive.front.model_settings import ModelSettings
from executive.front.prompt import messages
from executive.front.proposal import Asked, Context, ModelFailure, ModelFailureKind, Proposed
from executive.front.said_words import SaidWords
from executive.front.trap_words import traps_in
from executive.language.explain.refusals import printable
from executive.meaning import StopCommand, command_json, shortened
from executive.reports.meaning_words import meaning_words
from executive.trust import USUAL_TRUST, Trust
from executive.understanding.strict_output import AnswerShapeError, StrictAnswer, read_strict_answer
from executive.understanding.understanding import Understood, is_model_output, understand

Waiting = Callable[[], bool]
"""Lets a moment pass while an answer is waited for; True when nobody waits for it any more."""

_LONGEST_QUESTION = 200


class Asker(Protocol):
    """Whoever asks the server."""

    def ask(self, messages: Sequence[Mapping[str, str]], waiting: Waiting) -> str | ModelFailure:
        """The text of the model's answer, within the time and size that are allowed, or why there is none.

        Args:
            messages: Role and content of each.
            waiting: Called again and again meanwhile.
        """
        ...


class FrontModel:
    """One language model in front of the parser.

    Args:
        settings: Which model, and when it is asked.
        asker: Asks its server.
        trust: How far its confidences are trusted.
        reads_back: Whether everything is read back, or only what must be.
    """

    def __init__(
        self, settings: ModelSettings, asker: Asker, trust: Trust = USUAL_TRUST, reads_back: bool = True
    ) -> None:
        self.settings, self.reads_back = settings, reads_back
        self._asker, self._trust = asker, trust

    def takes(self, text: str, understood: Understood) -> bool:
        """Whether a sentence is one for the model: never a stop, nor what is a model's output already.

        Args:
            text: What was said.
            understood: What the parser makes of it.
        """
        commands = understood.parsed.commands
        if is_model_output(text) or any(isinstance(one, StopCommand) for one in commands):
            return False
        return self.settings.when == "always" or understood.parsed.refusal is not None

    def understand(self, text: str, context: Context, waiting: Waiting) -> Proposed | Asked | ModelFailure:
        """Have the model say what is meant.

        Args:
            text: What the person said.
            context: What is known beside it.
            waiting: Called again and again while the answer is waited for.
        """
        answer = self._asker.ask(messages(text, context), waiting)
        if isinstance(answer, ModelFailure):
            return self._named(answer)
        return self._named(self.judged(answer, text, context))

    def judged(self, answer: str, text: str, context: Context) -> Proposed | Asked | ModelFailure:
        """What a model's answer comes to.

        Args:
            answer: What the model said; untrusted.
            text: What the person said.
            context: What is known beside it.
        """
        try:
            read = read_strict_answer(answer)
        except AnswerShapeError as wrong:
            return ModelFailure.of(ModelFailureKind.MALFORMED, printable(shortened(str(wrong))))
        if read.question:
            return Asked(f"the model asks: {printable(read.question[:_LONGEST_QUESTION])}")
        document = json.dumps(read.document)
        found = understand(document, self._trust)
        if found.parsed.refusal is not None:
            return ModelFailure.of(ModelFailureKind.NOT_VALID, printable(str(found.parsed.refusal)))
        if any(one["proposed"] == document for one in context.failures):
            return ModelFailure.of(ModelFailureKind.REPEATED)
        return self._proposed(found, read, document, text, context)

    def _proposed(
        self, found: Understood, read: StrictAnswer, document: str, text: str, context: Context
    ) -> Proposed:
        confirmed = found.if_confirmed or found
        commands, sources = confirmed.parsed.commands, confirmed.provenance
        answers = [said for _, said in context.answers]
        doubts = [f"you said {word!r}" for word in traps_in(" ".join([text, *answers]))]
        said = SaidWords([text, *answers])
        pairs = list(zip(commands, sources, strict=True))
        doubts += [f"you did not say {printable(word)!r}" for word in ungrounded(pairs, read.sentences, said)]
        least = self._trust.threshold
        unsure = {one.step: one.confidence for one in sources if one.confidence < least}
        doubts += [
            f"step {step + 1} has confidence {confidence:.2f}, below {least:.2f}"
            for step, confidence in sorted(unsure.items())
        ]
        means = ", then ".join(meaning_words(command_json(one)) for one in commands)
        left_out = [f"left out: {printable(step.text)!r} ({step.reason})" for step in confirmed.skipped]
        read_back = "; ".join([f"I understood: {printable(means)}", *doubts, *left_out, "shall I?"])
        return Proposed(confirmed, document, read_back, bool(doubts))

    def _named(self, answer: Proposed | Asked | ModelFailure) -> Proposed | Asked | ModelFailure:
        if isinstance(answer, ModelFailure):
            return ModelFailure(answer.kind, f"the model {self.settings.name!r}: {answer.reason}")
        return answer


def failure_told(failure: Any) -> Mapping[str, Any]:
    """A failure chain as the model is told it: kind, place, message and numbers of each link."""
    told: Mapping[str, Any] = failure.to_json()
    return told
