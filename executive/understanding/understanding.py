"""What somebody asks for: a sentence, or a model's output with its confidences.

Nothing below the threshold is carried out unasked. Policy "ask" puts one question for all steps, policy
"partial" leaves out the steps below the threshold, and those that refer to them.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from executive.language.resolve.guards import harm_in
from executive.meaning import Command, Parsed, Question, Refusal
from executive.references import references, with_references
from executive.trust import USUAL_TRUST, Trust
from executive.understanding.command_parser import parse
from executive.understanding.provenance import Provenance
from robots.toml_text import BYTE_ORDER_MARK
from trees.tasks import FindTask, ObjectOf

if TYPE_CHECKING:
    from executive.understanding.model_output import ModelStep


_BEGINS_JSON = re.compile(r"""\s*(\{|\[\s*([\[\]{"]|$))""")
_LONGEST_FENCED = 65_536
_FENCED = re.compile(r"\s*```(json)?[ \t]*\n(?P<inside>[^`]*)\n?[ \t]*```\s*", re.IGNORECASE)
_FENCE_WITHIN = re.compile(r"```(?:json)?[ \t]*\n?\s*[\[{]", re.IGNORECASE)
_JSON_WITHIN = re.compile(r"""\{\s*"\w{1,40}"\s*:""")


@dataclass(frozen=True, slots=True)
class SkippedStep:
    """A step of a model's output that is left out, and why."""

    text: str
    provenance: Provenance
    reason: str


@dataclass(frozen=True, slots=True)
class Understood:
    """What a text was understood as.

    Attributes:
        parsed: Commands, a question or a refusal.
        provenance: Where each command comes from; empty for a sentence of a person.
        skipped: What is left out of a model's output.
        if_confirmed: What holds when the question, about low confidence, is answered by yes.
    """

    parsed: Parsed
    provenance: tuple[Provenance, ...] = ()
    skipped: tuple[SkippedStep, ...] = ()
    if_confirmed: Understood | None = None


@dataclass(frozen=True, slots=True)
class _Part:
    """One command of a step."""

    command: Command
    provenance: Provenance


def is_model_output(text: str) -> bool:
    """Tell whether a text is meant as JSON: by how it begins, which is not how "[1] wave" does."""
    return _BEGINS_JSON.match(without_fence(text.removeprefix(BYTE_ORDER_MARK))) is not None


def understand(text: str, trust: Trust = USUAL_TRUST) -> Understood:
    """Understand a sentence or a model's output. It is untrusted: any string gives an answer."""
    text = text.removeprefix(BYTE_ORDER_MARK)
    if not is_model_output(text):
        return _sentence(text)
    from executive.understanding.model_output import ModelOutputError, read_model_output

    try:
        steps = read_model_output(without_fence(text))
    except ModelOutputError as wrong:
        return Understood(Parsed(text, refusal=Refusal(f"the model's output is not valid: {wrong}")))
    parts = _parts(text, steps)
    if isinstance(parts, Parsed):
        return Understood(parts)
    doubtful = {i for i, step in enumerate(steps) if step.confidence < trust.threshold}
    if not doubtful:
        return _of(text, parts)
    if trust.policy == "partial" and len(doubtful) < len(steps):
        return _partial(text, parts, doubtful, trust)
    shown = "; ".join(
        f"step {i + 1}, {_said(steps[i])!r}, has confidence {steps[i].confidence:.2f}"
        for i in sorted(doubtful)
    )
    question = Question(f"{shown}, below {trust.threshold:.2f}: shall it be done?", ("yes", "no"))
    return Understood(Parsed(text, question=question), if_confirmed=_of(text, parts))


def _sentence(text: str) -> Understood:
    """A sentence; JSON with words around it is none, and is never taken for what the words alone say."""
    parsed = None if _FENCE_WITHIN.search(text) else parse(text)
    if parsed is None or (not parsed.commands and _JSON_WITHIN.search(text)):
        from executive.understanding.model_output import EXPECTED

        return Understood(
            Parsed(text, refusal=Refusal(f"there are words around the model's output; {EXPECTED}"))
        )
    return Understood(parsed)


def without_fence(text: str) -> str:
    """A text without the marks that models put around JSON; any other text as it is."""
    fenced = _FENCED.fullmatch(text) if len(text) <= _LONGEST_FENCED else None
    return text if fenced is None else fenced.group("inside")


def _of(text: str, parts: Sequence[_Part], skipped: tuple[SkippedStep, ...] = ()) -> Understood:
    parsed = Parsed(text, commands=tuple(part.command for part in parts))
    return Understood(parsed, tuple(part.provenance for part in parts), skipped)


def _said(step: ModelStep) -> str:
    return step.content[:60] if isinstance(step.content, str) else step.content.text[:60]


def _parts(text: str, steps: Sequence[ModelStep]) -> list[_Part] | Parsed:
    """The commands of all steps, with references counted over all of them; or why there are none."""
    from executive.understanding.canonical_words import checked_command

    parts: list[_Part] = []
    said: list[str] = []
    for i, step in enumerate(steps):
        if isinstance(step.content, str):
            source = Provenance(i, step.confidence, "sentence")
            commands = _commands(step.content, said, len(parts))
            if isinstance(commands, Parsed):
                return _with_place(text, i, commands)
            parts += [_Part(command, source) for command in commands]
            said.append(step.content)
            continue
        checked = checked_command(step.content)
        if isinstance(checked, Refusal):
            return Parsed(text, refusal=replace(checked, message=f"step {i + 1}: {checked.message}"))
        parts.append(_Part(checked, Provenance(i, step.confidence, "action")))
        said.clear()  # a sentence after it cannot lean on the sentences before
    for index, part in enumerate(parts):
        wrong = sorted(ref for ref in references(part.command) if ref >= index)
        if wrong:
            message = f"step {part.provenance.step + 1}: ref {wrong[0]} is no earlier task"
            return Parsed(text, refusal=Refusal(message, str(wrong[0])))
    harm = harm_in([part.command for part in parts])
    if harm is not None:  # of all steps together: one alone does not know what "it" is
        return Parsed(text, refusal=Refusal(harm.message, harm.word))
    return parts


def _commands(sentence: str, said: Sequence[str], before: int) -> tuple[Command, ...] | Parsed:
    """A step's commands; a step that leans on earlier ones ("put it down") is read after them."""
    alone = parse(sentence)
    if alone.commands:
        return tuple(_shifted(command, before) for command in alone.commands)
    earlier, leaning = read_after(sentence, said)
    if leaning:
        return tuple(_shifted(command, before - len(earlier)) for command in leaning)
    return alone


def read_after(sentence: str, said: Sequence[str]) -> tuple[tuple[Command, ...], tuple[Command, ...]]:
    """The commands of some sentences, and those of one that leans on them: "put it down".

    References count from the first command of the first sentence. Of what cannot be read so there are none.
    """
    if not said:
        return (), ()
    earlier, whole = _parsed_together(said), _parsed_together([*said, sentence])
    count = len(earlier.commands)
    alike = [command.action for command in whole.commands[:count]] == [
        command.action for command in earlier.commands
    ]
    if not count or not alike:
        return (), ()
    return whole.commands[:count], whole.commands[count:]


def asked_after(sentence: str, said: Sequence[str]) -> Question | None:
    """What a sentence leaves open of several things that others look for: "the first one"."""
    earlier = _parsed_together(said).commands if said else ()
    several = any(isinstance(command, FindTask) and command.count != 1 for command in earlier)
    return _parsed_together([*said, sentence]).question if several else None


def _parsed_together(sentences: Sequence[str]) -> Parsed:
    return parse(", then ".join(sentences), remembers=True)


def _with_place(text: str, step: int, parsed: Parsed) -> Parsed:
    if parsed.refusal is not None:
        message = f"step {step + 1}: {parsed.refusal.message}"
        return Parsed(text, refusal=replace(parsed.refusal, message=message))
    asked = parsed.question.text if parsed.question is not None else ""
    return Parsed(text, refusal=Refusal(f"step {step + 1} is not clear: {asked}"))


def _partial(text: str, parts: Sequence[_Part], doubtful: set[int], trust: Trust) -> Understood:
    """Leave out the doubtful steps and what refers to them; the rest keeps its references."""
    kept: list[_Part] = []
    skipped: list[SkippedStep] = []
    place: dict[int, int] = {}
    for index, part in enumerate(parts):
        confidence = part.provenance.confidence
        if part.provenance.step in doubtful:
            reason = f"confidence {confidence:.2f} is below {trust.threshold:.2f}"
        elif not references(part.command) <= place.keys():
            reason = "it refers to a step that is left out"
        else:
            place[index] = len(kept)
            kept.append(
                _Part(with_references(part.command, lambda old: ObjectOf(place[old])), part.provenance)
            )
            continue
        skipped.append(SkippedStep(part.command.text, part.provenance, reason))
    if not kept:
        told = Question("no step is left to be carried out; shall all be done?", ("yes", "no"))
        return Understood(Parsed(text, question=told), if_confirmed=_of(text, parts))
    return _of(text, kept, tuple(skipped))


def _shifted(command: Command, by: int) -> Command:
    return with_references(command, lambda index: ObjectOf(index + by))
