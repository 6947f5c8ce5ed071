"""Why a setpoint was not let through."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum


class Limit(Enum):
    """What a setpoint is judged by."""

    POSITION = "position limit"
    VELOCITY = "velocity limit"
    EFFORT = "effort limit"
    ACCELERATION = "acceleration limit"
    JUMP = "jump"
    NOT_FINITE = "not a finite number"
    SHAPE = "number of joints"
    AGE = "age"
    SEQUENCE = "sequence"
    OWNER = "owner"
    MEASURED_EFFORT = "measured effort"
    DURATION = "duration"
    CONTACT = "unexpected contact"
    FORCE = "unexpected force"
    COLLISION = "collision"
    BALANCE = "balance"
    STANCE = "stance"
    REACH = "reach"
    DEFECT = "defect"


_UNMEASURED = (Limit.DEFECT, Limit.COLLISION, Limit.REACH)
"""Those that are there or not: no number tells how much."""

_UNITS = {
    Limit.POSITION: "rad",
    Limit.VELOCITY: "rad/s",
    Limit.EFFORT: "Nm",
    Limit.ACCELERATION: "rad/s^2",
    Limit.JUMP: "rad",
    Limit.AGE: "s",
    Limit.MEASURED_EFFORT: "Nm",
    Limit.DURATION: "s",
    Limit.CONTACT: "Nm",
    Limit.FORCE: "N",
    Limit.BALANCE: "m",
    Limit.STANCE: "rad",
}


@dataclass(frozen=True, slots=True)
class Refusal:
    """One refused setpoint.

    Attributes:
        limit: What it broke.
        joint: Which joint, or who, where no joint is to blame.
        value: What was asked for.
        bound: What it had to keep to.
    """

    limit: Limit
    joint: str
    value: float
    bound: float

    def __str__(self) -> str:
        if self.limit in _UNMEASURED:
            return f"{self.limit.value} of {self.joint}"
        if self.limit is Limit.NOT_FINITE:
            return f"{self.joint} is {self.value:g}, {self.limit.value}"
        unit = _UNITS.get(self.limit, "")
        asked, allowed = f"{self.value:.6g} {unit}".rstrip(), f"{self.bound:.6g} {unit}".rstrip()
        return f"{self.limit.value} of {self.joint}: {asked}, allowed {allowed}"
