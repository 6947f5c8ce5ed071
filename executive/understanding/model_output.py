"""What a language model may send: one command, or steps, each with its confidence.

    {"command": "pick up the red cup", "confidence": 0.93}
    {"steps": ["pick up the red cup", {"action": "go_home"}], "confidence": 0.9}
    [{"command": "go home", "confidence": 0.99}, {"action": "wait", "duration_s": 2.0, "confidence": 0.9}]

A step is a sentence or an action with the slots of the command-line contract. A step without a confidence of
its own has that of the document; without either it is refused. The schema is
docs/reference/model_output.schema.json.
Tool calls are taken as well, see ``tool_calls``.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from json import JSONDecodeError
from typing import Annotated, Any, Union

from pydantic import Field, RootModel, StringConstraints, TypeAdapter, ValidationError

from executive.language.explain.refusals import printable
from executive.meaning import Command
from executive.understanding.structured_actions import Confidence, Strict, action_models, command_of
from executive.understanding.tool_calls import SURE, ToolCallError, steps_of_calls
from executive.understanding.untrusted_json import UntrustedJsonError, read_json

MAX_STEPS = 20
MAX_SENTENCE = 500
EXPECTED = (
    'expected is one JSON value and nothing around it: {"command": "go home", "confidence": 0.9}, '
    '{"steps": [...], "confidence": 0.9}, a list of steps, or a tool call '
    '{"name": "go_home", "arguments": {}}'
)
"""What is told to whoever sends something of another shape."""
_STEP_KEYS = ("command", "action")

Sentence = Annotated[str, StringConstraints(min_length=1, max_length=MAX_SENTENCE)]


class SentenceStep(Strict):
    """A step in plain language."""

    command: Sentence
    confidence: Confidence | None = None


@dataclass(frozen=True, slots=True)
class ModelStep:
    """One step, validated.

    Attributes:
        content: A sentence, or the command of a structured action.
        confidence: In [0, 1].
    """

    content: str | Command
    confidence: float


class ModelOutputError(Exception):
    """A text that is no valid output; the message says where and why."""


def read_model_output(text: str) -> list[ModelStep]:
    """Validate what a model sent.

    Raises:
        ModelOutputError: It is not JSON, or does not fit the schema.
    """
    try:
        document = read_json(text)
    except UntrustedJsonError as wrong:
        no_json = isinstance(wrong.__cause__, JSONDecodeError)
        raise ModelOutputError(f"{wrong}; {EXPECTED}" if no_json else str(wrong)) from wrong
    try:
        calls = steps_of_calls(document)
    except ToolCallError as wrong:
        raise ModelOutputError(str(wrong)) from wrong
    if calls is not None:
        _check_count(len(calls))
        return [_step(item, place, SURE) for place, item in calls]
    usual: float | None = None
    if isinstance(document, dict) and "steps" in document:
        extra = sorted(set(document) - {"steps", "confidence"})
        if extra:
            raise ModelOutputError(f"unknown key {extra[0][:40]!r} beside 'steps'")
        if document.get("confidence") is not None:
            usual = _validated(Confidence, document["confidence"], "confidence")
        steps, place = document["steps"], "steps"
    elif isinstance(document, dict):
        steps, place = [document], ""
    else:
        steps, place = document, ""
    if not isinstance(steps, list):
        raise ModelOutputError(
            f"it must be an object with 'command' or 'steps', or a list of steps; {EXPECTED}"
        )
    _check_count(len(steps))
    alone = isinstance(document, dict) and not place
    if alone and not any(key in document for key in _STEP_KEYS):
        raise ModelOutputError(f"it has neither 'command' nor 'action' nor 'steps'; {EXPECTED}")
    return [_step(item, "" if alone else f"{place}[{i}]", usual) for i, item in enumerate(steps)]


def _check_count(count: int) -> None:
    if not 1 <= count <= MAX_STEPS:
        raise ModelOutputError(f"it has {count} steps; 1 to {MAX_STEPS} are taken")


def _step(item: Any, place: str, usual: float | None) -> ModelStep:
    if isinstance(item, str):
        item = {"command": item}
    if not isinstance(item, dict):
        raise ModelOutputError(f"{place or 'it'} must be a sentence, or an object with 'command' or 'action'")
    if "action" in item:
        model = action_models().get(item["action"]) if isinstance(item["action"], str) else None
        if model is None:
            known = ", ".join(sorted(action_models()))
            raise ModelOutputError(
                f"{place}.action: {str(item['action'])[:40]!r} is none of {known}".lstrip(".")
            )
    else:
        model = SentenceStep
    step = _validated(model, item, place)
    confidence = usual if step.confidence is None else step.confidence
    if confidence is None:
        raise ModelOutputError(f"{place}.confidence is missing".lstrip("."))
    content = step.command if isinstance(step, SentenceStep) else command_of(step)
    return ModelStep(content, confidence)


def _validated(kind: Any, value: Any, place: str) -> Any:
    try:
        return _adapter(kind).validate_python(value)
    except ValidationError as wrong:
        first = wrong.errors(include_url=False, include_input=False)[0]
        where = ".".join([*([place] if place else []), *map(str, _shown(first["loc"]))])
        why = first["msg"].removeprefix("Value error, ")
        raise ModelOutputError(f"{where}: {why}" if where else why) from wrong


def _shown(loc: Sequence[int | str]) -> list[str]:
    """A place without the names of pydantic's branches."""
    return [printable(str(part)) for part in loc if not str(part)[:1].isupper() and "[" not in str(part)]


@lru_cache(maxsize=64)
def _adapter(kind: Any) -> TypeAdapter[Any]:
    return TypeAdapter(kind)


def model_output_schema() -> dict[str, Any]:
    """The JSON schema of what a model is asked for; tool calls have their own, the provider's."""
    action: Any = Annotated[Union[tuple(action_models().values())], Field(discriminator="action")]  # noqa: UP007
    step: Any = SentenceStep | action
    steps_: Any = Annotated[list[step | Sentence], Field(min_length=1, max_length=MAX_STEPS)]

    class Steps(Strict):
        """Several steps; ``confidence`` holds for those without one of their own."""

        steps: steps_
        confidence: Confidence | None = None

    class ModelOutput(RootModel[Any]):
        """What a language model may send to the executive."""

        root: SentenceStep | action | Steps | steps_

    schema = ModelOutput.model_json_schema(by_alias=True)
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", **schema}
