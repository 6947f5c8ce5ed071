"""What the page shows at one moment, gathered from what the robot and its executive tell."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal

Level = Literal["info", "said", "warning", "error", "alarm"]

_LEVELS: Mapping[str, Level] = {
    "Said": "said",
    "QuestionAsked": "said",
    "NotSo": "info",
    "LeafFailed": "warning",
    "SetpointRefused": "warning",
    "MotionPaused": "warning",
    "StopStarted": "warning",
    "HealthChanged": "warning",
    "ResetRefused": "warning",
    "TaskRefused": "error",
    "EmergencyStopped": "alarm",
}

_OUTCOMES: Mapping[str, Level] = {
    "done": "info",
    "question": "warning",
    "cancelled": "warning",
    "refused": "error",
    "failed": "error",
}


@dataclass(frozen=True, slots=True)
class LogLine:
    """One line of the log.

    Attributes:
        t_s: Control time.
        text: For people.
        level: How much it matters.
    """

    t_s: float
    text: str
    level: Level = "info"


@dataclass(frozen=True, slots=True)
class Seen:
    """Everything that the page tells in words.

    Attributes:
        robot, scene: Their names.
        t_s: Control time.
        state: Of the robot: "NORMAL", "EMERGENCY".
        emergency: Why the emergency stop is engaged; empty while it is not.
        task: What is under way, or None.
        paused: Whether it is held.
        question: What is asked, with its choices, or None.
        nodes: Of the tree under way, or of the last one, the root first, with their depths.
        log: Lines, the newest last.
        failure: The newest failure of a task as its JSON, or None.
        evidence: What the last task measured.
        complaint: What keeps the page from being up to date, or nothing.
    """

    robot: str = ""
    scene: str = ""
    t_s: float = 0.0
    state: str = ""
    emergency: str = ""
    task: str | None = None
    paused: bool = False
    question: Mapping[str, Any] | None = None
    nodes: Sequence[Mapping[str, Any]] = ()
    log: tuple[LogLine, ...] = ()
    failure: Mapping[str, Any] | None = None
    evidence: Mapping[str, Any] | None = None
    complaint: str = ""


def log_line(told: Mapping[str, Any], line: str | None) -> LogLine | None:
    """The line of an event; None where it has nothing for people.

    Args:
        told: The event as JSON.
        line: Its line for people.
    """
    kind, t_s = str(told.get("event", "")), float(told.get("t_s", 0.0))
    if kind == "NodeChanged" or not line:
        return None
    return LogLine(t_s, line, _LEVELS.get(kind, "info"))


def result_line(text: str, t_s: float) -> LogLine | None:
    """The line of an order that has ended; None for what is told of it on the way, which the events tell.

    Args:
        text: What the orderer was told.
        t_s: Control time.
    """
    outcome = text.partition(":")[0]
    if outcome not in _OUTCOMES:
        return None
    return LogLine(t_s, text, _OUTCOMES[outcome])


def refused_place(failure: Mapping[str, Any] | None) -> tuple[float, float, float] | None:
    """Where the pair of a refused motion would have touched, m, in the odometry frame; None where none told.

    Args:
        failure: A failure as JSON; the innermost finding of its chain counts.
    """
    place: tuple[float, float, float] | None = None
    while failure is not None:
        finding = failure.get("finding")
        if isinstance(finding, Mapping):
            told = finding.get("place_m")
            place = None if told is None else (float(told[0]), float(told[1]), float(told[2]))
        failure = failure.get("cause")
    return place


def refused_pair(failure: Mapping[str, Any] | None) -> tuple[str, ...]:
    """The names of what the checker found too near to each other; empty where no failure tells of any.

    Args:
        failure: A failure as JSON; the innermost finding of its chain counts.
    """
    pair: tuple[str, ...] = ()
    while failure is not None:
        finding = failure.get("finding")
        if isinstance(finding, Mapping) and "collision" in str(finding.get("kind", "")):
            pair = tuple(map(str, finding.get("subject", ())))
        failure = failure.get("cause")
    return pair
