"""The definition of a ROS 2 message as text, made from the class that is written.

Readers of MCAP decode by the text that stands in the file, so that text and bytes have one source.
"""

from __future__ import annotations

from dataclasses import fields
from functools import cache
from typing import Annotated, Any, cast, get_args, get_origin, get_type_hints

from cyclonedds.idl import IdlStruct
from cyclonedds.idl.types import array, sequence

_SEPARATOR = "=" * 80
_BYTES = frozenset({("diagnostic_msgs/DiagnosticStatus", "level")})
"""Fields that ROS calls ``byte`` and the wire does not tell from ``uint8``."""


Message = IdlStruct
"""Any message of ROS 2."""


@cache
def definition_of(kind: type[IdlStruct]) -> tuple[str, str]:
    """Name and definition of a message, with the definitions of what is in it below.

    Args:
        kind: Its class.

    Returns:
        The name, as "sensor_msgs/msg/JointState", and the text of a ``.msg`` file.
    """
    parts: dict[str, str] = {}
    _define(kind, parts)
    (_, own), *others = parts.items()
    below = (f"{_SEPARATOR}\nMSG: {name}\n{text}" for name, text in others)
    package, _, name = _short(kind).partition("/")
    return f"{package}/msg/{name}", "".join([own, *below])


def _define(kind: type[IdlStruct], parts: dict[str, str]) -> None:
    """Add the fields of a message, then those of what is in it."""
    name, hints = _short(kind), get_type_hints(kind, include_extras=True)
    if name in parts:
        return
    inside: list[type[IdlStruct]] = []
    lines = []
    for one in fields(cast(Any, kind)):
        word = "byte" if (name, one.name) in _BYTES else _word(hints[one.name], inside)
        lines.append(f"{word} {one.name}\n")
    parts[name] = "".join(lines)
    for other in inside:
        _define(other, parts)


def _word(hint: Any, inside: list[type[IdlStruct]]) -> str:
    """How a definition says a type; notes messages that are in it."""
    if get_origin(hint) is Annotated:
        told = get_args(hint)[1]
        if isinstance(told, sequence):
            return f"{_word(told.subtype, inside)}[]"
        if isinstance(told, array):
            return f"{_word(told.subtype, inside)}[{told.length}]"
        return str(told)
    if hint is str:
        return "string"
    if hint is bool:
        return "bool"
    inside.append(hint)
    return _short(hint)


def _short(kind: type[IdlStruct]) -> str:
    """The name without the folder: "std_msgs/Header"."""
    return kind.__idl_typename__.replace(".msg.dds_.", "/")[:-1]
