"""What the control layer tells: frozen values, put into a sink."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class MotionStarted:
    """A motion began to be streamed."""

    t_s: float
    motion: str
    owner: str


@dataclass(frozen=True, slots=True)
class MotionEnded:
    """A motion ended: done, canceled or refused."""

    t_s: float
    motion: str
    owner: str
    status: str
    reason: str


@dataclass(frozen=True, slots=True)
class MotionPaused:
    """What is under way brakes and waits."""

    t_s: float
    reason: str


@dataclass(frozen=True, slots=True)
class MotionResumed:
    """What was paused goes on."""

    t_s: float


@dataclass(frozen=True, slots=True)
class SetpointRefused:
    """The gate or the online checker refused a setpoint; a stop profile follows."""

    t_s: float
    owner: str
    limit: str
    joint: str
    value: float
    bound: float


@dataclass(frozen=True, slots=True)
class StopStarted:
    """A stop profile took the loop over."""

    t_s: float
    category: int
    reason: str


@dataclass(frozen=True, slots=True)
class EmergencyStopped:
    """The emergency stop was engaged; nothing moves the robot until a person's reset."""

    t_s: float
    category: int
    reason: str


@dataclass(frozen=True, slots=True)
class EmergencyReset:
    """A person left the emergency stop."""

    t_s: float
    person: str


@dataclass(frozen=True, slots=True)
class ResetRefused:
    """A person's reset was refused; the emergency stop stays engaged."""

    t_s: float
    person: str
    reason: str


@dataclass(frozen=True, slots=True)
class HealthChanged:
    """Something is wrong with the robot from now on, or no longer."""

    t_s: float
    ailment: str
    part: str
    value: float
    bound: float
    response: str
    present: bool


ControlEvent = (
    MotionStarted
    | MotionEnded
    | MotionPaused
    | MotionResumed
    | SetpointRefused
    | StopStarted
    | EmergencyStopped
    | EmergencyReset
    | ResetRefused
    | HealthChanged
)
ControlSink = Callable[[ControlEvent], None]
