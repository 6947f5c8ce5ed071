"""What crosses the sockets: JSON objects with a ``type``, read strictly into frozen values.

Whatever is missing, unknown, of another type, not finite or too large is a ``ProtocolError``: there is
no message that is half understood. ``docs/reference/live-protocol.md`` lists them all.
"""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from dataclasses import MISSING, dataclass, fields
from typing import Any

from robots.live.wire.errors import ProtocolError

_MAX_TEXT = 20_000
"""Characters of one text; a sentence may be long before it is refused for what it says."""
_MAX_INTEGER = 2**53
_ROLES = ("commander", "observer")


@dataclass(frozen=True, slots=True)
class Hello:
    """The first message of whoever wants more than to stop: what it wants to be."""

    role: str


@dataclass(frozen=True, slots=True)
class Heartbeat:
    """A tick of the commander.

    ``busy``: a task is under way; ``looking``: it wants pictures; ``ranging``: it wants range scans.
    """

    number: int
    stamp_s: float
    busy: bool
    looking: bool
    ranging: bool
    world_version: int


@dataclass(frozen=True, slots=True)
class Admit:
    """A trajectory to be checked again; the head of a document frame, the document follows."""

    number: int
    stamp_s: float
    trajectory: int
    world_version: int


@dataclass(frozen=True, slots=True)
class Start:
    """Stream an admitted trajectory as a motion of this id."""

    number: int
    stamp_s: float
    motion: int
    trajectory: int


@dataclass(frozen=True, slots=True)
class Guarded:
    """Begin a guarded motion that the control side makes: its name, the hand, and how far that opens, m.

    At 0 it opens as far as it goes.
    """

    number: int
    stamp_s: float
    motion: int
    name: str
    hand: str
    opening_m: float


@dataclass(frozen=True, slots=True)
class Lead:
    """Begin a yielding hand; the head of a document frame, its order follows."""

    number: int
    stamp_s: float
    motion: int
    world_version: int


@dataclass(frozen=True, slots=True)
class BeginJog:
    """Begin to be jogged by a person; the head of a document frame, what is around follows."""

    number: int
    stamp_s: float
    motion: int
    world_version: int


@dataclass(frozen=True, slots=True)
class Walk:
    """Set out; the head of a document frame, where to follows."""

    number: int
    stamp_s: float
    motion: int


@dataclass(frozen=True, slots=True)
class Steer:
    """Go somewhere else with a walk, or be jogged on; the head of a document frame, how follows."""

    number: int
    stamp_s: float
    motion: int


@dataclass(frozen=True, slots=True)
class FinishMotion:
    """Bring a walk, a yielding hand or jogging to its end; never too late."""

    number: int
    motion: int


@dataclass(frozen=True, slots=True)
class CancelMotion:
    """Brake one motion and hold; never too late."""

    number: int
    motion: int
    reason: str


@dataclass(frozen=True, slots=True)
class Pause:
    """Hold what is under way where it is, until ``Resume``; never too late."""

    number: int
    reason: str


@dataclass(frozen=True, slots=True)
class Resume:
    """Go on with what was paused."""

    number: int
    stamp_s: float


@dataclass(frozen=True, slots=True)
class Offer:
    """What a hand has is held out to somebody from now on, who may take it. Nothing moves by it."""

    number: int
    person: str


@dataclass(frozen=True, slots=True)
class Stop:
    """The emergency stop, from anybody, at any time; it latches."""

    category: int
    reason: str


@dataclass(frozen=True, slots=True)
class Reset:
    """A person's command to leave the emergency stop."""

    person: str


@dataclass(frozen=True, slots=True)
class GetStatus:
    """How do things stand?"""


@dataclass(frozen=True, slots=True)
class Shutdown:
    """End it, once the robot is at rest."""


Headed = Admit | Lead | BeginJog | Walk | Steer
"""What comes with a document; as a message of its own it is none."""

ControlMessage = (
    Hello
    | Heartbeat
    | Headed
    | Start
    | Guarded
    | FinishMotion
    | CancelMotion
    | Pause
    | Resume
    | Offer
    | Stop
    | Reset
    | GetStatus
    | Shutdown
)
_CONTROL: Mapping[str, type] = {
    "hello": Hello,
    "heartbeat": Heartbeat,
    "admit": Admit,
    "start": Start,
    "guarded": Guarded,
    "lead": Lead,
    "jog": BeginJog,
    "walk": Walk,
    "steer": Steer,
    "finish": FinishMotion,
    "cancel": CancelMotion,
    "pause": Pause,
    "resume": Resume,
    "offer": Offer,
    "stop": Stop,
    "reset": Reset,
    "status": GetStatus,
    "shutdown": Shutdown,
}
_NAMES = {kind: name for name, kind in _CONTROL.items()}


def read_control_message(payload: bytes) -> ControlMessage:
    """One message to the control process.

    Raises:
        ProtocolError: It is none.
    """
    document = read_object(payload)
    message = strictly(_CONTROL, document)
    match message:
        case Hello(role=role) if role not in _ROLES:
            raise ProtocolError(f"hello: no role {role[:40]!r}; there are {' and '.join(_ROLES)}")
        case Stop(category=category) if category not in (0, 1, 2):
            raise ProtocolError(f"stop: no category {category}; there are 0, 1 and 2")
        case _:
            return message  # type: ignore[no-any-return]


def write_control_message(message: ControlMessage) -> bytes:
    """The payload of a message to the control process."""
    values = {field.name: getattr(message, field.name) for field in fields(message)}
    return write_message(_NAMES[type(message)], **values)


def write_message(kind: str, **values: Any) -> bytes:
    """The payload of any message."""
    return json.dumps({"type": kind, **values}, separators=(",", ":"), allow_nan=False).encode()


def read_object(payload: bytes) -> dict[str, Any]:
    """The JSON object of a payload.

    Raises:
        ProtocolError: It is none, or has no type.
    """
    try:
        document = json.loads(payload, parse_constant=_no_constant, object_pairs_hook=_no_doubles)
    except ProtocolError:
        raise
    except RecursionError:
        raise ProtocolError("a message is nested too deeply") from None
    except ValueError:
        raise ProtocolError("a message is no JSON") from None
    if not isinstance(document, dict) or not isinstance(document.get("type"), str):
        raise ProtocolError("a message is an object with a type")
    return document


def strictly(kinds: Mapping[str, type], document: Mapping[str, Any]) -> Any:
    """The value of the class that a document's type names.

    Args:
        kinds: Type to frozen dataclass; its fields are int, float, str or bool.
        document: The message.

    Raises:
        ProtocolError: No such type; a field is missing, unknown or of another type.
    """
    name = document["type"]
    kind = kinds.get(name)
    if kind is None:
        raise ProtocolError(f"no message {name[:40]!r}; there are {', '.join(kinds)}")
    wanted = {field.name: field for field in fields(kind)}
    for key in document:
        if key != "type" and key not in wanted:
            raise ProtocolError(f"{name}: unknown field {key[:40]!r}")
    values: dict[str, Any] = {}
    for key, field in wanted.items():
        if key in document:
            values[key] = _value(name, key, str(field.type), document[key])
        elif field.default is MISSING:
            raise ProtocolError(f"{name}: {key!r} is missing")
    return kind(**values)


def _value(name: str, key: str, wanted: str, value: Any) -> Any:
    fine = False
    match wanted:
        case "bool":
            fine = isinstance(value, bool)
        case "int":
            fine = type(value) is int and -_MAX_INTEGER <= value <= _MAX_INTEGER
        case "float":
            fine = type(value) in (int, float) and abs(value) <= _MAX_INTEGER and math.isfinite(value)
        case "str":
            fine = isinstance(value, str) and len(value) <= _MAX_TEXT and value.isprintable()
    if not fine:
        raise ProtocolError(f"{name}: {key!r} must be a {wanted} of a sensible size")
    return float(value) if wanted == "float" else value


def _no_constant(_name: str) -> Any:
    raise ProtocolError("a message holds a number that is not finite")


def _no_doubles(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    table = dict(pairs)
    if len(table) < len(pairs):
        raise ProtocolError("a message has a key twice")
    return table
