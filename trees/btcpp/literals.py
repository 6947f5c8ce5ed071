"""Settings of nodes as the text of an attribute: numbers, words, gazes, judgements.

Compound values are joined by ";", as BehaviorTree.CPP's own converters do. A judgement (a function that
tells from a failure what to do) is written by its name.
"""

from __future__ import annotations

import math
import types
import typing
from collections.abc import Callable, Sequence
from dataclasses import fields, is_dataclass
from enum import Enum
from typing import Any

from trees.btcpp.judgement_names import judgement_called, name_of
from trees.nodes.judgements import Judgement


def to_text(value: Any) -> str:
    """Write a value.

    Raises:
        ValueError: Such a value cannot be written, or not so that it could be read again.
    """
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, Enum):
        return value.name
    if isinstance(value, int):
        return str(value)
    if isinstance(value, float):
        return repr(value)
    if isinstance(value, str):
        if ";" in value or value.startswith("{"):
            raise ValueError(f"{value!r} cannot be told from a list or a reference")
        return value
    if isinstance(value, Judgement):
        return name_of(value)
    if is_dataclass(value) and not isinstance(value, type):
        return ";".join(to_text(getattr(value, field.name)) for field in fields(value))
    if isinstance(value, frozenset):
        return ";".join(sorted(map(to_text, value)))
    if isinstance(value, Sequence):
        return ";".join(map(to_text, value))
    if isinstance(value, types.FunctionType):
        raise ValueError(f"the function {value.__qualname__} has no name: declare it with @judgement")
    raise ValueError(f"a {type(value).__name__} cannot be written")


def from_text(text: str, hint: Any) -> Any:
    """Read a value of a type.

    Raises:
        ValueError: The text is none, or there is no reading values of the type.
    """
    origin, arguments = typing.get_origin(hint), typing.get_args(hint)
    if origin in (typing.Union, types.UnionType):
        return from_text(text, next(one for one in arguments if one is not types.NoneType))
    if hint is bool:
        if text not in ("true", "false"):
            raise ValueError(f"must be true or false, not {text!r}")
        return text == "true"
    if hint is int:
        return int(text)
    if hint is float:
        number = float(text)
        if not math.isfinite(number):
            raise ValueError(f"must be finite, not {text!r}")
        return number
    if hint is str:
        return text
    if origin is typing.Literal:
        if text not in arguments:
            raise ValueError(f"must be one of {', '.join(map(str, arguments))}, not {text!r}")
        return text
    if isinstance(hint, type) and issubclass(hint, Enum):
        if text not in hint.__members__:
            raise ValueError(f"must be one of {', '.join(hint.__members__)}, not {text!r}")
        return hint[text]
    if isinstance(hint, type) and is_dataclass(hint):
        return _compound(text, hint)
    if origin is frozenset:
        return frozenset(from_text(part, arguments[0]) for part in text.split(";"))
    if origin is tuple or (isinstance(origin, type) and issubclass(origin, Sequence)):
        return tuple(from_text(part, arguments[0]) for part in text.split(";"))
    if origin is not None and origin is typing.get_origin(Callable[[], None]):
        return _judgement(text, arguments[0])
    raise ValueError(f"a value of {hint} cannot be read")


def type_name(hint: Any) -> str:
    """A type as the model of a node names it."""
    if typing.get_origin(hint) is typing.get_origin(Callable[[], None]):
        return "judgement"
    if typing.get_origin(hint) is typing.Literal:
        return " or ".join(map(str, typing.get_args(hint)))
    plain = (
        "list" if typing.get_origin(hint) in (frozenset, tuple, Sequence) else getattr(hint, "__name__", None)
    )
    arguments = [type_name(one) for one in typing.get_args(hint) if one not in (types.NoneType, ...)]
    if typing.get_origin(hint) in (typing.Union, types.UnionType):
        return " or ".join(arguments)
    return f"{plain or hint} of {arguments[0]}" if arguments else str(plain or hint)


def _compound(text: str, hint: type[Any]) -> Any:
    parts, kinds = text.split(";"), typing.get_type_hints(hint)
    names = [field.name for field in fields(hint)]
    if len(parts) > len(names):
        raise ValueError(f"must be {';'.join(names)}, not {text!r}")
    return hint(**{name: from_text(part, kinds[name]) for name, part in zip(names, parts, strict=False)})


def _judgement(text: str, takes: Sequence[Any]) -> Judgement[...]:
    found = judgement_called(text, takes)
    if found.takes != tuple(takes):
        judges, asked = (", ".join(map(type_name, one)) for one in (found.takes, takes))
        raise ValueError(f"{found.name!r} judges {judges}; here {asked} is to be judged")
    return found
