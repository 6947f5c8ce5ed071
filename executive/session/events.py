"""Everything that is told while commands are carried out: the layers' events and the session's own.

All are frozen values. The digest is taken over their canonical JSON; none holds a wall-clock time, so
that the same run gives the same digest. The hub passes each event on to whoever listens at the time.
"""

from __future__ import annotations

import dataclasses
import hashlib
import json
import math
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from enum import Enum
from typing import Any

from executive.session.lifecycle import LifecycleChanged
from robots.control.events import ControlEvent
from trees.events import TreeEvent
from trees.failures import Failure, Number


@dataclass(frozen=True, slots=True)
class TaskAccepted:
    """A task begins."""

    t_s: float
    text: str
    meaning: Mapping[str, Any]


@dataclass(frozen=True, slots=True)
class TaskRefused:
    """A text was not turned into a task; nothing moved for it."""

    t_s: float
    text: str
    message: str
    word: str | None


@dataclass(frozen=True, slots=True)
class QuestionAsked:
    """Something must be known before anything moves."""

    t_s: float
    text: str
    question: str
    choices: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class InputTaken:
    """Somebody's input took effect: an answer, a cancel, an emergency stop, a reset, a person's word.

    Together with what was asked for, the seed and the scene these make a run repeatable.

    Attributes:
        t_s: Simulated time at which it took effect.
        what: "answer", "cancel", "take_over", "jog", ...
        value: The answer's words, the reason of a cancel, what a person who jogs said, as text; "" for a
            question that nobody answered.
    """

    t_s: float
    what: str
    value: str


@dataclass(frozen=True, slots=True)
class TaskEnded:
    """A task ended, with what was measured or why it failed."""

    t_s: float
    text: str
    outcome: str
    attempts: int
    failure: Failure | None
    evidence: Mapping[str, Number]


@dataclass(frozen=True, slots=True)
class PlanningAnswered:
    """A planning job was answered; in simulated time the answer may be used from ``ready_s`` on."""

    t_s: float
    ready_s: float
    request: str
    answer: str


@dataclass(frozen=True, slots=True)
class SensorsNoted:
    """What the robot's sensors said, as a hash: two runs that differ anywhere differ here."""

    t_s: float
    sha256: str


SessionEvent = (
    TaskAccepted
    | TaskRefused
    | QuestionAsked
    | InputTaken
    | TaskEnded
    | PlanningAnswered
    | SensorsNoted
    | LifecycleChanged
)
Event = SessionEvent | TreeEvent | ControlEvent
EventSink = Callable[[Event], None]


def event_json(event: Event) -> dict[str, Any]:
    """An event as JSON values, its class name under "event"."""
    return {"event": type(event).__name__, **_fields(event)}


def canonical_line(event: Event) -> str:
    """One line that is the same for equal events: keys sorted, no spaces, shortest exact numbers."""
    return json.dumps(event_json(event), sort_keys=True, separators=(",", ":"), allow_nan=False)


class EventDigest:
    """SHA-256 over the canonical lines of the events so far."""

    def __init__(self) -> None:
        self._hash = hashlib.sha256()

    def add(self, event: Event) -> None:
        """Take one more event in."""
        self._hash.update(canonical_line(event).encode() + b"\n")

    def hexdigest(self) -> str:
        """The digest of everything added."""
        return self._hash.hexdigest()


def _fields(value: Any) -> dict[str, Any]:
    return {field.name: plain(getattr(value, field.name)) for field in dataclasses.fields(value)}


def plain(value: Any) -> Any:
    """Turn a value into what JSON has: enums to their values, arrays to lists, odd floats to words."""
    if isinstance(value, Failure):
        return plain(value.to_json())
    if dataclasses.is_dataclass(value) and not isinstance(value, type):
        return _fields(value)
    if isinstance(value, Enum):
        return plain(value.value)
    if isinstance(value, Mapping):
        return {str(key): plain(item) for key, item in value.items()}
    if isinstance(value, (list, tuple, set, frozenset)):
        items = sorted(value, key=str) if isinstance(value, (set, frozenset)) else value
        return [plain(item) for item in items]
    if isinstance(value, float):
        return float(value) if math.isfinite(value) else str(float(value))
    if value is None or isinstance(value, (bool, int, str)):
        return value
    if hasattr(value, "tolist"):
        return plain(value.tolist())
    return str(value)


class EventHub:
    """Passes each event to its sink, and to whoever listens at the time."""

    def __init__(self, sink: EventSink) -> None:
        self._sink = sink
        self._listeners: list[EventSink] = []

    def __call__(self, event: Event) -> None:
        """Take an event."""
        self._sink(event)
        for listener in self._listeners:
            listener(event)

    def listen(self, listener: EventSink) -> None:
        """Have every event told to a listener as well, from now on."""
        self._listeners.append(listener)

    @contextmanager
    def heard_by(self, listener: EventSink) -> Iterator[None]:
        """Have every event told to a listener as well."""
        self._listeners.append(listener)
        try:
            yield
        finally:
            self._listeners.remove(listener)
