"""Settings of nodes as the text of an attribute: numbers, words, gazes, judgements.

Compound values are joined by ";", as BehaviorTree.CPP's own converters do. A judgement (a function that
tells from a failure what to do) is written as ``module:name``, and read only from packages that hold trees.
"""

from __future__ import annotations

import importlib
import inspect
import math
import types
import typing
from collections.abc import Callable, Sequence
from dataclasses import fields, is_dataclass
from enum import Enum
from typing import Any

from trees.extensions import extensions

_OWN_PACKAGE = "trees"


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
    if is_dataclass(value) and not isinstance(value, type):
        return ";".join(to_text(getattr(value, field.name)) for field in fields(value))
    if isinstance(value, frozenset):
        return ";".join(sorted(map(to_text, value)))
    if isinstance(value, Sequence):
        return ";".join(map(to_text, value))
    if isinstance(value, types.FunctionType):
        return _function_name(value)
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
        return _function(text, arguments)
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


def _function_name(function: types.FunctionType) -> str:
    if "<" in function.__qualname__ or "." in function.__qualname__:
        raise ValueError(f"{function.__qualname__} has no name of its own: make it a function of a module")
    return f"{function.__module__}:{function.__name__}"


def _function(text: str, arguments: tuple[Any, ...]) -> Any:
    """A judgement by its name: nothing but functions of the right form, from where trees come from."""
    module, _, name = text.partition(":")
    known = {_OWN_PACKAGE, *extensions().packages}
    if module.partition(".")[0] not in known or not name.isidentifier():
        raise ValueError(f"{text!r} is no judgement of {', '.join(sorted(known))}")
    try:
        found = getattr(importlib.import_module(module), name, None)
    except ImportError:
        found = None
    wanted, answer = arguments
    if not isinstance(found, types.FunctionType) or found.__module__ != module:
        raise ValueError(f"there is no judgement {text!r}")
    hints = typing.get_type_hints(found)
    taken = [hints.get(one) for one in inspect.signature(found).parameters]
    if taken != list(wanted) or hints.get("return") is not answer:
        raise ValueError(f"{text!r} judges something else")
    return found
