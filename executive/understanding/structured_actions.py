"""Actions as a model may send them: the slots of the command-line contract, validated.

The pydantic models are made from the task types themselves, so that a task that gains a slot gains it here
as well.
"""

from __future__ import annotations

from contextlib import suppress
from dataclasses import MISSING, fields, replace
from functools import lru_cache, reduce
from operator import or_
from types import NoneType, UnionType
from typing import Annotated, Any, Literal, Self, TypeVar, Union, get_args, get_origin, get_type_hints

from pydantic import (
    AfterValidator,
    BaseModel,
    ConfigDict,
    Field,
    StringConstraints,
    create_model,
    model_validator,
)

from executive.language.text.tokens import invisible_in
from executive.meaning import Command, StopCommand
from trees.registry import skills
from trees.tasks import UNSAID, ObjectDescription, ObjectOf, Relation, RelationKind, Task

MAX_COUNT = 20
LARGEST = 1000.0
"""No number of any slot is larger: metres, seconds, metres a second."""

_VISIBLE = r"^[^\x00-\x1f\x7f-\x9f\u00ad\u061c\u200b-\u200f\u2028-\u202e\u2060-\u206f\ufeff\ufff9-\ufffb]+$"
"""For the published schema, which cannot name them all: the reader refuses whatever sentences refuse."""


def _visible(text: str) -> str:
    code = invisible_in(text)
    if code is not None:
        raise ValueError(f"it holds the invisible character {code}")
    return text


_Seen = (AfterValidator(_visible), Field(json_schema_extra={"pattern": _VISIBLE}))
Word = Annotated[str, StringConstraints(min_length=1, max_length=60), *_Seen]
Speech = Annotated[str, StringConstraints(min_length=1, max_length=300), *_Seen]
Confidence = Annotated[float, Field(ge=0.0, le=1.0, description="How sure the model is of this step.")]
Number = Annotated[float, Field(ge=-LARGEST, le=LARGEST)]
Whole = Annotated[int, Field(ge=1, le=MAX_COUNT)]


class Strict(BaseModel):
    """Base of a model's structured output: nothing is converted or added, every number is finite."""

    model_config = ConfigDict(extra="forbid", strict=True, allow_inf_nan=False, frozen=True)


class Reference(Strict):
    """The object of an earlier task: "it"."""

    ref: Annotated[int, Field(ge=0, le=100)]


class ObjectSlots(Strict):
    """Which object is meant; absent slots say nothing, and one at least must be there."""

    model_config = ConfigDict(json_schema_extra={"minProperties": 1})

    kind: Word | None = None
    color: Word | None = None
    name: Word | None = None
    size: Word | None = None
    material: Word | None = None
    ordinal: Word | None = None
    relation: RelationSlots | None = None
    traits: Annotated[list[Word], Field(max_length=5)] | None = None

    @model_validator(mode="after")
    def _says_something(self) -> Self:
        if not self.model_fields_set:
            raise ValueError("an object without any slot says nothing")
        return self


class RelationSlots(Strict):
    """Where something is, relative to something else; left and right are the robot's."""

    model_config = ConfigDict(populate_by_name=False)

    kind: RelationKind = Field(alias="is")
    to: ObjectSlots | Reference | Word


ObjectSlots.model_rebuild()

_ALIASES = {"source": "from", "words": "text"}
_TYPES: dict[Any, Any] = {
    ObjectDescription: ObjectSlots,
    ObjectOf: Reference,
    Relation: RelationSlots,
    str: Word,
    float: Number,
    int: Whole,
}

T = TypeVar("T")


@lru_cache(maxsize=1)
def action_models() -> dict[str, type[Strict]]:
    """The model of each action, by its name."""
    models = {}
    for action, skill in skills().items():
        with suppress(KeyError):  # an installed skill may have slots that no JSON is known for
            models[action] = _model_of(skill.task)
    models["stop"] = _made("StopAction", {"action": (Literal["stop"], ...)})
    return models


def command_of(step: BaseModel) -> Command:
    """The command that a validated step means; its text names it in plain words."""
    action = str(getattr(step, "action"))  # noqa: B009 - the class is made at run time
    if action == "stop":
        return StopCommand("stop")
    kind = skills()[action].task
    said = [field.name for field in fields(kind) if field.name != "text" and UNSAID not in field.metadata]
    slots = {name: _plain(getattr(step, name)) for name in said}
    task: Task = kind(text="", **{key: value for key, value in slots.items() if value is not None})
    return replace(task, text=_words(action, slots))


def _words(action: str, slots: dict[str, Any]) -> str:
    said = [
        f"{key.replace('source', 'from')} {value}" for key, value in slots.items() if value not in (None, 1)
    ]
    return " ".join([action.replace("_", " "), *said])[:200]


def _plain(value: Any) -> Any:
    match value:
        case Reference():
            return ObjectOf(value.ref)
        case RelationSlots():
            return Relation(value.kind, _plain(value.to))
        case ObjectSlots():
            slots = {name: _plain(getattr(value, name)) for name in type(value).model_fields}
            return ObjectDescription(**{**slots, "traits": tuple(value.traits or ())})
        case _:
            return value


def _model_of(kind: Any) -> type[Strict]:
    hints = get_type_hints(kind)
    slots: dict[str, Any] = {"action": (Literal[kind.action], ...)}
    for field in fields(kind):
        if field.name == "text" or UNSAID in field.metadata:
            continue
        made = Speech if field.name == "words" else _translated(hints[field.name])
        alias = _ALIASES.get(field.name)
        default = ... if field.default is MISSING else field.default
        slots[field.name] = (made, Field(default, alias=alias) if alias else default)
    name = "".join(part.title() for part in kind.action.split("_")) + "Action"
    return _made(name, slots, (kind.__doc__ or "").split("\n")[0])


def _made(name: str, slots: dict[str, Any], doc: str | None = None) -> type[Strict]:
    return create_model(name, __base__=Strict, __doc__=doc, confidence=(Confidence | None, None), **slots)


def _translated(hint: Any) -> Any:
    if get_origin(hint) in (Union, UnionType):
        return reduce(or_, (_translated(part) for part in get_args(hint)))
    if hint is NoneType or get_origin(hint) is Literal:
        return hint
    return _TYPES[hint]
