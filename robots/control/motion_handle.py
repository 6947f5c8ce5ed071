"""What the one who started a motion holds of it."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum


class MotionStatus(Enum):
    """Where a motion stands."""

    RUNNING = "running"
    DONE = "done"
    CANCELED = "canceled"
    REFUSED = "refused"


@dataclass(slots=True)
class MotionHandle:
    """A started motion; the streamer writes it, everyone else reads it.

    Attributes:
        name: What it is, for people.
        owner: Opaque id under which its setpoints pass the gate.
        status: Where it stands.
        progress: Share of its duration that has passed, 0 to 1.
        reason: Why it was refused or cancelled, with names and numbers; empty otherwise.
        met_something: Whether it was refused because the body pushed against something.
    """

    name: str
    owner: str
    status: MotionStatus = MotionStatus.RUNNING
    progress: float = 0.0
    reason: str = ""
    met_something: bool = False

    @property
    def finished(self) -> bool:
        """Whether it no longer runs."""
        return self.status is not MotionStatus.RUNNING
