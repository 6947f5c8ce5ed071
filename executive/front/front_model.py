"""The language model in front: from free speech to a proposal that is parsed, grounded and read back.

It speaks to no person, moves nothing and opens no connection: whoever has it puts its questions, and what
asks the server is given to it.
"""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from typing import Any, Protocol

from executive.front.grounding import ungrounded
from executive.front.model_settings import ModelSettings
from executive.front.prompt import messages
from executive.front.proposal import Asked, Context, ModelFailure, ModelFailureKind, Proposed
from executive.front.said_actions import actions_said
from executive.front.said_words import SaidWords
from executive.front.trap_words import traps_in
from executive.language.explain.refusals import printable
from executive.meaning import Command, StopCommand, command_json
from executive.reports.meaning_words import meaning_words
from executive.trust import USUAL_TRUST, Trust
from executive.understanding.strict_output import AnswerShapeError, StrictAnswer, read_strict_answer
from executive.understanding.understanding import Understood, is_model_output, understand

Waiting = Callable[[], bool]
"""Lets a moment pass while an answer is waited for; True when nobody waits for it any more."""

_LONGEST_SHOWN = 200


class Asker(Protocol):
    """Whoever asks the server."""

    def ask(self, messages: Sequence[Mapping[str, str]], waiting: Waiting) -> str | ModelFailure:
        """The text of the model's answer, within the time and size that are allowed, or why there is none.

        Args:
            messages: Role and content of each.
            waiting: Called again and again meanwhile.
        """
        ...

    def close(self) -> None:
        """Let go of what is needed to ask."""
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

    def header(self) -> dict[str, Any]:
        """What the record of a run tells of it, as JSON values."""
        settings = self.settings
        return {
            "name": settings.name,
            "url": settings.url,
            "model": settings.model,
            "when": settings.when,
            "attempts": settings.attempts,
            "reads_back": self.reads_back,
        }

    def close(self) -> None:
        """Let go of what is needed to ask; it may be asked again all the same."""
        self._asker.close()

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
        return self.judged(self.ask(text, context, waiting), text, context)

    def ask(self, text: str, context: Context, waiting: Waiting) -> str | ModelFailure:
        """The model's answer as it is, or why there is none; arguments as of ``understand``."""
        return self._asker.ask(messages(text, context), waiting)

    def judged(
        self, answer: str | ModelFailure, text: str, context: Context
    ) -> Proposed | Asked | ModelFailure:
        """What a model's answer comes to.

        Args:
            answer: What the model said; untrusted.
            text: What the person said.
            context: What is known beside it.
        """
        found = answer if isinstance(answer, ModelFailure) else self._judged(answer, text, context)
        if isinstance(found, ModelFailure):
            return ModelFailure(found.kind, f"the model {self.settings.name!r}: {found.reason}")
        return found

    def _judged(self, answer: str, text: str, context: Context) -> Proposed | Asked | ModelFailure:
        try:
            read = read_strict_answer(answer)
        except AnswerShapeError as wrong:
            return ModelFailure.of(ModelFailureKind.MALFORMED, shown(str(wrong)))
        if read.question:
            return Asked(f"the model asks: {shown(read.question)}")
        document = json.dumps(read.document)
        found = understand(document, self._trust)
        if found.parsed.refusal is not None:
            return ModelFailure.of(ModelFailureKind.NOT_VALID, shown(str(found.parsed.refusal)))
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
        unsaid = [repr(shown(word)) for word in ungrounded(pairs, read.sentences, said)]
        if unsaid:
            doubts.append(f"you did not say {', '.join(unsaid)}")
        doubts += _repeated(commands)
        if not self.reads_back and (others := _other_actions(commands, " ".join([text, *answers]))):
            doubts.append(f"you said other words than those for: {', '.join(others)}")
        least = self._trust.threshold
        unsure = {one.step: one.confidence for one in sources if one.confidence < least}
        doubts += [
            f"step {step + 1} has confidence {confidence:.2f}, below {least:.2f}"
            for step, confidence in sorted(unsure.items())
        ]
        means = ", then ".join(meaning_words(command_json(one)) for one in commands)
        left_out = [f"left out: {shown(step.text)!r} ({step.reason})" for step in confirmed.skipped]
        read_back = "; ".join(
            [f"I understood: {printable(means, len(means))}", *doubts, *left_out, "shall I?"]
        )
        return Proposed(confirmed, document, read_back, bool(doubts))


def _repeated(commands: Sequence[Command]) -> list[str]:
    """What is to be done several times over: a model that goes round in circles."""
    means = Counter(meaning_words(command_json(one)) for one in commands)
    return [f"{shown(words)!r} comes {count} times" for words, count in means.items() if count > 1]


def _other_actions(commands: Sequence[Command], text: str) -> list[str]:
    """Actions that the verbs of a text do not mean, where it has verbs of commands at all."""
    meant = actions_said(text)
    others = dict.fromkeys(one.action.replace("_", " ") for one in commands if one.action not in meant)
    return list(others) if meant else []


def shown(text: str) -> str:
    """Somebody's text as it may be shown: the beginning of a long one, without what steers a terminal."""
    return printable(text, _LONGEST_SHOWN)
