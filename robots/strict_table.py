"""Tables of a TOML file as models: read strictly, and refused with the key and a reason for people.

A file's layout is declared once, as classes that derive from ``StrictTable``; pydantic reads it. What it
finds wrong is told in the words of who writes the file: where, what is there, what was expected, and the
nearest word that there is.
"""

from __future__ import annotations

import difflib
import re
from collections.abc import Callable, Collection, Mapping
from dataclasses import MISSING, fields, is_dataclass
from functools import partial
from types import UnionType
from typing import Annotated, Any, Self, TypeVar, Union, get_args, get_origin, get_type_hints

from pydantic import (
    AfterValidator,
    BaseModel,
    BeforeValidator,
    ConfigDict,
    FiniteFloat,
    GetCoreSchemaHandler,
    ValidationError,
    create_model,
    model_validator,
)
from pydantic_core import CoreSchema, ErrorDetails, PydanticCustomError
from pydantic_core.core_schema import no_info_after_validator_function

_UNKNOWN_KEY = "unknown_key"
_SAID = "said"
"""Types of the errors that are made here; the others are pydantic's."""


def said(reason: str) -> PydanticCustomError:
    """An error whose reason is already in words for people; a validator raises it."""
    return PydanticCustomError(_SAID, "{reason}", {"reason": reason})


def said_of(key: str, reason: str) -> PydanticCustomError:
    """The same of a key of the table that is validated."""
    return PydanticCustomError(_SAID, "{reason}", {"reason": reason, "key": key})


def _not_blank(text: str) -> str:
    if not text.strip():
        raise said(f"must be a text in quotes, not {text!r}")
    return text


def as_tuple(value: Any, count: int) -> tuple[Any, ...]:
    """A list of so many numbers as a tuple; what validators call before the numbers are read."""
    if isinstance(value, tuple):  # a default, or a value that was made by a program
        return value
    if not isinstance(value, list) or len(value) != count:
        raise said(f"must be a list of {count} numbers, not {value!r}")
    return tuple(value)


def _as_texts(value: Any) -> Any:
    if isinstance(value, tuple):
        return value
    if not isinstance(value, list) or not all(isinstance(one, str) and one.strip() for one in value):
        raise said(f'must be a list of texts, ["tomato soup"], not {value!r}')
    return tuple(value)


def _as_places(value: Any) -> Any:
    if isinstance(value, tuple):
        return value
    if not isinstance(value, list) or not all(isinstance(one, list) and len(one) == 2 for one in value):
        raise said(f"must be a list of places, [[1.0, 0.0], [2.0, 0.5]], not {value!r}")
    return tuple(map(tuple, value))


TAG = "="
"""What the tag of a table among several begins with; it is no part of a key."""

Text = Annotated[str, AfterValidator(_not_blank)]
"""A text that is not blank."""
Texts = Annotated[tuple[str, ...], BeforeValidator(_as_texts)]
"""A list of texts, none of them blank."""
Pair = Annotated[tuple[FiniteFloat, FiniteFloat], BeforeValidator(partial(as_tuple, count=2))]
Triple = Annotated[tuple[FiniteFloat, FiniteFloat, FiniteFloat], BeforeValidator(partial(as_tuple, count=3))]


class StrictTable(BaseModel):
    """A table with declared keys; numbers are finite, and nothing but whole numbers is converted."""

    model_config = ConfigDict(strict=True, extra="allow", allow_inf_nan=False, frozen=True, defer_build=True)

    @model_validator(mode="before")
    @classmethod
    def _misspelled(cls, data: Any) -> Any:
        """Refuse unknown keys here where one is nearly a key that is not there: else that one is missing."""
        unknown = [key for key in data if key not in cls._keys()] if isinstance(data, dict) else []
        absent = [key for key in cls._keys() if key not in data] if unknown else []
        if any(difflib.get_close_matches(key, absent, n=1) for key in unknown):
            raise cls._unknown(unknown[0])
        return data

    @model_validator(mode="after")
    def _known_keys(self) -> Self:
        """Refuse the first key that is not declared."""
        for key in self.model_extra or ():
            raise self._unknown(key)
        return self

    @classmethod
    def _keys(cls) -> list[str]:
        return [field.alias or name for name, field in cls.model_fields.items()]

    @classmethod
    def _unknown(cls, key: str) -> PydanticCustomError:
        return PydanticCustomError(_UNKNOWN_KEY, "unknown key", {"key": key, "known": cls._keys()})


class AsTable:
    """Reads a table into the dataclass beside which it stands: ``Annotated[Person, AsTable()]``.

    Of a tuple of dataclasses one table holds the fields of all.
    """

    def __init__(self, **defaults: Any) -> None:
        """Prepare.

        Args:
            defaults: Of fields that a file may leave out though the dataclass has no default for them.
        """
        self._defaults = defaults

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        """What pydantic asks for: the table's own schema, then the dataclass of what was read."""
        several = get_origin(source) is tuple
        kinds = get_args(source) if several else (source,)
        declared: dict[str, Any] = {}
        for kind in kinds:
            hints = get_type_hints(kind)
            for field in fields(kind):
                default = self._defaults.get(field.name, ... if field.default is MISSING else field.default)
                declared[field.name] = (_readable(hints[field.name]), default)
        model = create_model(kinds[0].__name__, __base__=StrictTable, **declared)

        def value(table: StrictTable) -> Any:
            made = [
                kind(**{field.name: getattr(table, field.name) for field in fields(kind)}) for kind in kinds
            ]
            return tuple(made) if several else made[0]

        return no_info_after_validator_function(value, handler.generate_schema(model))


def _readable(hint: Any) -> Any:
    """A field's type as a file has it: texts are not blank, lists are tuples, tables are dataclasses."""
    if hint is str:
        return Text
    if is_dataclass(hint):
        return Annotated[hint, AsTable()]
    if get_origin(hint) is UnionType:
        return Union[tuple(map(_readable, get_args(hint)))]  # noqa: UP007  (made of values)
    if hint == tuple[str, ...]:
        return Texts
    if hint == tuple[tuple[float, float], ...]:
        return Annotated[hint, BeforeValidator(_as_places)]
    if get_origin(hint) is tuple and Ellipsis not in get_args(hint):
        return Annotated[hint, BeforeValidator(partial(as_tuple, count=len(get_args(hint))))]
    return hint


Model = TypeVar("Model", bound=StrictTable)


def read_table(kind: type[Model], data: Mapping[str, Any], fail: Callable[[str, str], Exception]) -> Model:
    """Read a table.

    Args:
        kind: What it holds.
        data: The table, as ``tomllib`` gives it.
        fail: Makes the error that is raised, of a key (``object[0].radius_m``; empty for the table itself)
            and a reason.

    Raises:
        Exception: What ``fail`` makes of the first thing that is wrong.
    """
    try:
        return kind.model_validate(data)
    except ValidationError as wrong:
        problem = wrong.errors(include_url=False)[0]
    raise fail(*_told(problem, data))


def _told(problem: ErrorDetails, data: Any) -> tuple[str, str]:
    """Key and reason of a problem."""
    key, given = _key(problem["loc"], data), problem["input"]
    name, context = key.rpartition(".")[2], problem.get("ctx", {})
    match problem["type"]:
        case "unknown_key":
            return _below(
                key, context["key"]
            ), f"unknown key; {_instead_of(context['key'], context['known'])}"
        case "missing":
            return key, "is missing"
        case "union_tag_not_found":
            return _below(key, "kind"), "is missing"
        case "union_tag_invalid" if isinstance(given["kind"], str) and given["kind"].strip():
            return _below(key, "kind"), unknown_word("kind", given["kind"], _words(context))
        case "union_tag_invalid":
            return _below(key, "kind"), f"must be a text in quotes, not {given['kind']!r}"
        case "literal_error" if isinstance(given, str) and given.strip():
            return key, unknown_word(name, given, _words(context))
        case "said":
            return (_below(key, context["key"]) if "key" in context else key), problem["msg"]
        case "literal_error":
            return key, f"must be one of {', '.join(_words(context))}, not {given!r}"
        case "greater_than":
            return key, f"must be above {context['gt']:g}, not {given!r}"
        case "greater_than_equal":
            return key, f"must be {context['ge']:g} or more, not {given!r}"
        case "list_type" | "too_short":
            return key, f"must be a list of tables: write [[{key}]]"
    return key, _EXPECTED[problem["type"]].format(given) if problem["type"] in _EXPECTED else problem["msg"]


_EXPECTED = {
    "float_type": "must be a number, not {!r}",
    "int_type": "must be a whole number, not {!r}",
    "finite_number": "must be finite, not {!r}",
    "string_type": "must be a text in quotes, not {!r}",
    "bool_type": "must be true or false, not {!r}",
    "model_type": "must be a table",
    "model_attributes_type": "must be a table",
    "dict_type": "must be a table",
}


def _key(loc: tuple[int | str, ...], data: Any) -> str:
    """A place as people write it; the words that tell kinds of tables apart are left out."""
    key = ""
    for part in loc:
        if isinstance(part, str) and (
            part[:1] == TAG or (isinstance(data, dict) and part == data.get("kind"))
        ):
            continue
        key = f"{key}[{part}]" if isinstance(part, int) else _below(key, part)
        try:
            data = data[part]
        except (KeyError, IndexError, TypeError):
            data = None
    return key


def _below(key: str, name: str) -> str:
    return f"{key}.{name}" if key else name


def _words(context: Mapping[str, Any]) -> list[str]:
    return re.findall(r"'([^']*)'", context.get("expected_tags") or context["expected"])


def unknown_word(what: str, word: str, known: Collection[str]) -> str:
    """What is wrong with a word that is none of those that are known."""
    return f"unknown {what} {word!r}; {_instead_of(word, known)}"


def _instead_of(word: str, known: Collection[str]) -> str:
    near = (difflib.get_close_matches(word, sorted(known), n=1, cutoff=0.0) or sorted(known))[0]
    return f"the nearest is {near!r}, all: {', '.join(known)}"
