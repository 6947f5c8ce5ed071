"""What the health monitor finds."""

from __future__ import annotations

from collections.abc import Container
from dataclasses import dataclass
from enum import Enum


class Ailment(Enum):
    """The kinds of things that can be wrong with the robot."""

    STUCK = "joint stuck"
    OFFLINE = "motor offline"
    WEAK = "motor weak"
    ENCODER_OFFSET = "encoder offset"
    GYRO_BIAS = "gyro bias"
    FOOT_CONTACT_LOST = "foot contact lost"
    BATTERY_LOW = "battery low"
    OVERRUNS = "control periods late"
    FALLEN = "fallen"


class Response(Enum):
    """What the control loop does about a finding."""

    STOP = "stop"
    """Brake and hold; no motion is taken while it lasts."""
    REFUSE = "refuse"
    """What is under way is finished; no new task is begun while it lasts."""
    LIMP = "limp"
    """The power is taken away: legs that go on walking on the floor hit what is there."""


RESPONSES = {
    Ailment.STUCK: Response.STOP,
    Ailment.OFFLINE: Response.STOP,
    Ailment.WEAK: Response.STOP,
    Ailment.ENCODER_OFFSET: Response.STOP,
    Ailment.GYRO_BIAS: Response.REFUSE,
    Ailment.FOOT_CONTACT_LOST: Response.STOP,
    Ailment.BATTERY_LOW: Response.REFUSE,
    Ailment.OVERRUNS: Response.REFUSE,
    Ailment.FALLEN: Response.LIMP,
}

_UNITS = {
    Ailment.STUCK: "rad",
    Ailment.OFFLINE: "Nm",
    Ailment.WEAK: "Nm",
    Ailment.ENCODER_OFFSET: "rad",
    Ailment.GYRO_BIAS: "rad/s",
    Ailment.FOOT_CONTACT_LOST: "N",
    Ailment.FALLEN: "rad",
}


@dataclass(frozen=True, slots=True)
class Finding:
    """One thing that was found to be wrong with the robot.

    Attributes:
        ailment: What.
        part: Which joint, sole or sensor.
        value: What was measured: the distance that a stuck joint did not follow, the effort that a motor
            does not give, the offset, the bias, the foot's force, the battery's charge, the share of late
            periods, how far the base leans.
        bound: What it had to keep to.
    """

    ailment: Ailment
    part: str
    value: float
    bound: float

    @property
    def response(self) -> Response:
        """What follows from it."""
        return RESPONSES[self.ailment]

    @property
    def key(self) -> tuple[Ailment, str]:
        """Equal for findings of the same thing."""
        return self.ailment, self.part

    def weakens(self, joints: Container[str]) -> bool:
        """Whether it is a motor of some joints that gives too little effort, or none."""
        return self.ailment in (Ailment.OFFLINE, Ailment.WEAK) and self.part in joints

    def __str__(self) -> str:
        unit = _UNITS.get(self.ailment, "")
        return f"{self.ailment.value}: {self.part} ({self.value:.3g} {unit}".rstrip() + (
            f", bound {self.bound:.3g})"
        )
