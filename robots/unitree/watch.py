"""What is wrong with the wire, and what follows from it: damped, or standing on.

A wire can be silent, garbled, or somebody else's; a motor can tell an error. Each is a kind of its own with a
declared consequence, and none is left without one.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from enum import Enum
from typing import Protocol

import numpy as np

from robots.unitree.layout import Record, is_whole
from robots.unitree.motors import Motors

LATE_S = 0.02
"""A state that is older than this is late: it is told, and the robot goes on under what it was commanded."""
SILENT_S = 0.1
"""After this long the motors are damped: nobody knows where they are."""
LOST_S = 1.0
"""After this long the wire is lost: it stays damped until a person has looked, whatever comes."""


class Wire(Protocol):
    """Carries messages of one kind out and of another in; ``robots.unitree.dds`` is one over DDS."""

    def send(self, message: Record) -> None:
        """Send a command; it is never waited for."""
        ...

    def received(self) -> list[Record]:
        """The states that have come since the last call, oldest first; it is never waited for."""
        ...

    def wait(self, longest_s: float) -> None:
        """Wait for the next state, and no longer than so many seconds."""
        ...


class Trouble(Enum):
    """What can be wrong."""

    LATE = "late"
    SILENT = "silent"
    LOST = "lost"
    GARBLED = "garbled"
    WRONG_MODE = "wrong mode"
    MOTOR_ERROR = "motor error"
    HAND_SILENT = "hand silent"


class Consequence(Enum):
    """What becomes of the motors.

    Attributes:
        NONE: What is commanded goes out.
        STAND: The same, and no motion is taken any more: the robot brakes, stands, and its latch is engaged.
        DAMP: No stiffness and no effort, only damping, until it is over; then it is taken up where it is.
        DAMP_UNTIL_RESET: The same until a person resets.
    """

    NONE = "none"
    STAND = "stand"
    DAMP = "damp"
    DAMP_UNTIL_RESET = "damp until reset"


FOLLOWS = {
    Trouble.LATE: Consequence.NONE,
    Trouble.GARBLED: Consequence.NONE,
    Trouble.MOTOR_ERROR: Consequence.STAND,
    Trouble.HAND_SILENT: Consequence.STAND,
    Trouble.SILENT: Consequence.DAMP,
    Trouble.LOST: Consequence.DAMP_UNTIL_RESET,
    Trouble.WRONG_MODE: Consequence.DAMP_UNTIL_RESET,
}
"""The declared consequence of each, the mildest first. What is garbled counts as not having come; a hand
that is silent is damped itself, and the body stands."""


@dataclass(frozen=True, slots=True)
class WireFinding:
    """One thing that is wrong now.

    Attributes:
        trouble: Of which kind.
        told: In words, with numbers.
    """

    trouble: Trouble
    told: str

    def __str__(self) -> str:
        return f"wire {self.trouble.value}: {self.told}"


def by_gravity(found: Iterable[WireFinding]) -> tuple[WireFinding, ...]:
    """Findings in the order of what follows from them, the gravest last."""
    order = list(FOLLOWS)
    return tuple(sorted(found, key=lambda one: order.index(one.trouble)))


class WireWatch:
    """Judges what comes over the wire, and its absence.

    Attributes:
        garbled: How many messages had a wrong check sum.
        state: The newest whole message; None before the first.
    """

    def __init__(self, motors: Motors, names: tuple[str, ...], now_s: float) -> None:
        """Begin to wait.

        Args:
            motors: Those that the robot uses, shape (n,).
            names: Of their joints.
            now_s: The time.
        """
        self._motors, self._names = motors, names
        self._heard_s = now_s
        self._tick: int | None = None
        self._machine: int | None = None
        self._garbled_now = False
        self._latched: WireFinding | None = None
        self.garbled = 0
        self.state: Record | None = None

    @property
    def machine(self) -> int:
        """The robot's own mode, as its first message told it; commands copy it."""
        return 0 if self._machine is None else self._machine

    def hear(self, message: Record, now_s: float) -> bool:
        """Take a message; tell whether it is whole and new."""
        if not is_whole(message):
            self.garbled += 1
            self._garbled_now = True
            return False
        self._garbled_now = False
        tick = int(message["tick"])
        if self._tick is not None and tick == self._tick:
            return False  # the same state again is no sign of life
        self._tick, self._heard_s, self.state = tick, now_s, message
        if self._machine is None:
            self._machine = int(message["mode_machine"])
        return True

    def age_s(self, now_s: float) -> float:
        """How old the newest state is."""
        return now_s - self._heard_s

    def findings(self, now_s: float) -> tuple[WireFinding, ...]:
        """What is wrong now, the gravest last; what only a person ends stays."""
        found = [*self._by_age(self.age_s(now_s)), *self._by_content()]
        grave = [one for one in found if FOLLOWS[one.trouble] is Consequence.DAMP_UNTIL_RESET]
        if grave and self._latched is None:
            self._latched = grave[-1]
        if self._latched is not None and self._latched not in found:
            found.append(self._latched)
        return by_gravity(found)

    def reset(self, now_s: float) -> str | None:
        """Forget what only a person ends; or say why not: what is so still."""
        held, self._latched = self._latched, None
        now = [one for one in self.findings(now_s) if FOLLOWS[one.trouble] is not Consequence.NONE]
        if now:
            self._latched = held
            return str(now[-1])
        return None

    def _by_age(self, age_s: float) -> list[WireFinding]:
        bounds = ((LOST_S, Trouble.LOST), (SILENT_S, Trouble.SILENT), (LATE_S, Trouble.LATE))
        for bound_s, trouble in bounds:
            if age_s > bound_s:
                return [WireFinding(trouble, f"no state for more than {bound_s:g} s")]
        return []

    def _by_content(self) -> list[WireFinding]:
        found = []
        if self._garbled_now:
            found.append(WireFinding(Trouble.GARBLED, "the check sum of the last message was wrong"))
        if self.state is None:
            return found
        machine, series = int(self.state["mode_machine"]), int(self.state["mode_pr"])
        if machine != self.machine:
            found.append(
                WireFinding(Trouble.WRONG_MODE, f"mode_machine is {machine}, and was {self.machine}")
            )
        if series != 0:
            found.append(
                WireFinding(Trouble.WRONG_MODE, f"mode_pr is {series}, and joints are commanded in 0")
            )
        errors = self.state["motor"]["motorstate"][self._motors]
        found += [
            WireFinding(Trouble.MOTOR_ERROR, f"{self._names[k]}, code {int(errors[k])}")
            for k in np.flatnonzero(errors).tolist()
        ]
        return found
