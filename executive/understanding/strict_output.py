"""The published schema in a form for strict structured output, and the reading of what comes in it.

Servers that hold a model to a schema take a subset of JSON schema: one object at the root, every property
required, nothing additional, no bounds, patterns or defaults. What is absent is null there.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from executive.understanding.model_output import model_output_schema
from executive.understanding.understanding import without_fence
from executive.understanding.untrusted_json import UntrustedJsonError, read_json

NAME = "steps_for_the_robot"
"""What the form is called where a server wants a name."""

_KEPT = frozenset({"type", "enum", "const", "description", "properties", "items", "anyOf", "$ref"})
_NOT_STEPS = frozenset({"Steps"})
_CALLS = frozenset({"tool_calls", "function", "function_call", "arguments", "input", "parameters"})


class AnswerShapeError(Exception):
    """An answer of another form; the message says where and why."""


@dataclass(frozen=True, slots=True)
class StrictAnswer:
    """What a model answered.

    Attributes:
        document: The steps as ``read_model_output`` takes them.
        sentences: The sentences among the steps, by their index.
        question: What the model asks the person; empty where it gives steps.
    """

    document: Any
    sentences: Mapping[int, str]
    question: str


def strict_output_schema() -> dict[str, Any]:
    """The schema that a model's server is given."""
    published = model_output_schema()
    defs = {name: _strict(schema) for name, schema in published["$defs"].items() if name not in _NOT_STEPS}
    for schema in defs.values():
        if "confidence" in schema["properties"]:
            schema["properties"]["confidence"] = {"type": "number", "description": "From 0 to 1."}
    steps = [{"$ref": f"#/$defs/{name}"} for name in defs if _is_step(defs[name])]
    return {
        "type": "object",
        "description": "Steps for the robot, or a question to the person.",
        "properties": {
            "steps": {"type": "array", "items": {"anyOf": steps}},
            "question": {
                "anyOf": [{"type": "string"}, {"type": "null"}],
                "description": "Asked where there are no steps; null otherwise.",
            },
        },
        "required": ["steps", "question"],
        "additionalProperties": False,
        "$defs": defs,
    }


def _is_step(schema: Mapping[str, Any]) -> bool:
    return "confidence" in schema["properties"]


def _strict(schema: Mapping[str, Any]) -> dict[str, Any]:
    """One schema in the subset; an optional property may be null instead."""
    if "$ref" in schema:
        return {"$ref": schema["$ref"]}
    made = {key: value for key, value in schema.items() if key in _KEPT}
    if "items" in made:
        made["items"] = _strict(made["items"])
    branches = schema.get("anyOf", schema.get("oneOf"))
    if branches is not None:
        made["anyOf"] = [_strict(branch) for branch in branches]
    if "properties" in made:
        required = schema.get("required", ())
        made["properties"] = {
            name: _strict(value) if name in required else _nullable(_strict(value))
            for name, value in made["properties"].items()
        }
        made |= {"required": list(made["properties"]), "additionalProperties": False}
    return made


def _nullable(schema: dict[str, Any]) -> dict[str, Any]:
    branches = schema.get("anyOf", [schema])
    null = {"type": "null"}
    return {"anyOf": branches if null in branches else [*branches, null]}


def read_strict_answer(text: str) -> StrictAnswer:
    """Read what a model answered: the strict form, or any document of the published schema.

    Args:
        text: What it answered; untrusted.

    Raises:
        AnswerShapeError: It is not JSON, calls a tool, or holds nothing to be done and no question.
    """
    try:
        document = read_json(without_fence(text.strip()))
    except UntrustedJsonError as wrong:
        raise AnswerShapeError(str(wrong)) from wrong
    question: Any = None
    if isinstance(document, dict):
        question = document.pop("question", None)
        if question is not None and not isinstance(question, str):
            raise AnswerShapeError("question: must be a text or null")
    document = _without_nulls(document)
    steps = _steps_of(document)
    if any(isinstance(step, dict) and _CALLS & set(step) for step in steps):
        raise AnswerShapeError("it calls a tool, and none was offered")
    question = (question or "").strip()
    if steps and question:
        raise AnswerShapeError("it gives steps and asks a question as well")
    if not steps and not question:
        raise AnswerShapeError("it holds neither steps nor a question")
    return StrictAnswer(document, dict(_sentences(steps)), question)


def _steps_of(document: Any) -> list[Any]:
    steps = document
    if isinstance(document, dict):
        steps = document.get("steps", [document] if document else [])
    if not isinstance(steps, list):
        raise AnswerShapeError("it must be an object with 'steps', a list")
    return steps


def _sentences(steps: list[Any]) -> list[tuple[int, str]]:
    found = []
    for index, step in enumerate(steps):
        sentence = step if isinstance(step, str) else step.get("command") if isinstance(step, dict) else None
        if isinstance(sentence, str):
            found.append((index, sentence))
    return found


def _without_nulls(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _without_nulls(item) for key, item in value.items() if item is not None}
    return [_without_nulls(item) for item in value] if isinstance(value, list) else value
